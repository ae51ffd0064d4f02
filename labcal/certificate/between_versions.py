"""What another version made beside this version's final fit: what can be worked out again is compared, the rest named.

Map, effects, covariance, each row of the budget and the lines of the specification have to come out again within a
tenth of U, and no combination of parameters may have a u that is another by more; a rms within a tenth, and no less may
be not covered. What rests on a search or on held-out time stands as it is stated, and no held-out rms is smaller than
what the final fit leaves of its own rows. What the file says twice has to agree beside that, to its digits.
A draft that nobody has approved is held as closely as one of this version: it can be made again.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

import numpy as np

from labcal.certificate.recomputed import (
    FIRST_VERSION,
    SAME_U,
    Document,
    Recomputed,
    differences,
    document,
    limits,
    of_the_run,
    said,
)
from labcal.certificate.within_itself import contradictions
from labcal.model import Calibration
from labcal.uncertainty.budget import SHOWN, coverage_factor

OTHER_U = 0.1  # of U = 2 u
OTHER_R = 0.1  # of a correlation: half of what a tenth of each u does to it
FURTHEST = 37.0  # standard deviations, beyond which a risk is nothing
NEARLY_LEFT_OUT = 2 * SHOWN**0.5  # of u: twice the part below which a row is not listed
FEWEST = 1e-9  # of the largest variance of a combination: less is rounding
LEAST_R = 0.5  # a budget names the correlations beyond it
OF_THE_FIT = frozenset(
    {"K", "k_nT", "effects", "findings", "covariance", "validity", "metrics", "specification", "budget", "k_at"}
    | {"not_covered", "instruments", "frame_known", "covariance_of", "made_by"}
)
NEW_OF_2 = frozenset({"budget", "k_at", "not_covered", "covariance_of", "made_by"})
OF_THE_SEARCH = (
    "provisional",
    "holdout_rms_before_nT",
    "holdout_rms_after_nT",
    "improvement_ci95_nT",
    "p_value",
    "rivals",
    "why",
    "group",
)
HIDES = frozenset({"provisional", "rivals"})  # where they are left out
WHAT_IT_IS = ("effect", "channels", "reference_value")
OF_SET_ASIDE = "rows"  # the parameter of a finding that counts rows; only the search says how many
OF_DATA = "findings (which of them are of the data)"  # outliers, saturation: the search says what was set aside
TRAINED = "train_rms_nT"
HELD_OUT = {"holdout_rms_nT": TRAINED, "holdout_beside_declared_nT": "beside_declared_nT"}  # and what is no more
RISK = "risk, as standard deviations"
FIT = "fit"  # the command that searches nothing
Metrics = Mapping[str, Mapping[str, float]]


def final_fit(stated: Calibration, made: Calibration, *, closely: bool = False) -> Recomputed:
    """`stated` beside the final fit with the same effects by another version: where they differ the signature stands.

    Not so where it states another run than its own. `closely` allows the numbers what one version allows. A term
    without a name is only as good as how it was found, which no final fit shows.
    """
    if false := of_the_run(stated, made):
        return Recomputed(False, false, holds=False)
    one, other = _of_a_final_fit(stated), _of_a_final_fit(made)
    one["not_covered"] = min(one.get("not_covered", 0), other["not_covered"])  # more may be named
    fields = OF_THE_FIT - (NEW_OF_2 if stated.format == FIRST_VERSION else set())
    _without_what_only_one_shows(one, other)
    allowed = limits(made, SAME_U) if closely else limits(made, 2 * OTHER_U) | _between_versions(other)
    found = differences(one, other, fields, allowed)
    found += _along(one["covariance"], other["covariance"], made.covariance_of) + _not_its_version(one)
    found += contradictions(stated)
    standing, by = tuple(as_stated(stated, made)), stated.software or "another version"
    if not found and (unshown := [i for i, effect in enumerate(stated.effects) if effect.basis is not None]):
        why = f"effects[{unshown[0]}].basis: another version built it, and no final fit shows it"
        return Recomputed(None, (why,), as_stated=standing, stated_by=by)
    return Recomputed(not found, found, as_stated=standing, stated_by=by)


def with_held_out(shown: Metrics, stated: Metrics) -> Metrics:
    """What a final fit shows of the loop's metrics, beside the held-out ones that are `stated`.

    Held-out rows are not fitted better than those of the fit: where less is stated, what the fit leaves is held out.
    """
    found = {when: {name: of[name] for name in of if name not in HELD_OUT.values()} for when, of in shown.items()}
    before, after = stated.get("before", {}), stated.get("after", {})
    found["before"] |= {name: before[name] for name in HELD_OUT if name in before}
    for name, floor in HELD_OUT.items():
        if name in after or floor == TRAINED:
            found["after"][name] = max(shown["after"][floor], after.get(name, 0.0))
    return {when: of | {TRAINED: shown[when][TRAINED]} for when, of in found.items()}


def as_stated(stated: Calibration, made: Calibration) -> Iterator[str]:
    """The fields that no final fit shows, each by its place in the file."""
    searched = (made.made_by or {}).get("command") != FIT
    for place, effects in (("effects", stated.effects), ("findings", stated.findings)):
        for i, effect in enumerate(effects if searched else ()):
            told = list(WHAT_IT_IS) if effect.belongs_to == "data" else []
            told += ["parameters"] if any(p.name == OF_SET_ASIDE for p in effect.parameters) else []
            told += [name for name in OF_THE_SEARCH if name in HIDES or getattr(effect, name) not in (None, "")]
            yield from (f"{place}[{i}].{name}" for name in told)
    if searched:
        yield OF_DATA
        yield "made_by.empirical"
    for when, of in stated.metrics.items():
        shown = made.metrics.get(when, {})
        yield from (f"metrics.{when}.{name}" for name in sorted(of) if name not in shown or name in HELD_OUT)
    yield from (f"not_covered[{i}]" for i, text in enumerate(stated.not_covered) if text not in made.not_covered)


def _without_what_only_one_shows(one: dict[str, Any], other: dict[str, Any]) -> None:
    """What the file has no place for, metrics that no fit has, and rows that say next to nothing."""
    one["metrics"] = {
        when: {n: of[n] for n in of if n in other["metrics"][when]} for when, of in one["metrics"].items()
    }
    if one["format"] == FIRST_VERSION:
        other["covariance"] = [row[:12] for row in other["covariance"][:12]]  # the map's
        for effect in (*one["effects"], *other["effects"]):
            effect.pop("domain")
    else:
        _with_rows_of_both(one["budget"], other["budget"])
    if one.get("made_by") is None:
        other["made_by"] = None
    else:
        other["made_by"]["version"] = one["made_by"]["version"]


def _not_its_version(stated: Document) -> tuple[str, ...]:
    """Each version states itself twice."""
    version = ((stated.get("made_by") or {}).get("version") or "").partition(" ")[0]
    if not version or stated["software"] == f"labcal {version}":
        return ()
    return (f"software: {said(stated['software'])} is stated, and made_by.version is {said(version)}",)


def _of_a_final_fit(calibration: Calibration) -> dict[str, Any]:
    """What can be compared between versions, by field."""
    stated = document(calibration)
    stated["effects"], stated["findings"] = _shown(stated["effects"]), _shown(stated["findings"])
    stated["covariance"] = stated["covariance"] or []
    stated.setdefault("specification", [])  # the first version left an empty one out
    if "budget" in stated:
        stated["budget"] = _by_name(
            (f"{one['quantity']} at {one['at']}", _of_a_budget(one)) for one in stated["budget"]
        )
        stated["not_covered"] = len(stated["not_covered"])  # the words may be others
    for line in stated["specification"]:
        line[RISK] = _deviations(line.pop("risk"))
    return stated


def _shown(effects: Iterable[Document]) -> list[dict[str, Any]]:
    """What a final fit shows of effects; of the data's those that state limits, which `apply` goes by."""
    searched = (*OF_THE_SEARCH, "inputs", "basis")  # no final fit shows how a term without a name was found
    found = [{name: value for name, value in effect.items() if name not in searched} for effect in effects]
    for effect in found:
        effect.setdefault("domain", [])
        effect["parameters"] = [p for p in effect["parameters"] if effect["belongs_to"] != "data" or _is_limit(p)]
    return [effect for effect in found if effect["belongs_to"] != "data" or effect["parameters"]]


def _is_limit(parameter: Document) -> bool:
    return bool(parameter["name"] != OF_SET_ASIDE)


def _of_a_budget(one: Document) -> dict[str, Any]:
    """One entry of a budget, its rows by what they are of."""
    rows = ((f"{row['source']} ({row['type']}, {row['distribution']}, {row['unit']})", row) for row in one["rows"])
    of = _by_name((name, _part(row)) for name, row in rows)
    pairs = {f"{pair.get('one')} and {pair.get('other')}": _number(pair.get("r")) for pair in one["correlations"]}
    return {"U": one["U"], "k": one["k"], "unit": one["unit"], "rows": of, "correlations": pairs}


def _number(value: object) -> float:
    return float(value) if isinstance(value, int | float) else np.nan


def _deviations(risk: float | None) -> float | None:
    """How many standard deviations a normal figure is from the limit that it passes with this probability."""
    from scipy.special import ndtri

    return None if risk is None else float(np.clip(-ndtri(risk), -FURTHEST, FURTHEST))


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
    k = coverage_factor(row["dof"] or np.inf)
    return {"u": row["u"], "u x sensitivity": row["u"] * row["sensitivity"], "k of dof": k}


def _with_rows_of_both(one: dict[str, Any], other: dict[str, Any]) -> None:
    """A row that only one has, because it says next to nothing, has no part in the other; a correlation is no more
    than what is named. Any other row that only one has is missing.
    """
    for name in one.keys() & other.keys():
        both = one[name], other[name]
        for has, lacks in (both, both[::-1]):
            little = NEARLY_LEFT_OUT * has["U"] / has["k"]
            for of in has["rows"].keys() - lacks["rows"].keys():
                if abs(has["rows"][of]["u x sensitivity"]) <= little:
                    lacks["rows"][of] = {**has["rows"][of], "u x sensitivity": 0.0}
            for pair in has["correlations"].keys() - lacks["correlations"].keys():
                lacks["correlations"][pair] = float(np.copysign(LEAST_R, has["correlations"][pair]))


def _between_versions(made: Document) -> dict[str, float]:
    """By how much what a final fit gives may differ between versions, by its place."""
    shares = {
        f"metrics.{when}.{name}": OTHER_U * value for when, of in made["metrics"].items() for name, value in of.items()
    }
    for name, one in made.get("budget", {}).items():
        shares |= _of_its_rows(f"budget.{name}", one)
    for i, line in enumerate(made["specification"]):
        shares |= {f"specification[{i}].{name}": OTHER_U * line["U"] for name in ("value", "U")}
        shares |= {f"specification[{i}].{RISK}": 2 * OTHER_U + OTHER_U * abs(line[RISK] or 0.0)}
        shares |= {f"specification[{i}].tur": OTHER_U * (line["tur"] or 0.0)}
    for place in ("effects", "findings"):
        for i, effect in enumerate(made[place]):
            for j, p in enumerate(effect["parameters"]):
                at = f"{place}[{i}].parameters[{j}]"
                shares |= {f"{at}.value": 2 * OTHER_U * p["u"], f"{at}.u": OTHER_U * p["u"]}
    if any(finding["belongs_to"] == "rig" for finding in made["findings"]):  # the fields at the DUT come from the fit
        noise = made["metrics"]["after"].get("noise_nT", 0.0)
        shares |= {f"validity.field_nT[{i}]": OTHER_U * noise for i in range(2)}
    for i, row in enumerate(made["covariance"]):
        shares |= {f"covariance[{i}][{j}]": 2 * OTHER_U * _scale(made, i, j) for j in range(len(row))}
    return shares


def _of_its_rows(place: str, one: Document) -> dict[str, float]:
    """By how much the numbers of one entry of the budget may differ, by their place."""
    found = {f"{place}.{name}": OTHER_U * one[name] for name in ("U", "k")}
    found |= {f"{place}.correlations.{pair}": OTHER_R for pair in one["correlations"]}
    for of, row in one["rows"].items():
        found |= {
            f"{place}.rows.{of}.u": OTHER_U * row["u"],
            f"{place}.rows.{of}.u x sensitivity": OTHER_U * one["U"],
            f"{place}.rows.{of}.k of dof": OTHER_U * row["k of dof"],
        }
    return found


def _scale(made: Document, i: int, j: int) -> float:
    """The product of two standard uncertainties of the map."""
    return float(np.sqrt(made["covariance"][i][i] * made["covariance"][j][j]))


def _along(stated: list[list[float]], made: list[list[float]], names: tuple[str, ...]) -> tuple[str, ...]:
    """The combination of parameters whose u is furthest from the run's, where it is another by more than `OTHER_U`.

    Its square is the generalised eigenvalue of the two covariances; what follows from the map lies between the ends.
    """
    one, other = np.array(stated), np.array(made)
    if one.shape != other.shape or not other.size:
        return ()
    u = np.sqrt(np.diag(other))
    one, other = (C / np.outer(safe := np.where(u > 0, u, 1.0), safe) for C in (one, other))
    variance, directions = np.linalg.eigh(other)
    there = variance > FEWEST * variance[-1]
    whitened = directions[:, there] / np.sqrt(variance[there])
    ratio, along = np.linalg.eigh(whitened.T @ one @ whitened)
    u_ratio = np.sqrt(np.maximum(ratio, 0.0))
    worst = int(np.argmax(np.abs(u_ratio - 1)))
    if abs(u_ratio[worst] - 1) <= OTHER_U:
        return ()
    most = names[int(np.argmax(np.abs(whitened @ along[:, worst])))]
    return (
        f"covariance: u of a combination, of {most} for the most part, is {u_ratio[worst]:.3g} of what its run gives",
    )
