"""As found and as left in a DCC: what changed since the calibration before, in units of its uncertainty (E_n)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from labcal.uncertainty.conformity import Change, Changes

TOLD = (
    "As found by the calibration of run {found}, as left by this one. U is that of the difference, k = 2; "
    "E_n = (as left - as found) / U (ISO/IEC 17043): beyond 1 in size the sensor has changed."
)


def change_results(d: Any, si: Any, changed: Changes | None, unit_name: Callable[[str], str]) -> list[Any]:
    """One dcc:result for each figure: found, left, change with U, and E_n; none where no calibration is before."""
    return [] if changed is None else [_result(d, si, changed, row, unit_name(row.unit)) for row in changed.rows]


def _result(d: Any, si: Any, changed: Changes, row: Change, unit: str) -> Any:
    sizes = [("as found", row.found), ("as left", row.left)]
    quantities = [_quantity(d, name, si.real(si.value(repr(size)), si.unit(unit))) for name, size in sizes]
    if row.U is not None and row.e_n is not None:
        expanded = si.measurementUncertaintyUnivariate(
            si.expandedMU(si.valueExpandedMU(repr(row.U)), si.coverageFactor("2"), si.coverageProbability("0.95"))
        )
        moved = si.real(si.value(repr(row.left - row.found)), si.unit(unit), expanded)
        quantities.append(_quantity(d, "change", moved))
        quantities.append(_quantity(d, "E_n", si.real(si.value(repr(row.e_n)), si.unit(r"\one"))))
    said = " ".join([TOLD.format(found=changed.found), *changed.remarks])
    name = d.name(d.content(f"since the calibration before: {row.quantity}", lang="en"))
    return d.result(name, d.description(d.content(said, lang="en")), d.data(*quantities))


def _quantity(d: Any, name: str, value: Any) -> Any:
    return d.quantity(d.name(d.content(name, lang="en")), value)
