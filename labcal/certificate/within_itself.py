"""What a calibration file says twice has to agree, whichever version wrote it: a new meaning would be a new `format`.

A budget's U, k, degrees of freedom and shares follow from its rows (GUM, 5.1.2, G.4.1, G.6.4), a correlation and a
parameter's u from the covariance, a line's value, U and ratio from map, covariance and limit.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from math import inf, isclose, isnan, nan, sqrt
from typing import NamedTuple

import numpy as np

from labcal.certificate.recomputed import ROUNDED, Document, said
from labcal.model import Calibration
from labcal.record.specification import UNITS
from labcal.uncertainty.budget import coverage_factor
from labcal.uncertainty.conformity.decision import coverage_of
from labcal.uncertainty.conformity.of_the_map import figures_of_the_map

LEFT_OUT = 5e-4  # of a U: rows below 1e-5 of the variance are not listed
OF_SHARE = 5e-5  # of five factors of six digits each
OF_DOF = 1e-8  # of 1 / dof: rows that are not listed have less, and k does not see it


class Twice(NamedTuple):
    """A number of the file, what another part of it gives, and by how much the two may differ."""

    place: str
    stated: float
    follows: float
    by: str
    limit: float

    @property
    def agrees(self) -> bool:
        """Whether the two are the same number."""
        return isclose(self.stated, self.follows, rel_tol=0.0, abs_tol=self.limit)


def contradictions(calibration: Calibration) -> tuple[str, ...]:
    """The first number of each part of the file that another part of it contradicts, in words."""
    found = tuple[str, ...]()
    for part in (_of_budgets, _of_effects, _of_the_specification):
        wrong = (one for one in part(calibration) if not one.agrees)
        found += tuple(
            f"{one.place}: {_said(one.stated)} is stated, and {_said(one.follows)} follows from {one.by}"
            for one in islice(wrong, 1)
        )
    return found


def _said(number: float) -> str:
    return said(None if isnan(number) else number)


def _of_budgets(calibration: Calibration) -> Iterator[Twice]:
    r = _correlations(calibration)
    for i, one in enumerate(calibration.budget):
        place = f"budget[{i}]"
        yield from _of_its_rows(place, one)
        for j, pair in enumerate(one["correlations"]):
            stated, follows = pair.get("r"), r.get((str(pair.get("one")), str(pair.get("other"))), nan)
            number = float(stated) if isinstance(stated, int | float) else nan
            yield Twice(f"{place}.correlations[{j}].r", number, follows, "the covariance", ROUNDED)


def _of_its_rows(place: str, one: Document) -> Iterator[Twice]:
    parts = [(row["u"] * row["sensitivity"]) ** 2 for row in one["rows"]]
    u2, inverse = (one["U"] / one["k"]) ** 2, 1 / (one["dof"] or inf)
    by_rows = one["k"] * sqrt(sum(parts))
    yield Twice(f"{place}.U", one["U"], by_rows, "its rows and k", LEFT_OUT * by_rows)
    for j, (row, part) in enumerate(zip(one["rows"], parts, strict=True)):
        share = min(1.0, part / u2) if u2 > 0 else 0.0
        yield Twice(f"{place}.rows[{j}].share", row["share"], share, "its u and sensitivity", OF_SHARE * share)
    of_rows = sum(row["share"] ** 2 / (row["dof"] or inf) for row in one["rows"])
    yield Twice(f"{place}.1 / dof", inverse, of_rows, "its rows", OF_DOF + 1e-4 * of_rows)
    k = coverage_factor(one["dof"] or inf)
    yield Twice(f"{place}.k", one["k"], k, "its degrees of freedom", ROUNDED * k)


def _correlations(calibration: Calibration) -> dict[tuple[str, str], float]:
    """Of each two parameters by name."""
    if calibration.covariance is None:
        return {}
    u, names = np.sqrt(np.maximum(np.diag(calibration.covariance), 0.0)), calibration.covariance_of
    r = calibration.covariance / np.outer(safe := np.where(u > 0, u, 1.0), safe)
    return {(a, b): float(r[i, j]) for i, a in enumerate(names) for j, b in enumerate(names)}


def _of_effects(calibration: Calibration) -> Iterator[Twice]:
    if calibration.covariance is None:
        return
    u = dict(zip(calibration.covariance_of, np.sqrt(np.maximum(np.diag(calibration.covariance), 0.0)), strict=False))
    for i, effect in enumerate(calibration.effects):
        for j, p in enumerate(effect.parameters):
            follows = float(u.get(f"{i}:{p.name}", p.u))
            yield Twice(f"effects[{i}].parameters[{j}].u", p.u, follows, "the covariance", ROUNDED * follows)


def _of_the_specification(calibration: Calibration) -> Iterator[Twice]:
    of_map = {one.quantity: one for one in figures_of_the_map(calibration)}
    for i, line in enumerate(calibration.specification):
        place, U = f"specification[{i}]", line["U"]
        ratio = line["limit"] / U if U else 0.0
        yield Twice(f"{place}.tur", line["tur"] or 0.0, ratio, "limit and U", ROUNDED * abs(ratio))
        if (one := of_map.get(line["quantity"])) is None or (unit := UNITS[one.figure].get(line["unit"])) is None:
            continue
        size, expanded = one.value / unit, coverage_of(one.dof) * one.u / unit
        yield Twice(f"{place}.value", line["value"], size, "K and k", ROUNDED * abs(size))
        yield Twice(f"{place}.U", U, expanded, "the covariance", ROUNDED * expanded)
