"""What can be wrong with a sensor, a rig or the data: switched on by name in the twin's own table, known to nobody.

Each effect is a factory: it takes a random generator and its own keyword parameters and gives a function of the
`Moment`s. Written for themselves, in the lab's physics, not after the model that will have to find them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from inspect import signature
from typing import Any, TypeVar

from labcal.twin.effects.data import DATA
from labcal.twin.effects.rig import REFERENCE, RIG
from labcal.twin.effects.sensor import SENSOR

T = TypeVar("T")
NAMES = tuple(sorted({*SENSOR, *RIG, *REFERENCE, *DATA}))

__all__ = ["DATA", "NAMES", "REFERENCE", "RIG", "SENSOR", "switched_on"]


def switched_on(kind: Mapping[str, Callable[..., T]], wanted: Mapping[str, Mapping[str, Any]], rng: Any) -> list[T]:
    """The effects of one kind that `wanted` names. Raises ValueError for a name or a parameter that is not known."""
    for name in wanted:
        if name not in NAMES:
            raise ValueError(f"effects.{name}: there is no such effect; there are {', '.join(NAMES)}")
    effects = []
    for name, parameters in wanted.items():
        if name in kind:
            known = list(signature(kind[name]).parameters)[1:]
            if unknown := [p for p in parameters if p not in known]:
                raise ValueError(f"effects.{name}.{unknown[0]}: no such parameter; there are {', '.join(known)}")
            effects.append(kind[name](rng, **parameters))
    return effects
