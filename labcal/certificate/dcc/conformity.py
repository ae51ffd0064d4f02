"""Statements of conformity in a DCC: each line of the specification as a result with its limit, rule and verdict."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from labcal.certificate.dcc.parts import Makers
from labcal.uncertainty.conformity import Judged, risk_in_words

STATUS = {
    "pass": "pass",
    "conditional-pass": "conditionalPass",
    "conditional-fail": "conditionalFail",
    "fail": "fail",
}
GUIDES = ("ILAC-G8:09/2019", "JCGM 106:2012")


def conformity_results(m: Makers, lines: Sequence[Judged]) -> list[Any]:
    """One dcc:result for each line: the value with U (k = 2), and beside it what was decided by which rule."""
    return [_result(m, line) for line in lines]


def _result(m: Makers, line: Judged) -> Any:
    limit = m.quantity(line.limit, line.unit, name="limit", ref_type="basic_acceptanceLimit")
    decided = m.d.metaData(
        m.text("name", "conformity with the specification"),
        *(m.d.norm(guide) for guide in GUIDES),
        m.text("declaration", _declaration(line)),
        m.d.conformity(STATUS[line.result]),
        m.d.data(limit),
        refType="basic_conformity",
    )
    quantity = m.quantity(line.value, line.unit, line.U, "basic_measuredValue")
    quantity.append(m.d.measurementMetaData(decided))
    return m.result(f"specification: {line.quantity}", "", quantity, ref_type="labcal_specification")


def _declaration(line: Judged) -> str:
    tur = "" if line.tur is None else f" Test uncertainty ratio {line.tur:.3g}."
    risk = f"Specific risk of false acceptance {risk_in_words(line.risk)}."
    return f"Absolute value at most {line.limit:g} {line.unit}. Decision rule: {line.rule}. {risk}{tur}"
