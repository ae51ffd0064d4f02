"""A sensor offset without a name: a smooth function of one or two recorded things, built where no known effect carries.

It is no candidate of the search: `labcal.loop` builds it from what the search leaves, and states its basis.
"""

from __future__ import annotations

import numpy as np

from labcal.errors import InputError
from labcal.model.effects.c_form import CForm
from labcal.model.effects.c_smooth import smooth_in_c
from labcal.model.effects.inputs import RATE, WINDOW_S, value
from labcal.model.effects.protocol import Array, Family
from labcal.model.effects.scene import Scene
from labcal.model.effects.term import Term
from labcal.record import Run

SCALE_nT = 1e4  # of the field in the projection, so that its coefficients are of one size


def kernel(term: Term, scene: Scene) -> Array:
    """E_i = Σ_j s_j,i φ_j(x), less its projection on the base: [1, a / 10 000 nT] on each axis."""
    if term.basis is None:
        raise InputError("the empirical effect states no basis")
    functions = term.basis.at([value(name, scene) for name in term.inputs])
    columns = functions[:, None, :, None] * np.eye(3)[None, :, None, :]
    return np.asarray(columns.reshape(len(scene), 3, -1) - of_base(scene) @ np.array(term.basis.projection))


def of_base(scene: Scene) -> Array:
    """What the map can do (n, 3, 12): 1, a_x, a_y, a_z on each axis."""
    onto = np.column_stack([np.ones(len(scene)), scene.driving_field_nT / SCALE_nT])
    return np.asarray((onto[:, None, :, None] * np.eye(3)[None, :, None, :]).reshape(len(scene), 3, 12))


def in_c(term: Term) -> CForm:
    """The same in C. Raises InputError."""
    if term.basis is None:
        raise InputError("the empirical effect states no basis")
    return smooth_in_c(term, term.basis, SCALE_nT)


def candidates(run: Run) -> list[Term]:
    """None: what it is shows only once the search has ended."""
    return []


def reach_s(term: Term) -> float | None:
    """A rate is taken from the rows beside."""
    return WINDOW_S if RATE in term.inputs else None


FAMILY = Family(
    "empirical",
    "sensor",
    kernel,
    candidates,
    phrase="the offset follows what was recorded, for no known cause",
    generic=True,
    experiment="hold all else and move its input up and down through its range, twice",
    reach_s=reach_s,
    in_pieces=True,
    in_c=in_c,
)
