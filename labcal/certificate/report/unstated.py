"""What a run leaves open about its reference and its mounting, in words: none of it is in any uncertainty."""

from __future__ import annotations

from labcal.record import Reference, Run


def not_stated(run: Run) -> tuple[str, ...]:
    """One sentence each for the reference, the mounting and the angle; never empty."""
    if run.reference.kind == "none":
        return ("The field itself: there is no reference.",)
    said = []
    if left := _of_the_reference(run.reference):
        said.append(f"Of the reference, because the run does not state it: {', '.join(left)}.")
    if any(segment.u_axis_body_deg is None for segment in run.segments if segment.axis_body is not None):
        said.append("Frame as mounted; mounting uncertainty not included.")
    return tuple(said) or ("All that the run states of its reference and mounting is covered.",)


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
