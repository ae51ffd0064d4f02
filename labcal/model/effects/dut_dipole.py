"""A near reference sees the device's own magnetic moment, which turns with it.

Where the reference's place is not stated, it sees a symmetric and traceless matrix of the cage times the moment.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from labcal.model.effects.field_gradient import MOMENT_OR_GRADIENT, SYMMETRIC, traceless
from labcal.model.effects.protocol import Array, Family
from labcal.model.effects.regressors import AXES
from labcal.model.effects.scene import Scene
from labcal.model.effects.shape import GIVEN, Shape
from labcal.model.effects.term import Term
from labcal.record import Run, offers

MU0_OVER_4PI_nT = 100.0  # nT m³ / (A m²)
AT = tuple(Shape(f"at_{axis}_m", 0.0, "m", kind=GIVEN) for axis in AXES)  # the reference's place


def kernel(term: Term, scene: Scene) -> Array:
    """E = −R B(Rᵀ m): what the reference reads too much, for a moment m [A m²] fixed in the body.

    B(m) = (μ0/4π)(3 r̂ (r̂·m) − m)/r³ at the reference's place (Jackson, 5.56); `dxy_z` is an element of that matrix
    times m_z.
    """
    assert scene.rig is not None
    if not term.shape:
        return _anywhere(term, scene.rig.to_body)
    place = np.array([term.at(shape.name) for shape in AT])
    distance = float(np.linalg.norm(place))
    along = place / distance
    dipole = MU0_OVER_4PI_nT * (3 * np.outer(along, along) - np.eye(3)) / distance**3
    turn = scene.rig.to_body
    return np.asarray(-np.einsum("nij,jk,nlk->nil", turn, dipole, turn))


def _anywhere(term: Term, turn: Array) -> Array:
    names = [name.removeprefix("d").split("_") for name, _ in term.parameters]
    columns = [-(turn @ traceless(which) * turn[:, [AXES.index(axis)]]).sum(axis=2) for which, axis in names]
    return np.stack(columns, axis=2)


def candidates(run: Run) -> list[Term]:
    """One moment, at the reference's place; where that is not stated, anywhere near."""
    near, place = run.reference.position_m, run.reference.place
    if not any(offers(run, s) == "vector" and s.kind == "rotation" for s in run.segments):
        return []
    if near is None:
        unknown = tuple((f"d{w}_{a}", "nT") for w in SYMMETRIC for a in AXES)
        return [] if place in ("remote", "computed") else [Term(kernel, unknown)]
    if not 0.01 < float(np.linalg.norm(near)) < 3.0:
        return []
    there = tuple(replace(shape, value=float(x)) for shape, x in zip(AT, near, strict=True))
    return [Term(kernel, tuple((f"m_{a}", "A m^2") for a in AXES), shape=there)]


FAMILY = Family(
    "dut-dipole-at-reference",
    "rig",
    kernel,
    candidates,
    phrase="the reference sees the DUT's own magnetism",
    shapes=AT,
    experiment="repeat with the reference at twice the distance",
    responds={"move reference": 0.125},
    confounded=(MOMENT_OR_GRADIENT,),
)
