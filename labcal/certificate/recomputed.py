"""A calibration beside what its run gives once it is worked out again: which fields differ, and what follows.

By the same version every field has to come out again, but those that people set: the map and the effects' parameters
within a hundredth of their u, all other numbers but for rounding. By another version the map, the effects and their
uncertainties are compared alone, and what the run itself states.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import islice
from typing import Any

import numpy as np

from labcal.certificate.calibration_file import calibration_bytes
from labcal.model import Calibration
from labcal.model.affine import MAP_PARAMETERS

SAME_U = 0.01  # of u
OTHER_U = 0.1  # of U = 2 u
ROUNDING = 1e-6  # of a covariance's variances: between processors 1e-10 was seen
ROUNDED = 2e-5  # of any other number: of six digits the last may be another on another processor
RESOLUTION = 1e-9  # of a number whose u may be nothing
NOTHING = 1e-12  # what cancels leaves as much
BY_PEOPLE = frozenset({"format", "approvers", "supersedes", "number", "issued_utc", "validity.until"})
OF_THE_STORE = frozenset({"cage_sha256", "chain"})  # a bundle of the same run does not tell them
OF_THE_RUN = frozenset({"run_id", "run_sha256", "simulated", "dut", "span_s", "operator"})
OF_THE_FIT = frozenset({"K", "k_nT", "effects", "covariance", "validity"})
Document = Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class Recomputed:
    """What came of working a calibration out again; `same` is None where it could not be done.

    `why` names the fields that differ, or what is missing; `holds` is False where that makes the file NOT VALID.
    """

    same: bool | None
    why: tuple[str, ...] = ()
    holds: bool = True


def whole_way(stated: Calibration, made: Calibration) -> Recomputed:
    """`stated` beside what the version that made it gives."""
    one, other = _document(stated), _document(made)
    fields = one.keys() - {name for name in OF_THE_STORE if one.get(name) is None or other.get(name) is None}
    found = _differences(one, other, fields - BY_PEOPLE, _limits(made, SAME_U))
    return Recomputed(not found, found, holds=not found)


def final_fit(stated: Calibration, made: Calibration) -> Recomputed:
    """`stated` beside the final fit with the same effects by another version: where they differ the signature stands.

    Not so where it states another run than its own.
    """
    one, other = _document(stated), _document(made)
    if false := _differences(one, other, OF_THE_RUN, {}):
        return Recomputed(False, false, holds=False)
    one, other = (
        {**d, "effects": _numbers(d), "covariance": _uncertainties(c)} for d, c in ((one, stated), (other, made))
    )
    found = _differences(one, other, OF_THE_FIT, _limits(made, 2 * OTHER_U) | _u_limits(other))
    return Recomputed(not found, found)


def _document(calibration: Calibration) -> dict[str, Any]:
    stated: dict[str, Any] = json.loads(calibration_bytes(calibration))
    return stated


def _numbers(document: Document) -> list[dict[str, Any]]:
    """The effects, with their parameters' values alone."""
    named = ("effect", "channels", "belongs_to", "reference_value")
    return [
        {name: effect[name] for name in named}
        | {"parameters": [{"name": p["name"], "value": p["value"]} for p in effect["parameters"]]}
        for effect in document["effects"]
    ]


def _uncertainties(calibration: Calibration) -> dict[str, float]:
    """The standard uncertainties of the map, by name."""
    if calibration.covariance is None:
        return {}
    return dict(zip((f"u({name})" for name in MAP_PARAMETERS), np.sqrt(np.diag(calibration.covariance)), strict=False))


def _u_limits(document: Document) -> dict[str, float]:
    return {f"covariance.{name}": OTHER_U * u for name, u in document["covariance"].items()}


def _limits(made: Calibration, share: float) -> dict[str, float]:
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


def _differences(
    stated: Document, made: Document, fields: Iterable[str], limits: Mapping[str, float]
) -> tuple[str, ...]:
    """The first place of each field that differs, in the order of the file, with both values."""
    found = (_places(name, stated.get(name), made.get(name), limits) for name in sorted(fields))
    return tuple(place for places in found for place in islice(places, 1))


def _places(place: str, stated: object, made: object, limits: Mapping[str, float]) -> Iterator[str]:
    """Every place under `place` that differs, in words."""
    if place in BY_PEOPLE:
        return
    if isinstance(stated, dict) and isinstance(made, dict) and stated.keys() == made.keys():
        for name in stated:
            yield from _places(f"{place}.{name}", stated[name], made[name], limits)
    elif isinstance(stated, list) and isinstance(made, list) and len(stated) == len(made):
        for i, (one, other) in enumerate(zip(stated, made, strict=True)):
            yield from _places(f"{place}[{i}]", one, other, limits)
    elif not _alike(stated, made, limits.get(place)):
        yield f"{place}: {_said(stated)} is stated, its run gives {_said(made)}"


def _alike(stated: object, made: object, limit: float | None) -> bool:
    numbers = [v for v in (stated, made) if isinstance(v, int | float) and not isinstance(v, bool)]
    if len(numbers) < 2:
        return stated == made
    largest = max(map(abs, numbers))
    allowed = max(NOTHING, ROUNDED * largest) if limit is None else limit + RESOLUTION * largest
    return abs(numbers[0] - numbers[1]) <= allowed


def _said(value: object) -> str:
    if isinstance(value, list | dict):
        return f"{len(value)} of them"
    text = f"{value:.6g}" if isinstance(value, float) else json.dumps(value, ensure_ascii=False)
    return text if len(text) <= 60 else f"{text[:57]}…"
