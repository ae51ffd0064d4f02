"""Readings that are not proportional to the field along their own axis: powers two to five, the odd square, a kink.

A core that bends shows as a negative third power, one that saturates within the range as a tanh, an uneven bridge as
the second power, a weak magnet in Rayleigh's range as s |s|, an amplifier with another gain for each sign as |s|.
"""

from __future__ import annotations

import numpy as np

from labcal.model.effects.c_form import CForm
from labcal.model.effects.protocol import Array, Family
from labcal.model.effects.regressors import BODY, FIELD_IN_C, driving, driving_in_c, per_axis, powered
from labcal.model.effects.scene import Scene
from labcal.model.effects.shape import THRESHOLD, Shape
from labcal.model.effects.term import Term
from labcal.record import Run

TERMS = (("c3",), ("c2",), ("c2", "c3"), ("c3", "c5"), ("c2", "c3", "c4", "c5"), ("o2",), ("o2", "c3"), ("k1",))
SATURATING = (("t1",), ("t1", "c2", "c3", "c4", "c5"))
SATURATION_nT = (10000.0, 20000.0, 40000.0)
SATURATION = Shape("s_nT", SATURATION_nT[0], "nT", SATURATION_nT, THRESHOLD)


def kernel(term: Term, scene: Scene) -> Array:
    """E = Σ_k c_k s_i^k + o2 s_i |s_i| + k1 |s_i| + t1 (tanh u_i − u_i), u = s / s_nT, along sensor axis i.

    Here s is the field along the sensor's axes, for `body_…` along the body's. What is proportional to it is the map's.
    """
    s = driving(term, scene)
    powers = dict.fromkeys(name.removeprefix(BODY)[:2] for name, _ in term.parameters)
    return np.concatenate([_bent(s, power, term)[:, None, :] * scene.axes for power in powers], axis=2)


def _bent(s: Array, power: str, term: Term) -> Array:
    if power == "t1":
        return bend(s / term.at(SATURATION.name))
    if power == "k1":
        return np.abs(s)
    return s * np.abs(s) if power == "o2" else s ** int(power[1])


def in_c(term: Term) -> CForm:
    """The same in C."""
    powers = dict.fromkeys(name.removeprefix(BODY)[:2] for name, _ in term.parameters)
    lines = [
        f"along_axis(e[{3 * number + i}], {i}, {_bent_in_c(power, f'{driving_in_c(term)}[{i}]')});"
        for number, power in enumerate(powers)
        for i in range(3)
    ]
    needed = [name for name, used in (("bend", {"t1"}), ("magnitude", {"k1", "o2"})) if used & powers.keys()]
    formula = (
        "E = sum of c_k s^k + o2 s |s| + k1 |s| + t1 (tanh u - u), u = s / s_nT, along each of the sensor's axes; "
        f"s [nT] the field along {'those of B' if driving_in_c(term) == FIELD_IN_C else 'them'}; c_k [nT^(1-k)]"
    )
    return CForm(formula, "\n".join(lines), helpers=("along_axis", *needed))


def _bent_in_c(power: str, s: str) -> str:
    if power == "t1":
        return f"bend({s} / R(shape[0]))"
    if power == "k1":
        return f"magnitude({s})"
    return f"{s} * magnitude({s})" if power == "o2" else " * ".join([s] * int(power[1]))


def bend(u: Array) -> Array:
    """What a saturating curve lacks of a straight one: tanh u − u."""
    return np.asarray(np.tanh(u) - u)


def candidates(run: Run) -> list[Term]:
    """The sums of powers worth trying, and a saturation alone and with them."""
    return [
        Term(kernel, tuple(p for power in powers for p in per_axis(f"{drive}{power}", _unit(power))), shape=shape)
        for drive in ("", BODY)
        for powers, shape in (*((t, ()) for t in TERMS), *((t, (SATURATION,)) for t in SATURATING))
    ]


def _unit(power: str) -> str:
    return {"t1": "nT", "k1": "1"}.get(power) or powered(int(power[1]))


FAMILY = Family(
    "nonlinearity",
    "sensor",
    kernel,
    candidates,
    phrase="the reading is not proportional to the field",
    shapes=(SATURATION,),
    of_field=True,
    in_c=in_c,
    experiment="step the field along each axis through its whole range",
    drawn_against="field",
)
