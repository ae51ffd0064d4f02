"""What the loop found (contract: close-loop JSON)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from labcal.fit import Fit
from labcal.model import AffineMap, EffectRecord
from labcal.model.affine import MAP_PARAMETERS
from labcal.model.calibration import UNEXPLAINED
from labcal.model.effects import Confounded
from labcal.model.records import Owner
from labcal.uncertainty import Sources
from labcal.uncertainty.conformity import Assessment

Array = NDArray[np.float64]
Verdict = Literal["clean", "explained", "partly-explained", "ambiguous", "unexplained"]
FORMAT = "labcal-closed-loop/1"


@dataclass(frozen=True, slots=True)
class Errors:
    """Rms in sample and on held-out blocks [nT]."""

    train_rms_nT: float
    holdout_rms_nT: float


@dataclass(frozen=True, slots=True)
class NextExperiment:
    """What would separate equivalent explanations, or show what the structure is."""

    why: str
    do: str
    procedure: str | None = None
    ranking: tuple[Ranked, ...] = ()  # what the lab can do, what separates most first
    settings: Mapping[str, str] = field(default_factory=dict)  # with which the procedure does that


@dataclass(frozen=True, slots=True)
class Ranked:
    """An experiment, and how far apart it would bring the explanations [standard deviations]."""

    do: str
    procedure: str | None
    sigma: float
    settings: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class ResidualTest:
    """One test of a residual: what it is about, the number, how often chance gives as much, and a few words."""

    test: Literal["whiteness", "independence", "lack-of-fit"]
    of: str
    statistic: float
    p_value: float
    share: float  # of the residual's square, or of its component's that it is seen on
    passes: bool  # chance, or not material
    says: str


@dataclass(frozen=True, slots=True)
class ResidualShape:
    """The shape of structure that no known effect explains."""

    kind: str  # line | step | telegraph | random-walk | wander | noise
    axis: str
    period_s: float | None
    steps_s: tuple[float, ...]
    field_nT: tuple[float, float] | None  # where most of it is, if anywhere
    angle_deg: tuple[float, float] | None
    says: str


@dataclass(frozen=True, slots=True)
class Finding:
    """Something about the data or the lab that is not an effect of the list, for people: its kind and a sentence."""

    kind: str
    belongs_to: Owner
    says: str


@dataclass(frozen=True, slots=True)
class Round:
    """A run that the loop asked for, and the verdict with its rows added."""

    procedure: str
    run_id: str
    verdict: Verdict


@dataclass(frozen=True, slots=True, eq=False)
class Pictures:
    """Residuals for the report, over the rows used (n,): in sample, and on held-out blocks."""

    t_s: Array
    segment: NDArray[np.intp]
    before_nT: Array  # (n, 3), or (n, 1) of the magnitude
    after_nT: Array
    held_out_nT: Array | None = None  # (n, 2) lengths before and after by fits that did not see the row; else NaN


@dataclass(frozen=True, slots=True, eq=False)
class ClosedLoop:
    """The verdict and all that it rests on."""

    run_id: str
    residual_kind: Literal["vector", "scalar"]
    base: Literal["affine", "gain-offset", "offset"]
    noise_floor_nT: float
    noise_floor_source: Literal["declared", "static", "differences"]
    before: Errors
    after: Errors
    set_aside: Mapping[str, int]
    accepted: tuple[EffectRecord, ...]
    rejected: tuple[EffectRecord, ...]
    verdict: Verdict
    summary: str
    next_experiment: NextExperiment | None
    affine: AffineMap  # with the effects that are shipped
    covariance: Array | None  # (p, p) of K row by row, then k, then what `covariance_of` names of the effects shipped
    frame_known: bool
    noise_nT: float  # standard deviation of one axis of one reading
    pictures: Pictures
    noise_beside_readings_nT: float = 0.0  # of reference, angle and time in what the rms is over
    findings: tuple[Finding, ...] = ()
    tests: Mapping[str, tuple[ResidualTest, ...]] = field(default_factory=dict)  # before, after
    shape: ResidualShape | None = None  # of what is left, where structure is left
    unsupported: frozenset[int] = frozenset()  # places among `accepted` of the sensor's effects that are not shipped
    shipped: Errors | None = None  # of the map and effects that are shipped, where they are fewer
    twins: tuple[Confounded, ...] = ()  # of the accepted effects
    rounds: tuple[Round, ...] = ()  # measured since the first verdict
    remarks: tuple[str, ...] = ()  # the residual's tests and the findings, in words
    covariance_of: tuple[str, ...] = MAP_PARAMETERS
    conformity: Assessment | None = None  # of what is shipped, where the run has a specification
    sources: Sources | None = None  # what `covariance` is made of
    beside_declared_nT: float | None = None  # held out, of what is shipped, beside errors that the run declares
    proposed: tuple[EffectRecord, ...] = ()  # an empirical term that nobody asked to be shipped

    @property
    def done(self) -> bool:
        """Whether the loop closed: exit code 0."""
        return self.verdict in ("clean", "explained")

    def fit(self) -> Fit:
        """The calibration found, as every estimator states it: map, covariance and accepted effects."""
        return Fit(
            method="closed-loop",
            ok=True,
            affine=self.affine,
            covariance=self.covariance,
            covariance_of=self.covariance_of,
            sources=self.sources,
            frame_known=self.frame_known,
            effects=tuple(e for i, e in enumerate(self.accepted) if i not in self.unsupported),
            noise_nT=self.noise_nT,
            remarks=self._remarks(),
            metrics=self.metrics(),
        )

    def _remarks(self) -> tuple[str, ...]:
        if self.verdict != "unexplained":
            return ()
        left = f"{self.after.holdout_rms_nT:.1f} nT are left of held-out rows, where noise alone leaves"
        return (f"{UNEXPLAINED}: {left} {self.noise_floor_nT:.1f}; U takes that for random.",)

    def metrics(self) -> Mapping[str, Mapping[str, float]]:
        """Before and after, for the calibration file: after with what it ships, and of how many components it is.

        Beside it what of the held-out residual no error can have left that the run declares of reference and mounting,
        and what of its noise is theirs.
        """
        after = {**asdict(self.shipped or self.after), "noise_nT": self.noise_nT}
        after["noise_beside_readings_nT"] = self.noise_beside_readings_nT
        after["holdout_components"] = 3.0 if self.residual_kind == "vector" else 1.0
        if self.beside_declared_nT is not None:
            after["holdout_beside_declared_nT"] = self.beside_declared_nT
        return {"before": asdict(self.before), "after": after}

    def to_json(self) -> dict[str, Any]:
        """The contract's JSON object."""
        return {
            "format": FORMAT,
            "run_id": self.run_id,
            "residual_kind": self.residual_kind,
            "base": self.base,
            "noise_floor_nT": self.noise_floor_nT,
            "noise_floor_source": self.noise_floor_source,
            "before": asdict(self.before),
            "after": asdict(self.after),
            "beside_declared": {"holdout_rms_nT": self.beside_declared_nT},
            "set_aside": dict(self.set_aside),
            "accepted": [effect_json(e) for e in self.accepted],
            "rejected": [effect_json(e) for e in self.rejected],
            "proposed": [effect_json(e) for e in self.proposed],
            "verdict": self.verdict,
            "summary": self.summary,
            "next_experiment": None if self.next_experiment is None else asdict(self.next_experiment),
            "findings": [asdict(finding) for finding in self.findings],
            "tests": {when: [asdict(test) for test in tests] for when, tests in self.tests.items()},
            "shape": None if self.shape is None else asdict(self.shape),
            "twins": [asdict(pair) for pair in self.twins],
            "rounds": [asdict(one) for one in self.rounds],
            "specification": [asdict(line) for line in self.conformity.lines] if self.conformity else [],
        }


def effect_json(record: EffectRecord) -> dict[str, Any]:
    """The contract's EFFECT."""
    ci = record.improvement_ci95_nT
    group = {"group": record.group} if record.group else {}
    stated = {
        "effect": record.effect,
        "channels": list(record.channels),
        "reference_value": dict(record.reference_value),
        "belongs_to": record.belongs_to,
        "provisional": record.provisional,
        "parameters": [asdict(p) for p in record.parameters],
        "holdout_rms_before_nT": record.holdout_rms_before_nT,
        "holdout_rms_after_nT": record.holdout_rms_after_nT,
        "improvement_ci95_nT": None if ci is None else list(ci),
        "p_value": record.p_value,
        "rivals": [
            {"effect": r.effect, "channels": list(r.channels), "holdout_rms_after_nT": r.holdout_rms_after_nT}
            for r in record.rivals
        ],
        "why": record.why,
        **group,
    }
    if record.domain:
        stated["domain"] = [asdict(domain) for domain in record.domain]
    if record.basis is not None:
        stated |= {"inputs": list(record.inputs), "basis": asdict(record.basis)}
    return stated
