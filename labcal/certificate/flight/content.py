"""What of a calibration flies: its map, the effects that hold on any clock, one covariance of both; and what stays."""

from __future__ import annotations

from dataclasses import dataclass, replace
from hashlib import sha256

import numpy as np
from numpy.typing import NDArray

from labcal.certificate.signing import Verification
from labcal.errors import InputError
from labcal.model import Calibration, EffectRecord
from labcal.model.apply import is_u_known, left_out_variance, misfit_variance, reading_noise
from labcal.model.effects import Fitted, load_shipped
from labcal.model.seen import Seen

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Flown:
    """One effect that flies: its place in the file, its record, its form; where its parameters stand among all."""

    place: int
    record: EffectRecord
    effect: Fitted
    first: int  # of its parameters in the covariance

    @property
    def said(self) -> str:
        """For people."""
        channels = f" of {', '.join(self.record.channels)}" if self.record.channels else ""
        return f"effects[{self.place}]: {self.record.effect}{channels}"


@dataclass(frozen=True, slots=True, eq=False)
class Content:
    """A calibration as it flies; `status` is one sentence of its signatures."""

    calibration: Calibration
    sha256: str  # of the file's bytes
    status: str
    effects: tuple[Flown, ...]
    left_out: tuple[EffectRecord, ...]  # bound to the run
    left_out_nT: Array  # (k, 3) what each of these leaves to the uncertainty, rms of each component

    @property
    def covariance(self) -> Array:
        """Of K row by row, k, and the parameters of the effects that fly (p, p)."""
        places = list(range(12))
        at = 12
        flown = {one.place for one in self.effects}
        for place, record in enumerate(self.calibration.effects):
            if place in flown:
                places += range(at, at + len(record.parameters))
            at += len(record.parameters)
        return self.calibration.joint_covariance()[np.ix_(places, places)]

    @property
    def constant_nT2(self) -> Array:
        """Variance (3,) that every field has: noise, what the run's residuals keep, and what is left out."""
        calibration = self.calibration
        per_unit = calibration.affine.K / calibration.dut.nominal_nT_per_unit
        noise = reading_noise(calibration) ** 2 * np.sum(per_unit**2, axis=1)
        misfit = misfit_variance(calibration, float(np.sqrt(noise.sum())))
        if not is_u_known(calibration):
            return np.full(3, np.nan)
        return np.asarray(noise + misfit + np.sum(self.left_out_nT**2, axis=0))

    @property
    def axes(self) -> Array:
        """The sensor's own axes (3, 3): column i moves with reading i."""
        return np.asarray(self.calibration.affine.K / self.calibration.dut.nominal_nT_per_unit)

    @property
    def lag_s(self) -> float:
        """How much earlier than its reading a field is."""
        return sum(float(one.effect.beta[0]) for one in self.effects if stamps(one.effect))


def content_of(calibration: Calibration, content: bytes, status: str) -> Content:
    """What flies of `calibration`, whose file has the bytes `content`. Raises InputError: an effect is not whole."""
    effects, left_out, first = list[Flown](), list[EffectRecord](), 12
    for place, record in enumerate(calibration.effects):
        try:
            effect = load_shipped(record)
        except InputError as error:
            raise InputError(f"effects[{place}]: {error.what}") from None
        if effect.family.is_bound_to_run(effect.term):
            left_out.append(record)
            continue
        effects.append(Flown(place, record, effect, first))
        first += len(record.parameters)
    sizes = [left_out_variance(calibration, one, load_shipped(one), Seen()) for one in left_out]
    rms = np.sqrt(np.array(sizes)) if sizes else np.zeros((0, 3))
    return Content(calibration, sha256(content).hexdigest(), status, tuple(effects), tuple(left_out), rms)


def said_of(found: Verification) -> str:
    """What the signatures of a file are, in one sentence."""
    if found.status == "unsigned":
        return "UNSIGNED: nobody stands for it"
    if found.status == "invalid":
        return f"NOT VALID: {next(iter(found.faults()), 'its run gives another')}"
    text = f"{found.status.upper()}: signed by {', '.join(found.signers)}"
    why = found.provisional if found.status == "provisional" else None
    return f"{text} ({why})" if why else text


def stamps(effect: Fitted) -> bool:
    """Whether the effect says when a reading's field was, and nothing else."""
    return effect.term.found_by("own secant") is not None


def without_lag(calibration: Calibration) -> Calibration:
    """The same with every lag zero, its uncertainty as it is."""
    return replace(calibration, effects=tuple(map(_at_once, calibration.effects)))


def _at_once(record: EffectRecord) -> EffectRecord:
    effect = load_shipped(record)
    if not stamps(effect):
        return record
    own = effect.term.parameters[0][0]
    return replace(record, parameters=tuple(replace(p, value=0.0) if p.name == own else p for p in record.parameters))
