"""Statements of conformity in a DCC: each line of the specification as a result with its limit, rule and verdict."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from labcal.uncertainty.conformity import Judged, risk_in_words

STATUS = {
    "pass": "pass",
    "conditional-pass": "conditionalPass",
    "conditional-fail": "conditionalFail",
    "fail": "fail",
}
GUIDES = ("ILAC-G8:09/2019", "JCGM 106:2012")


def conformity_results(d: Any, si: Any, lines: Sequence[Judged], unit_name: Callable[[str], str]) -> list[Any]:
    """One dcc:result for each line: the value with U (k = 2), and beside it what was decided by which rule."""
    return [_result(d, si, line, unit_name(line.unit)) for line in lines]


def _result(d: Any, si: Any, line: Judged, unit: str) -> Any:
    expanded = si.measurementUncertaintyUnivariate(
        si.expandedMU(si.valueExpandedMU(repr(line.U)), si.coverageFactor("2"), si.coverageProbability("0.95"))
    )
    value = si.real(si.value(repr(line.value)), si.unit(unit), expanded)
    decided = d.metaData(
        d.name(d.content("conformity with the specification", lang="en")),
        *(d.norm(guide) for guide in GUIDES),
        d.declaration(d.content(_told(line), lang="en")),
        d.conformity(STATUS[line.result]),
        d.data(d.quantity(d.name(d.content("limit", lang="en")), _limit(si, line, unit))),
    )
    quantity = d.quantity(value, d.measurementMetaData(decided))
    return d.result(d.name(d.content(f"specification: {line.quantity}", lang="en")), d.data(quantity))


def _limit(si: Any, line: Judged, unit: str) -> Any:
    return si.real(si.value(repr(line.limit)), si.unit(unit))


def _told(line: Judged) -> str:
    tur = "" if line.tur is None else f" Test uncertainty ratio {line.tur:.3g}."
    risk = f"Specific risk of false acceptance {risk_in_words(line.risk)}."
    return f"Absolute value at most {line.limit:g} {line.unit}. Decision rule: {line.rule}. {risk}{tur}"
