"""Readings that answer to the field across their axis: products of the components along two axes.

In a magnetoresistive bridge the field across the film changes the sensitivity along it (s_i s_j), which for larger
fields becomes even in the crossing field (s_i s_j²).
"""

from __future__ import annotations

import numpy as np

from labcal.model.effects.c_form import CForm
from labcal.model.effects.protocol import Array, Family
from labcal.model.effects.regressors import AXES, BODY, driving, driving_in_c
from labcal.model.effects.scene import Scene
from labcal.model.effects.term import Term
from labcal.record import Run

MIXED = tuple((i, i, j) for i in range(3) for j in range(3) if j != i)
SQUARES = tuple((i, j, j) for i in range(3) for j in range(3) if j != i)
OPPOSITE = tuple((i, (i + 1) % 3, (i + 2) % 3) for i in range(3))
CUBIC = tuple((i, i, j, j) for i in range(3) for j in range(3) if j != i)


def kernel(term: Term, scene: Scene) -> Array:
    """Each parameter `q_x:xy` adds c s_x s_y to the reading along sensor axis x, s along B's axes for `body_q_…`."""
    s = driving(term, scene)
    out = np.empty((len(scene), 3, len(term.parameters)))
    for column, (name, _) in enumerate(term.parameters):
        axis, factors = name.removeprefix(BODY)[2:].split(":")
        product = np.prod([s[:, AXES.index(f)] for f in factors], axis=0)
        out[:, :, column] = product[:, None] * scene.axes[:, AXES.index(axis)]
    return out


def in_c(term: Term) -> CForm:
    """The same in C."""
    lines = []
    for column, (name, _) in enumerate(term.parameters):
        axis, factors = name.removeprefix(BODY)[2:].split(":")
        product = " * ".join(f"{driving_in_c(term)}[{AXES.index(f)}]" for f in factors)
        lines.append(f"along_axis(e[{column}], {AXES.index(axis)}, {product});")
    formula = "q_x:xy adds q s_x s_y along the sensor's axis x, q [1/nT, 1/nT^2], s [nT] along its axes (body_: of B)"
    return CForm(formula, "\n".join(lines), helpers=("along_axis",))


def _parameters(drive: str, terms: tuple[tuple[int, ...], ...]) -> tuple[tuple[str, str], ...]:
    unit = {2: "1/nT", 3: "1/nT^2"}
    return tuple((f"{drive}q_{AXES[t[0]]}:{''.join(AXES[f] for f in t[1:])}", unit[len(t) - 1]) for t in terms)


def candidates(run: Run) -> list[Term]:
    """Products with the axis' own component, of the two others, all of second order, and the even cubic ones."""
    sets = (MIXED, SQUARES, OPPOSITE, MIXED + SQUARES + OPPOSITE, CUBIC)
    return [Term(kernel, _parameters(drive, terms)) for drive in ("", BODY) for terms in sets]


FAMILY = Family(
    "cross-field",
    "sensor",
    kernel,
    candidates,
    phrase="the reading along one axis changes with the field across it",
    experiment="hold the field along one axis and step it along another",
    of_field=True,
    in_c=in_c,
    drawn_against="field",
)
