"""A calibration beside what its run gives once it is worked out again: which fields differ, and what follows.

By the same version every field has to come out again, but those that people set: the map and the effects' parameters
within a hundredth of their u, all other numbers but for rounding. By another version what its final fit gives has to
come out again within a tenth of U (map, effects, covariance, each row of the budget, lines of the specification), a
tenth of each rms that a fit has, no less that is not covered, and what the run itself states.
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
OTHER_U = 0.1  # of U = 2 u
OTHER_SHARE = 0.1  # of a variance that a row of a budget has
OTHER_DOF = (0.5, 0.01)  # of 1 / dof, and beside it: 50 or 80 of them give the same k
OTHER_RISK = 0.05  # of a false acceptance, which a tenth of U moves by as much
ROUNDING = 1e-6  # of a covariance's variances: between processors 1e-10 was seen
ROUNDED = 2e-5  # of any other number: of six digits the last may be another on another processor
RESOLUTION = 1e-9  # of a number whose u may be nothing
NOTHING = 1e-12  # what cancels leaves as much
BY_PEOPLE = frozenset({"format", "approvers", "supersedes", "number", "issued_utc", "validity.until"})
OF_THE_STORE = frozenset({"cage_sha256", "chain"})  # a bundle of the same run does not tell them
OF_THE_RUN = frozenset({"run_id", "run_sha256", "simulated", "dut", "span_s", "operator"})
OF_THE_FIT = frozenset(
    {"K", "k_nT", "effects", "findings", "covariance", "validity", "metrics", "specification", "budget", "k_at"}
    | {"not_covered", "instruments", "frame_known", "covariance_of"}
)
FIRST_VERSION = "labcal-calibration/1"  # has neither number, budget, chain nor made_by
NEW_OF_2 = frozenset({"budget", "k_at", "not_covered", "covariance_of"})
OF_THE_LOOP = "residual"  # the line of a specification that rests on held-out time
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


def not_stated(calibration: Calibration) -> str | None:
    """What a released calibration states and this one does not; None where it states all."""
    if calibration.format == FIRST_VERSION:
        return f"{FIRST_VERSION} has no place for what a released one states: number, budget, what is not covered"
    if calibration.number is None or calibration.issued_utc is None:
        return "it has no number and date of issue, which an approval gives: nobody's approval is on record"
    return None


def final_fit(stated: Calibration, made: Calibration) -> Recomputed:
    """`stated` beside the final fit with the same effects by another version: where they differ the signature stands.

    Not so where it states another run than its own. A term without a name is only as good as how it was found, which
    no final fit shows.
    """
    if false := _of_the_run(stated, made):
        return Recomputed(False, false, holds=False)
    one, other = _of_a_final_fit(stated, made), _of_a_final_fit(made, stated)
    one["not_covered"] = min(one.get("not_covered", 0), other["not_covered"])  # more may be named
    fields = OF_THE_FIT - (NEW_OF_2 if stated.format == FIRST_VERSION else set())
    if stated.format == FIRST_VERSION:
        other["covariance"] = [row[:12] for row in other["covariance"][:12]]  # the map's
        for effect in (*one["effects"], *other["effects"]):
            effect.pop("domain")
    else:
        _with_rows_of_both(one["budget"], other["budget"])
    found = _differences(one, other, fields, _limits(made, 2 * OTHER_U) | _between_versions(other))
    found += _not_its_version(one)
    if not found and (unshown := [i for i, effect in enumerate(stated.effects) if effect.basis is not None]):
        return Recomputed(None, (f"effects[{unshown[0]}].basis: another version built it, and no final fit shows it",))
    return Recomputed(not found, found)


def of_its_run(stated: Calibration, run: Run) -> tuple[str, ...]:
    """The fields of `stated` that another run than its own is identified by, each in words."""
    span = (float(run.t_s[0]), float(run.t_s[-1]))
    made = replace(stated, run_id=run.run_id, simulated=run.simulated, operator=run.operator, dut=run.dut, span_s=span)
    return _of_the_run(stated, made)


def _of_the_run(stated: Calibration, made: Calibration) -> tuple[str, ...]:
    return _differences(_document(stated), _document(made), OF_THE_RUN, {})


def _not_its_version(stated: Document) -> tuple[str, ...]:
    """Each version states itself twice."""
    version = ((stated.get("made_by") or {}).get("version") or "").partition(" ")[0]
    if not version or stated["software"] == f"labcal {version}":
        return ()
    return (f"software: {_said(stated['software'])} is stated, and made_by.version is {_said(version)}",)


def _of_a_final_fit(calibration: Calibration, other: Calibration) -> dict[str, Any]:
    """What can be compared between versions with the same of `other`, by field."""
    stated = _document(calibration)
    stated["effects"], stated["findings"] = _numbers(stated["effects"]), _numbers(stated["findings"])
    stated["covariance"] = stated["covariance"] or []
    stated["metrics"] = _metrics(calibration, other)
    stated["specification"] = [
        {name: line[name] for name in ("quantity", "limit", "unit", "rule", "result", "value", "U", "risk", "tur")}
        for line in map(dict, calibration.specification)
        if not line["quantity"].startswith(OF_THE_LOOP)
    ]
    if "budget" in stated:
        stated["budget"] = _by_name(
            (f"{one['quantity']} at {one['at']}", _of_a_budget(one)) for one in stated["budget"]
        )
        stated["not_covered"] = len(stated["not_covered"])  # the words may be others
    return stated


def _of_a_budget(one: Document) -> dict[str, Any]:
    """One entry of a budget, its rows by what they are of."""
    rows = ((f"{row['source']} ({row['type']}, {row['distribution']}, {row['unit']})", row) for row in one["rows"])
    of = _by_name((name, _part(row)) for name, row in rows)
    return {"U": one["U"], "k": one["k"], "unit": one["unit"], "1 / dof": 1 / (one["dof"] or np.inf), "rows": of}


def _by_name(named: Iterable[tuple[str, dict[str, Any]]]) -> dict[str, dict[str, Any]]:
    """Each by its name, the second of one name by another: none hides behind the other."""
    found = dict[str, dict[str, Any]]()
    for name, one in named:
        while name in found:
            name += " again"
        found[name] = one
    return found


def _part(row: Document) -> dict[str, float]:
    """What a row has of the standard uncertainty."""
    part = row["u"] * abs(row["sensitivity"])
    return {"u": row["u"], "u x sensitivity": part, "share": row["share"], "1 / dof": 1 / (row["dof"] or np.inf)}


def _with_rows_of_both(one: dict[str, Any], other: dict[str, Any]) -> None:
    """A row that is left out, as those that say next to nothing are, has no part in it."""
    for name in one.keys() & other.keys():
        both = one[name]["rows"], other[name]["rows"]
        for has, lacks in (both, both[::-1]):
            for of in has.keys() - lacks.keys():
                lacks[of] = {**has[of], "u x sensitivity": 0.0, "share": 0.0}


def _metrics(calibration: Calibration, other: Calibration) -> dict[str, float]:
    """Those of both: a final fit has none of the loop's."""
    return {
        f"{when}.{name}": value
        for when, found in calibration.metrics.items()
        for name, value in found.items()
        if name in other.metrics.get(when, {})
    }


def _document(calibration: Calibration) -> dict[str, Any]:
    stated: dict[str, Any] = json.loads(calibration_bytes(calibration))
    return stated


def _numbers(effects: Iterable[Document]) -> list[dict[str, Any]]:
    """The effects but those of the data, with their parameters' values and u alone."""
    named = ("effect", "channels", "belongs_to", "reference_value")
    seen = ("domain",)  # of the sensor's alone: `apply` goes by it
    return [
        {name: effect[name] for name in named}
        | {name: effect.get(name, []) for name in seen if effect["belongs_to"] == "sensor"}
        | {"parameters": [{"name": p["name"], "value": p["value"], "u": p["u"]} for p in effect["parameters"]]}
        for effect in effects
        if effect["belongs_to"] != "data"
    ]


def _uncertainties(calibration: Calibration) -> dict[str, float]:
    """The standard uncertainties of the map, by name."""
    if calibration.covariance is None:
        return {}
    return dict(zip((f"u({name})" for name in MAP_PARAMETERS), np.sqrt(np.diag(calibration.covariance)), strict=False))


def _between_versions(made: Document) -> dict[str, float]:
    """By how much what a final fit gives may differ between versions, by its place."""
    shares = {f"metrics.{name}": OTHER_U * value for name, value in made["metrics"].items()}
    for name, one in made.get("budget", {}).items():
        shares |= _of_its_rows(f"budget.{name}", one)
    for i, line in enumerate(made["specification"]):
        shares |= {f"specification[{i}].{name}": OTHER_U * line["U"] for name in ("value", "U")}
        shares |= {f"specification[{i}].risk": OTHER_RISK, f"specification[{i}].tur": OTHER_U * (line["tur"] or 0.0)}
    for place in ("effects", "findings"):
        for i, effect in enumerate(made[place]):
            for j, p in enumerate(effect["parameters"]):
                at = f"{place}[{i}].parameters[{j}]"
                shares |= {f"{at}.value": 2 * OTHER_U * p["u"], f"{at}.u": OTHER_U * p["u"]}
    if any(finding["belongs_to"] == "rig" for finding in made["findings"]):  # the fields at the DUT come from the fit
        noise = made["metrics"].get("after.noise_nT", 0.0)
        shares |= {f"validity.field_nT[{i}]": OTHER_U * noise for i in range(2)}
    for i, row in enumerate(made["covariance"]):
        shares |= {f"covariance[{i}][{j}]": 2 * OTHER_U * _scale(made, i, j) for j in range(len(row))}
    return shares


def _of_its_rows(place: str, one: Document) -> dict[str, float]:
    """By how much the numbers of one entry of the budget may differ, by their place."""
    share, beside = OTHER_DOF
    limits = {f"{place}.{name}": OTHER_U * one[name] for name in ("U", "k")}
    limits[f"{place}.1 / dof"] = share * one["1 / dof"] + beside
    for of, row in one["rows"].items():
        limits |= {
            f"{place}.rows.{of}.u": 2 * OTHER_U * row["u"],
            f"{place}.rows.{of}.u x sensitivity": OTHER_U * one["U"],
            f"{place}.rows.{of}.share": OTHER_SHARE,
            f"{place}.rows.{of}.1 / dof": share * row["1 / dof"] + beside,
        }
    return limits


def _scale(made: Document, i: int, j: int) -> float:
    """The product of two standard uncertainties of the map."""
    return float(np.sqrt(made["covariance"][i][i] * made["covariance"][j][j]))


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
