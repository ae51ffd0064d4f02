"""What an effect without a name is made of, in a DCC: its splines, what is taken off them, and where it was seen."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from labcal.certificate.dcc.parts import Makers
from labcal.model import EffectRecord
from labcal.model.effects.empirical import SCALE_nT
from labcal.model.effects.inputs import CHANNEL, UNITS


def basis_in_words(effect: EffectRecord) -> str:
    """How the functions phi come of the matrices beside them; empty for an effect that has a name."""
    if effect.basis is None:
        return ""
    splines = f"the B-splines of degree {effect.basis.degree} on its knots"
    of = (
        f"of {effect.inputs[0]}"
        if len(effect.inputs) == 1
        else f"every product of those of {' and '.join(effect.inputs)}"
    )
    return (
        f" phi: {splines}, {of}, times `functions`. s: the parameters, by function and axis. The projection has a row "
        f"for 1, a_x, a_y, a_z of each axis (a / {SCALE_nT:g} nT), and a column for each s. Outside what was seen it "
        "is left out."
    )


def basis_quantities(m: Makers, effect: EffectRecord, unit_of: Mapping[str, str]) -> list[Any]:
    """Each matrix row by row, with its shape in its name; where a named effect was seen too."""
    seen = [
        _matrix(m, f"corners of what was seen, {name}", [corners], _unit(name, unit_of))
        for domain in effect.domain
        for name, corners in zip(domain.inputs, zip(*domain.hull, strict=True), strict=True)
    ]
    if effect.basis is None:
        return seen
    knots = [
        _matrix(m, f"knots of {name}", [row], _unit(name, unit_of))
        for name, row in zip(effect.inputs, effect.basis.knots, strict=True)
    ]
    functions = _matrix(m, "functions", effect.basis.functions, "1")
    return [*knots, functions, _matrix(m, "projection", effect.basis.projection, "1"), *seen]


def _matrix(m: Makers, name: str, rows: Sequence[Sequence[float]], unit: str) -> Any:
    numbers = [number for row in rows for number in row]
    shape = f"{len(rows)} by {len(rows[0])}"
    return m.d.quantity(m.text("name", f"{name}: {shape}"), m.real_list(numbers, unit), refType="labcal_basis")


def _unit(name: str, unit_of: Mapping[str, str]) -> str:
    if name.startswith(CHANNEL):
        return unit_of.get(name.removeprefix(CHANNEL), "1")
    return UNITS[name.partition("_")[0]]
