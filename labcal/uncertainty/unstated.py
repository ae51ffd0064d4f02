"""What a run leaves open about its reference and its mounting, in words: none of it is in any uncertainty."""

from __future__ import annotations

from labcal.record import Reference, Run

ALL_COVERED = "All that the run states of its reference and mounting is covered."


def not_stated(run: Run) -> tuple[str, ...]:
    """One sentence each for the reference, the mounting and the angle; never empty."""
    if run.reference.kind == "none":
        return ("The field itself: there is no reference.",)
    said = []
    if left := _of_the_reference(run.reference):
        said.append(f"Of the reference, because the run does not state it: {', '.join(left)}.")
    if any(segment.u_axis_body_deg is None for segment in run.segments if segment.axis_body is not None):
        said.append("Frame as mounted; mounting uncertainty not included.")
    return tuple(said) or (ALL_COVERED,)


def not_covered(run: Run) -> tuple[str, ...]:
    """What the uncertainties of this run's results do not cover, one sentence each."""
    if run.reference.kind == "none":
        return not_stated(run)
    said = list(not_stated(run))
    if said == [ALL_COVERED]:
        said = []
    if run.reference.place != "dut":
        said.append("The field's gradient between the reference and the device.")
    said.append("The reference's temperature, and its drift since its own calibration.")
    return tuple(said)


def _of_the_reference(reference: Reference) -> list[str]:
    stated = {
        "noise": reference.noise_nT,
        "scale": reference.u_scale_ppm,
        "zero": reference.u_offset_nT,
        "alignment": reference.u_align_deg if reference.kind == "vector" else 0.0,
        "time": reference.u_time_s,
        "own calibration": reference.calibration,
    }
    return [word for word, value in stated.items() if value is None]
