"""The effects there are: every entry point of the group `labcal.effects`, ours and other packages'."""

from __future__ import annotations

from functools import cache
from importlib.metadata import entry_points

import numpy as np

from labcal.errors import InputError
from labcal.model.calibration import EffectRecord
from labcal.model.effects.protocol import Family, Fitted


@cache
def families() -> tuple[Family, ...]:
    """Every family, in the order of its name. Raises InputError where an entry point is not a `Family`."""
    found = []
    for point in sorted(entry_points(group="labcal.effects"), key=lambda p: p.name):
        loaded = point.load()
        if not isinstance(loaded, Family) or loaded.id != point.name:
            raise InputError(f"entry point {point.name!r} of labcal.effects ({point.value}) is not a Family of that id")
        found.append(loaded)
    return tuple(found)


def family(effect_id: str) -> Family:
    """The family of this id. Raises InputError where no installed package has it."""
    for candidate in families():
        if candidate.id == effect_id:
            return candidate
    raise InputError(f"no installed package describes the effect {effect_id!r} (entry-point group labcal.effects)")


def load(record: EffectRecord) -> Fitted:
    """The effect that a calibration describes, ready to predict. Raises InputError where a parameter is missing."""
    kind = family(record.effect)
    form = kind.restore(record)
    values = {p.name: p.value for p in record.parameters}
    return Fitted(kind, form, np.array([values[name] for name, _ in form.parameters]))
