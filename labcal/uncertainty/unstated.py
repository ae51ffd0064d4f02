"""What a run leaves open about its reference and its mounting, in words: none of it is in any uncertainty."""

from __future__ import annotations

from labcal.record import Run, Segment
from labcal.uncertainty import conditions

ALL_COVERED = "All that the run states of its reference and mounting is covered."


def not_stated(run: Run) -> tuple[str, ...]:
    """One sentence each for the reference, the mounting and the angle; never empty."""
    if run.reference.kind == "none":
        return ("The field itself: there is no reference.",)
    said = []
    if left := _of_the_reference(run):
        said.append(f"Of the reference, because the run does not state it: {', '.join(left)}.")
    if exact := [word for word, value in _stated(run).items() if value == 0 and word != "noise"]:
        said.append(f"Of the reference, because the run states it as 0: {', '.join(exact)}.")  # nothing is exact
    if not all(segment.u_axis_body_deg for segment in run.segments if _mounted(segment)):
        said.append("Frame as mounted; mounting uncertainty not included.")
    if not all(segment.u_axis_cage_deg for segment in run.segments if _about_an_axis_of_the_cage(run, segment)):
        said.append("The direction of the platform's axis in the cage.")
    return tuple(said) or (ALL_COVERED,)


def _mounted(segment: Segment) -> bool:
    """Whether its frame is that of a mounting: by an axis of the body, or by an attitude in the cage."""
    return segment.axis_body is not None or (segment.body_from_cage is not None and segment.reference_frame == "cage")


def _about_an_axis_of_the_cage(run: Run, segment: Segment) -> bool:
    """Whether the reference is carried into the body about an axis that stands in the cage."""
    return run.reference.kind == "vector" and segment.axis_cage is not None and segment.reference_frame == "cage"


def not_covered(run: Run) -> tuple[str, ...]:
    """What the uncertainties of this run's results do not cover, one sentence each."""
    if run.reference.kind == "none":
        return not_stated(run)
    said = list(not_stated(run))
    if said == [ALL_COVERED]:
        said = []
    if _gradient_open(run):
        said.append("The field's gradient between the reference and the device.")
    if left := _since_its_certificate(run):
        said.append(f"The reference's {', and its '.join(left)}.")
    return tuple(said) or (ALL_COVERED,)


def _gradient_open(run: Run) -> bool:
    """Whether reference and device are, or may be, apart, and nothing says what the field does between them."""
    stated = run.environment or {}
    known = "gradient_nT_per_m" in stated and "gradient_ppm_per_m" in stated
    apart = conditions.distance_m(run) > 0 or (run.reference.position_m is None and run.reference.place != "dut")
    return run.reference.place == "remote" or (apart and not (known and run.reference.position_m))


def _since_its_certificate(run: Run) -> list[str]:
    """What is not known of the reference since its own calibration: neither a coefficient nor what it acts on."""
    reference = run.reference
    coefficients = (
        conditions.whole(reference.tc_ppm_per_K, reference.u_tc_ppm_per_K),
        conditions.whole(reference.tc_nT_per_K, reference.u_tc_nT_per_K),
    )
    left = [] if all(coefficients) and conditions.warmer_K(run) is not None else ["temperature"]
    drift = conditions.whole(reference.drift_nT_per_year, reference.u_drift_nT_per_year)
    return left if drift and conditions.years_since(run) is not None else [*left, "drift since its own calibration"]


def _of_the_reference(run: Run) -> list[str]:
    return [word for word, value in _stated(run).items() if value is None]


def _stated(run: Run) -> dict[str, object]:
    """What the run states of its reference, by the word for it; None where it does not, nothing where it need not."""
    reference, times = run.reference, [segment.u_time_s for segment in run.segments]
    stated: dict[str, object] = {
        "noise": reference.noise_nT,
        "scale": reference.u_scale_ppm,
        "zero": reference.u_offset_nT,
    }
    if reference.kind == "vector":
        stated["alignment"] = reference.u_align_deg
    each_for_itself = bool(times) and all(time is not None for time in times)
    stated["time"] = max(time or 0.0 for time in times) if each_for_itself else reference.u_time_s
    stated["own calibration"] = reference.calibration or reference.certificate
    return stated
