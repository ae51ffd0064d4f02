"""Statements of conformity in a DCC: each line of the specification as a result with its limit, rule and verdict."""

from __future__ import annotations

from typing import Any

from labcal.certificate.dcc.parts import COVERAGE, Makers
from labcal.certificate.report.conformity import title_of
from labcal.model import Calibration
from labcal.record.specification import Specification
from labcal.uncertainty.conformity import Judged, ratio_in_words, risk_in_words, stated_lines
from labcal.uncertainty.conformity.of_the_map import in_the_budget

STATUS = {
    "pass": "pass",
    "conditional-pass": "conditionalPass",
    "conditional-fail": "conditionalFail",
    "fail": "fail",
}
GUIDES = ("ILAC-G8:09/2019", "JCGM 106:2012")


def conformity_results(m: Makers, c: Calibration, specification: Specification | None) -> list[Any]:
    """One dcc:result for each line: the value with U, and beside it what was decided by which rule.

    `specification` is what the run stated, whose title it is. The k of a line is that of the figure's budget; 2 for
    what has none.
    """
    of_budget = {b["quantity"]: b["k"] for b in c.budget}
    which = "specification" if specification is None else f"specification {title_of(specification)}"
    return [_result(m, line, of_budget.get(in_the_budget(line.quantity), COVERAGE), which) for line in stated_lines(c)]


def _result(m: Makers, line: Judged, k: float, which: str) -> Any:
    limit = m.quantity(line.limit, line.unit, name="limit", ref_type="basic_acceptanceLimit")
    decided = m.d.metaData(
        m.text("name", f"conformity with the {which}"),
        *(m.d.norm(guide) for guide in GUIDES),
        m.text("declaration", _declaration(line)),
        m.d.conformity(STATUS[line.result]),
        m.d.data(limit),
        refType="basic_conformity",
    )
    quantity = m.quantity(line.value, line.unit, line.U, "basic_measuredValue", k=k)
    quantity.append(m.d.measurementMetaData(decided))
    return m.result(f"specification: {line.quantity}", "", quantity, ref_type="labcal_specification")


def _declaration(line: Judged) -> str:
    tur = "" if line.tur is None else f" Test uncertainty ratio {ratio_in_words(line.tur)}."
    risk = f"Specific risk of false acceptance {risk_in_words(line.risk)}."
    return f"Absolute value at most {line.limit:g} {line.unit}. Decision rule: {line.rule}. {risk}{tur}"
