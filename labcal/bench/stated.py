"""What the bench states of its reference and its room, for the record and for what procedures judge by them."""

from __future__ import annotations

from dataclasses import replace
from datetime import date

import numpy as np
from numpy.typing import ArrayLike, NDArray

from labcal.bench.bench import Bench
from labcal.errors import InputError
from labcal.record import Administrative, Dut, Reference, Run, Segment
from labcal.record.vector import Vector

Array = NDArray[np.float64]


def stated_reference(bench: Bench, serial: str = "") -> Reference:
    """The reference as it is stated; where it is carried to the DUT, with the uncertainty of that."""
    config = bench.reference_stated
    certificate = None if config.certificate is None else config.certificate.model_dump(exclude_none=True)
    return Reference(
        kind=bench.reference_kind,
        serial=serial,
        noise_nT=config.noise_nT,
        place=config.place,
        position_m=config.position_m,
        u_scale_ppm=config.u_scale_ppm,
        u_offset_nT=config.u_offset_nT,
        u_align_deg=config.u_align_deg,
        u_time_s=config.u_time_s,
        calibration=config.calibration,
        tc_ppm_per_K=config.tc_ppm_per_K,
        u_tc_ppm_per_K=config.u_tc_ppm_per_K,
        tc_nT_per_K=config.tc_nT_per_K,
        u_tc_nT_per_K=config.u_tc_nT_per_K,
        drift_nT_per_year=config.drift_nT_per_year,
        u_drift_nT_per_year=config.u_drift_nT_per_year,
        certificate=certificate,
    )


def stated_environment(bench: Bench) -> dict[str, float] | None:
    """The room and the gradients; None where nothing is stated."""
    return bench.config.environment.model_dump(exclude_none=True) or None


def stated_administrative(bench: Bench) -> Administrative | None:
    """What the bench states for a certificate; None where nothing is stated."""
    config = bench.config
    stated = Administrative(config.laboratory, config.customer, config.dut.item, config.equipment)
    return None if stated == Administrative() else stated


def refuse_overdue(bench: Bench) -> None:
    """Raise InputError where the reference's certificate says that its calibration was due before today."""
    certificate, today = bench.config.reference.certificate, bench.clock.utc().date()
    if certificate is None or certificate.due is None or date.fromisoformat(certificate.due) >= today:
        return
    number = f" {certificate.number}" if certificate.number else ""
    message = f"the reference is overdue: its calibration{number} was due {certificate.due}, and today is {today}"
    raise InputError(f"{message}. No procedure begins on this bench: calibrate it, then state its new certificate")


def as_positions(
    bench: Bench, reference_nT: ArrayLike, body_from_cage: ArrayLike | None = None, u_mounting_deg: float = 0.0
) -> Run:
    """Standstills as a run, for what its declarations do to them: the reference (n, 3) [nT, C] in each, no readings.

    Of a scalar reference its magnitude (n,) [nT]. It counts as a reference where it stands, also where nothing carries
    its field to the DUT.

    `body_from_cage` (n, 3, 3) are the DUT's attitudes, `u_mounting_deg` how well its axes are known in its body; 0 is
    not stated. Where no attitude is stated, nothing hangs on the platform's axis.
    """
    field = np.asarray(reference_nT, dtype=float)
    n = len(field)
    attitudes = [None] * n if body_from_cage is None else [tuple(map(_vector, R)) for R in np.asarray(body_from_cage)]
    u_cage = None if body_from_cage is None else bench.config.platform.u_axis_cage_deg
    return Run(
        run_id="positions",
        started_utc=bench.clock.utc().isoformat(),
        simulated=bench.config.unreal,
        operator="",
        dut=Dut(bench.config.dut.serial),
        reference=replace(stated_reference(bench), kind=bench.config.reference.kind),
        segments=tuple(
            Segment(str(i), "static", body_from_cage=R, u_axis_body_deg=u_mounting_deg or None, u_axis_cage_deg=u_cage)  # type: ignore[arg-type]
            for i, R in enumerate(attitudes)
        ),
        t_s=np.arange(n, dtype=float),
        segment_index=np.arange(n, dtype=np.intp),
        reading=np.zeros((n, 3)),
        reference_vector=field.copy() if field.ndim == 2 else None,
        reference_magnitude=field.copy() if field.ndim == 1 else None,
        environment=stated_environment(bench),
    )


def _vector(row: Array) -> Vector:
    x, y, z = row.tolist()
    return x, y, z
