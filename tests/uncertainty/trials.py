"""Trials of stated uncertainties: a run wrong by draws of what it declares, its calibration, fresh readings, errors."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import wrong_lab
from twin_lab import record as record_of_twin
from wrong_lab import Declared, Recorded

from labcal.fit import Fit, draft_calibration
from labcal.loop.close import close_loop, prepare
from labcal.loop.selection.joint_fit import joint_fit
from labcal.loop.uncertainty import of_the_file, uncertainty_of
from labcal.model import Calibration, EffectRecord
from labcal.model.apply import apply, linearised, misfit_variance, reading_noise
from labcal.model.effects import family
from labcal.model.readings import Readings
from labcal.record import Channel, Dut, Reference, Run, Segment

HALF_WIDTH = 1.959964  # of a 95 % interval, in standard uncertainties
DECLARED = Declared(scale_ppm=400.0, zero_nT=30.0, body_deg=0.25)
KINDS = ("vector", "axis", "scalar")


@dataclass(frozen=True)
class Trial:
    """One run's errors on fresh readings over their stated standard uncertainty."""

    z: np.ndarray
    verdict: str = ""  # of the loop, where it was asked
    named: bool = True  # the effect at work, among those accepted or their rivals

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
        channels=(
            Channel("i_eps", "A", "current", found.current_A),
            Channel("temp_dut", "degC", "temperature", found.warm_C),
        ),
    )


def trial(seed: int, kind: str, *, effect: str, twin: bool, declared: Declared = DECLARED) -> Trial:
    """One run of one kind of reference, by the twin or by the independent lab; the effect at work is told."""
    found, run = recorded(seed, kind, effect=effect, twin=twin, declared=declared)
    return _judged(calibrated(run, effect=effect), found, run, seed)


def trial_of_the_loop(seed: int, kind: str, *, effect: str, twin: bool) -> Trial:
    """The same as `labcal close-loop` writes it: the loop is told nothing, and whatever its verdict is counts."""
    found, run = recorded(seed, kind, effect=effect, twin=twin)
    closed = close_loop(run)
    calibration = draft_calibration(run, closed.fit(), "0" * 64)
    named = effect in {name for e in closed.accepted for name in (e.effect, *(r.effect for r in e.rivals))}
    return replace(_judged(calibration, found, run, seed), verdict=closed.verdict, named=named or effect == "none")


def recorded(seed: int, kind: str, *, effect: str, twin: bool, declared: Declared = DECLARED) -> tuple[Recorded, Run]:
    """What one of the two labs recorded, and the run that labcal is told."""
    declared = replace(declared, kind="scalar" if kind == "scalar" else "vector")
    found = (record_of_twin if twin else wrong_lab.record)(seed, declared, effect=effect, rows=24)
    return found, as_run(found, angles=kind != "axis")


def calibrated(run: Run, *, effect: str) -> Calibration:
    """As the loop ships it once it has found the effect that is at work, or none: selection is not on trial here."""
    terms = [] if effect == "none" else [family(effect).candidates(run)[0]]
    found = joint_fit(prepare(run)[0], terms)
    uncertain = uncertainty_of(found)
    joint, parameters = of_the_file(found, uncertain, [True] * len(terms)), found.parameters(uncertain.covariance)
    effects = tuple(
        EffectRecord(effect, term.channels, dict(term.reference_value), "sensor", stated)
        for term, stated in zip(terms, parameters, strict=True)
    )
    problem = found.problem
    fit = Fit("closed-loop", True, affine=problem.affine, covariance=joint.covariance, covariance_of=joint.names,
              frame_known=problem.kind == "vector" or run.reference.kind == "vector", effects=effects,
              noise_nT=problem.noise.reading, sources=joint.sources)  # fmt: skip
    return draft_calibration(run, fit, "0" * 64)


def _judged(calibration: Calibration, found: Recorded, run: Run, seed: int) -> Trial:
    """Errors on fresh readings; their times lie inside the run's span, where an effect of the run's clock holds."""
    reading, channels, true = found.fresh(seed, noise_nT=found.noise_nT)
    n = len(reading)
    rows = Readings(reading, t_s=np.linspace(run.t_s[0], run.t_s[-1], n), segment=np.zeros(n, dtype=np.intp),
                    mode=run.mode[:1].repeat(n), channels=channels)  # fmt: skip
    if run.reference.kind == "scalar":
        return Trial(_magnitude_errors(calibration, rows, true))
    applied = apply(calibration, rows)
    return Trial((applied.field_nT - true) / applied.u_nT[:, None])


def _magnitude_errors(calibration: Calibration, rows: Readings, true: np.ndarray) -> np.ndarray:
    """Errors of |b| (n, 1) over their uncertainty: of a free frame nothing else can be compared."""
    field, slopes = linearised(calibration, rows)
    along = field / np.linalg.norm(field, axis=1)[:, None]
    J = np.einsum("na,nap->np", along, slopes)
    through = np.linalg.norm(along @ calibration.affine.K, axis=1)
    noise = reading_noise(calibration)
    u2 = np.sum(J @ calibration.joint_covariance() * J, axis=1) + (noise * through) ** 2
    u2 += misfit_variance(calibration, noise * float(np.linalg.norm(calibration.affine.K)))
    return ((np.linalg.norm(field, axis=1) - np.linalg.norm(true, axis=1)) / np.sqrt(u2))[:, None]
