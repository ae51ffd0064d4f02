"""A calibration beside what its run gives once it is worked out again: which fields differ, and what follows.

By the same version every field has to come out again, but those that people set: the map and the effects' parameters
within a hundredth of their u, all other numbers but for rounding. What another version has to give is in
`between_versions`.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import islice
from typing import Any

import numpy as np

from labcal.certificate.calibration_file import calibration_bytes
from labcal.model import Calibration
from labcal.model.affine import MAP_PARAMETERS
from labcal.record import Run

SAME_U = 0.01  # of u
ROUNDING = 1e-6  # of a covariance's variances: between processors 1e-10 was seen
ROUNDED = 2e-5  # of any other number: of six digits the last may be another on another processor
RESOLUTION = 1e-9  # of a number whose u may be nothing
NOTHING = 1e-12  # what cancels leaves as much
BY_PEOPLE = frozenset({"format", "approvers", "supersedes", "number", "issued_utc", "validity.until"})
OF_THE_STORE = frozenset({"cage_sha256", "chain"})  # a bundle of the same run does not tell them
OF_THE_RUN = frozenset({"run_id", "run_sha256", "simulated", "dut", "span_s", "operator"})
FIRST_VERSION = "labcal-calibration/1"  # has neither number, budget, chain nor made_by
Document = Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class Recomputed:
    """What came of working a calibration out again; `same` is None where it could not be done.

    `why` names the fields that differ, or what is missing; `holds` is False where that makes the file NOT VALID.
    `as_stated` names the fields that stand as another version stated them, and that nothing here works out again.
    """

    same: bool | None
    why: tuple[str, ...] = ()
    holds: bool = True
    as_stated: tuple[str, ...] = ()
    stated_by: str = ""  # the version that stated those

    def sentences(self) -> list[str]:
        """What came of it, for a person."""
        why = "; ".join(self.why)
        if self.same is None:
            return [f"It was not worked out again: {why}."]
        if not self.same:
            return [f"Worked out again from its run it differs: {why}.{' The signature stands.' if self.holds else ''}"]
        again = "Worked out again from its run, it is the same."
        if not self.as_stated:
            return [again]
        return [again, f"Stated by {self.stated_by}, and not worked out again: {', '.join(_grouped(self.as_stated))}."]


def _grouped(places: Iterable[str]) -> list[str]:
    """Places in a file, those of one part together: `effects[0] (p_value, why)`."""
    parts = dict[str, list[str]]()
    for place in places:
        of, _, name = place.rpartition(".")
        parts.setdefault(of or name, []).extend([name] if of else [])
    return [f"{of} ({', '.join(names)})" if names else of for of, names in parts.items()]


def whole_way(stated: Calibration, made: Calibration) -> Recomputed:
    """`stated` beside what the version that made it gives."""
    one, other = document(stated), document(made)
    fields = one.keys() - {name for name in OF_THE_STORE if one.get(name) is None or other.get(name) is None}
    found = differences(one, other, fields - BY_PEOPLE, limits(made, SAME_U))
    return Recomputed(not found, found, holds=not found)


def not_stated(calibration: Calibration) -> str | None:
    """What a released calibration states and this one does not; None where it states all."""
    if calibration.format == FIRST_VERSION:
        return f"{FIRST_VERSION} has no place for what a released one states: number, budget, what is not covered"
    if calibration.number is None or calibration.issued_utc is None:
        return "it has no number and date of issue, which an approval gives: nobody's approval is on record"
    return None


def of_its_run(stated: Calibration, run: Run) -> tuple[str, ...]:
    """The fields of `stated` that another run than its own is identified by, each in words."""
    span = (float(run.t_s[0]), float(run.t_s[-1]))
    made = replace(stated, run_id=run.run_id, simulated=run.simulated, operator=run.operator, dut=run.dut, span_s=span)
    return of_the_run(stated, made)


def of_the_run(stated: Calibration, made: Calibration) -> tuple[str, ...]:
    """The fields by which two are of different runs, each in words."""
    return differences(document(stated), document(made), OF_THE_RUN, {})


def document(calibration: Calibration) -> dict[str, Any]:
    """What its file states."""
    stated: dict[str, Any] = json.loads(calibration_bytes(calibration))
    return stated


def _uncertainties(calibration: Calibration) -> dict[str, float]:
    """The standard uncertainties of the map, by name."""
    if calibration.covariance is None:
        return {}
    return dict(zip((f"u({name})" for name in MAP_PARAMETERS), np.sqrt(np.diag(calibration.covariance)), strict=False))


def limits(made: Calibration, share: float) -> dict[str, float]:
    """By how much a number may differ, by its place: map and effects by `share` of u, the covariance by rounding."""
    u = _uncertainties(made)
    places = [*(f"K[{i}][{j}]" for i in range(3) for j in range(3)), *(f"k_nT[{i}]" for i in range(3))]
    limits = {place: share * of for place, of in zip(places, u.values(), strict=False)}
    for i, effect in enumerate(made.effects):
        limits |= {f"effects[{i}].parameters[{j}].value": share * p.u for j, p in enumerate(effect.parameters)}
    if made.covariance is not None:
        s = np.sqrt(np.diag(made.covariance))
        limits |= {f"covariance[{i}][{j}]": ROUNDING * s[i] * s[j] for i in range(len(s)) for j in range(len(s))}
    return limits


def differences(
    stated: Document, made: Document, fields: Iterable[str], limits: Mapping[str, float]
) -> tuple[str, ...]:
    """The first place of each field that differs, in the order of the file, with both values."""
    found = (_places(name, stated.get(name), made.get(name), limits) for name in sorted(fields))
    return tuple(place for places in found for place in islice(places, 1))


def _places(place: str, stated: object, made: object, limits: Mapping[str, float]) -> Iterator[str]:
    """Every place under `place` that differs, in words."""
    if place in BY_PEOPLE:
        return
    if isinstance(stated, dict) and isinstance(made, dict):
        for name in {**stated, **made}:
            yield from _places(f"{place}.{name}", stated.get(name), made.get(name), limits)
    elif isinstance(stated, list) and isinstance(made, list) and len(stated) == len(made):
        for i, (one, other) in enumerate(zip(stated, made, strict=True)):
            yield from _places(f"{place}[{i}]", one, other, limits)
    elif not _alike(stated, made, limits.get(place)):
        yield f"{place}: {said(stated)} is stated, its run gives {said(made)}"


def _alike(stated: object, made: object, limit: float | None) -> bool:
    numbers = [v for v in (stated, made) if isinstance(v, int | float) and not isinstance(v, bool)]
    if len(numbers) < 2:
        return stated == made
    largest = max(map(abs, numbers))
    allowed = max(NOTHING, ROUNDED * largest) if limit is None else limit + RESOLUTION * largest
    return abs(numbers[0] - numbers[1]) <= allowed


def said(value: object) -> str:
    """A value in a sentence."""
    if value is None or isinstance(value, list | dict):
        return "none" if value is None else f"{len(value)} of them"
    text = f"{value:.6g}" if isinstance(value, float) else json.dumps(value, ensure_ascii=False)
    return text if len(text) <= 60 else f"{text[:57]}…"
