"""Trials of stated uncertainties: a run wrong by draws of what it declares, its calibration, fresh readings, errors."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import wrong_lab
from twin_lab import record as record_of_twin
from wrong_lab import Declared, Recorded

from labcal.fit import Fit, draft_calibration
from labcal.loop.close import prepare
from labcal.loop.selection.joint_fit import joint_fit
from labcal.loop.uncertainty import of_the_file, uncertainty_of
from labcal.model import Calibration, EffectRecord
from labcal.model.affine import jacobian
from labcal.model.effects import family
from labcal.record import Channel, Dut, Reference, Run, Segment

HALF_WIDTH = 1.959964  # of a 95 % interval, in standard uncertainties
DECLARED = Declared(scale_ppm=400.0, zero_nT=30.0, body_deg=0.25)
KINDS = ("vector", "axis", "scalar")


@dataclass(frozen=True)
class Trial:
    """One run's errors on fresh readings over their stated standard uncertainty."""

    z: np.ndarray

    @property
    def covered(self) -> float:
        """The share of the 95 % intervals that hold the truth."""
        return float(np.mean(np.abs(self.z) < HALF_WIDTH))

    @property
    def square(self) -> float:
        """The mean square: one, on the mean of many runs, where the uncertainty is true."""
        return float(np.mean(self.z**2))


def as_run(found: Recorded, *, angles: bool = True) -> Run:
    """What labcal is told of a recording."""
    d = found.declared
    vector = d.kind == "vector"
    stated = {"u_scale_ppm": d.scale_ppm, "u_offset_nT": d.zero_nT, "u_align_deg": d.align_deg if vector else None}
    segments = tuple(Segment(**{**s, "u_axis_body_deg": d.body_deg}) for s in found.segments)
    return Run(
        run_id="made",
        started_utc="2026-05-01T00:00:00Z",
        simulated=True,
        operator="",
        dut=Dut("P1", noise_nT=found.noise_nT),
        reference=Reference(d.kind, "R", noise_nT=wrong_lab.REFERENCE_NOISE_nT, place="dut", **stated),
        segments=segments,
        t_s=found.t_s,
        segment_index=found.segment.astype(np.intp),
        reading=found.reading,
        reference_vector=found.reference if vector else None,
        reference_magnitude=None if vector else np.linalg.norm(found.reference, axis=1),
        angle_deg=found.angle_deg if vector and angles else None,
        channels=(Channel("i_eps", "A", "current", found.current_A),),
    )


def trial(seed: int, kind: str, *, coupled: bool, twin: bool, declared: Declared = DECLARED) -> Trial:
    """One run of one kind of reference, by the twin or by the independent lab, with or without an effect at work."""
    declared = replace(declared, kind="scalar" if kind == "scalar" else "vector")
    found = (record_of_twin if twin else wrong_lab.record)(seed, declared, coupled=coupled, rows=24)
    calibration = calibrated(as_run(found, angles=kind != "axis"), coupled=coupled)
    reading, current, true = found.fresh(seed, noise_nT=found.noise_nT)
    applied = calibration.apply(reading, channels={"i_eps": current})
    if kind != "scalar":
        return Trial((applied.field_nT - true) / applied.u_nT[:, None])
    return Trial(_magnitude_errors(calibration, reading, current, applied.field_nT, true))


def calibrated(run: Run, *, coupled: bool) -> Calibration:
    """As the loop ships it once it has found the effect that is at work, or none: selection is not on trial here."""
    kind = family("offset-current")
    terms = list(kind.candidates(run))[:1] if coupled else []
    found = joint_fit(prepare(run)[0], terms)
    uncertain = uncertainty_of(found)
    joint, parameters = of_the_file(found, uncertain, [True] * len(terms)), found.parameters(uncertain.covariance)
    effects = tuple(
        EffectRecord(kind.id, term.channels, dict(term.reference_value), "sensor", stated)
        for term, stated in zip(terms, parameters, strict=True)
    )
    problem = found.problem
    fit = Fit("closed-loop", True, affine=problem.affine, covariance=joint.covariance, covariance_of=joint.names,
              frame_known=problem.kind == "vector" or run.reference.kind == "vector", effects=effects,
              noise_nT=problem.noise.reading, sources=joint.sources)  # fmt: skip
    return draft_calibration(run, fit, "0" * 64)


def _magnitude_errors(
    calibration: Calibration, reading: np.ndarray, current: np.ndarray, field: np.ndarray, true: np.ndarray
) -> np.ndarray:
    """Errors of |b| over their uncertainty: of a free frame nothing else can be compared."""
    along = field / np.linalg.norm(field, axis=1)[:, None]
    J = [np.einsum("na,nap->np", along, jacobian(reading)), *(-along * current[:, None],) * bool(calibration.effects)]
    if calibration.effects:
        (reference_A,) = calibration.effects[0].reference_value.values()
        J[1] = -along * (current - reference_A)[:, None]
    J = np.concatenate(J, axis=1)
    noise = calibration.metrics["after"]["noise_nT"] * np.linalg.norm(along @ calibration.affine.K, axis=1)
    u = np.sqrt(np.sum(J @ calibration.joint_covariance() * J, axis=1) + noise**2)
    return (np.linalg.norm(field, axis=1) - np.linalg.norm(true, axis=1)) / u
