"""As found and as left in a DCC: what changed since the calibration before, in units of its uncertainty (E_n)."""

from __future__ import annotations

from typing import Any

from labcal.certificate.dcc.parts import Makers
from labcal.uncertainty.conformity import Change, Changes

DIFFERENCE = (
    "As found by the calibration of run {found}, as left by this one. U is that of the difference; "
    "E_n = (as left - as found) / U (ISO/IEC 17043): beyond 1 in size the sensor has changed."
)


def change_results(m: Makers, changed: Changes | None) -> list[Any]:
    """One dcc:result for each figure: found, left, change with U, and E_n; none where no calibration is before."""
    return [] if changed is None else [_result(m, changed, row) for row in changed.rows]


def _result(m: Makers, changed: Changes, row: Change) -> Any:
    sizes = (("as found", row.found), ("as left", row.left))
    quantities = [m.quantity(size, row.unit, name=name) for name, size in sizes]
    if row.U is not None and row.e_n is not None:
        quantities.append(m.quantity(row.left - row.found, row.unit, row.U, name="change", k=row.k))
        quantities.append(m.quantity(row.e_n, "1", name="E_n"))
    said = " ".join([DIFFERENCE.format(found=changed.found), *changed.remarks])
    return m.result(f"since the calibration before: {row.quantity}", said, *quantities, ref_type="labcal_change")
