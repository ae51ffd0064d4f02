"""The effects there are: every entry point of the group `labcal.effects`, ours and other packages'."""

from __future__ import annotations

import re
from functools import cache
from importlib.metadata import entry_points

import numpy as np

from labcal import plugin_loading
from labcal.errors import InputError
from labcal.model.effects.guard import guarded
from labcal.model.effects.inputs import CHANNEL
from labcal.model.effects.protocol import Family, Fitted
from labcal.model.effects.scene import Scene
from labcal.model.records import EffectRecord
from labcal.model.smooth import Domain

TRIED = 8  # rows that a shipped effect is tried on
RESERVED = frozenset({"t_s", "segment", "mode", "dut_x", "dut_y", "dut_z"})  # columns that are no channel
OF_AN_AXIS = re.compile(r"_([xyz])(?: |\Z)")


@cache
def families() -> tuple[Family, ...]:
    """Every family by name. Raises InputError where there is none, one twice, or an entry point is not a `Family`."""
    found = dict[str, Family]()
    for point in sorted(entry_points(group="labcal.effects"), key=lambda p: p.name):
        named, loaded = plugin_loading.named(point), plugin_loading.load(point)
        if not isinstance(loaded, Family):
            raise InputError(f"{named} is a {type(loaded).__name__} and no Family")
        if loaded.id != point.name:
            raise InputError(f"{named} holds the Family {loaded.id!r}: give both one name, and install again")
        if loaded.id in found:
            raise InputError(f"{named} is there twice: two packages describe an effect of one name")
        found[loaded.id] = loaded if point.value.startswith("labcal.") else guarded(loaded, point.value)
    if not found:
        raise InputError("no effect is installed, so nothing can be traced: labcal runs from an installed package")
    return tuple(found.values())


def family(effect_id: str) -> Family:
    """The family of this id. Raises InputError where no installed package has it."""
    if (found := find(effect_id)) is not None:
        return found
    raise InputError(f"no installed package describes the effect {effect_id!r} (entry-point group labcal.effects)")


def find(effect_id: str) -> Family | None:
    """The family of this id; None where no installed package has it."""
    return next((family for family in families() if family.id == effect_id), None)


def phrases() -> dict[str, str]:
    """What happens by each family, in plain words, by its id."""
    return {family.id: family.plainly() for family in families()}


def plainly(effect_id: str) -> str:
    """The same of one; the id itself where no installed package has it."""
    return phrases().get(effect_id, effect_id)


def of_temperature(record: EffectRecord) -> bool:
    """Whether the effect follows a temperature."""
    kind = find(record.effect)
    return kind is not None and kind.of_temperature


def load(record: EffectRecord) -> Fitted:
    """The effect that a calibration describes, ready to predict. Raises InputError where a parameter is missing."""
    kind = family(record.effect)
    term = kind.restore(record)
    values = {p.name: p.value for p in record.parameters}
    return Fitted(kind, term, np.array([values[name] for name, _ in term.parameters]))


def load_shipped(record: EffectRecord) -> Fitted:
    """The sensor's effect that a calibration file ships, tried on a few rows. Raises InputError where it is not whole.

    A file may come from anywhere: its parameters must be those that the effect's own formula has, in their order,
    and its channels must state where they count from.
    """
    fault = f"the effect {record.effect} is not whole"
    loaded = load(record)
    if (owner := loaded.family.owner(loaded.term)) != "sensor":
        raise InputError(f"the effect {record.effect} is the {owner}'s, never the sensor's")
    if set(record.channels) != set(record.reference_value) or RESERVED & set(record.channels):
        raise InputError(f"{fault}: each channel needs its reference value, and a name of its own")
    if record.basis is not None and not _is_whole(record):
        raise InputError(f"{fault}: its basis does not belong to its inputs, parameters and domain")
    if record.basis is None and not all(_is_of_a_channel(record, domain) for domain in record.domain):
        raise InputError(f"{fault}: its domain is not two ends of a channel that it follows")
    names = [p.name for p in record.parameters]
    if len(set(names)) < len(names) or not _in_order(names):
        raise InputError(f"{fault}: its parameters are there twice, or not in the order x, y, z")
    try:
        with np.errstate(all="ignore"):
            columns = loaded.term.columns(_few_rows(record))
    except InputError:
        raise
    except Exception as error:  # the formulas, other packages' too, may stumble over names and counts in many ways
        raise InputError(f"{fault}: its parameters are not those of its formula") from error
    if columns.shape != (TRIED, 3, len(loaded.beta)) or not np.isfinite(columns).all():
        raise InputError(f"{fault}: its {len(names)} parameters are not those of its formula, or give no numbers")
    return loaded


def _is_of_a_channel(record: EffectRecord, domain: Domain) -> bool:
    """Whether a domain is two ends, in order, of one of the effect's own channels."""
    ends = [corner[0] for corner in domain.hull if len(corner) == 1]
    own = [(f"{CHANNEL}{name}",) for name in record.channels]
    return domain.inputs in own and len(ends) == len(domain.hull) == 2 and ends[0] <= ends[1]


def _is_whole(record: EffectRecord) -> bool:
    """Whether a smooth function has a domain of its inputs, knots in order, and the parameters of its coefficients."""
    basis = record.basis
    assert basis is not None
    stated = [value for row in basis.coefficients for value in row]
    known = [(domain.inputs, {len(corner) for corner in domain.hull}) for domain in record.domain]
    rising = all(list(knots) == sorted(knots) and len(knots) > 2 * basis.degree + 1 for knots in basis.knots)
    return (
        (record.inputs, {len(record.inputs)}) in known
        and rising
        and len(basis.knots) == len(record.inputs)
        and stated == [p.value for p in record.parameters]
        and len(basis.covariance) == len(stated)
    )


def _in_order(names: list[str]) -> bool:
    """Whether each three parameters of the axes, as c_x, c_y, c_z, stand in this order."""
    axes = [found[1] for name in names if (found := OF_AN_AXIS.search(name))]
    threes = [axes[i : i + 3] for i in range(0, len(axes), 3)]
    return all(three == ["x", "y", "z"] for three in threes if sorted(three) == ["x", "y", "z"])


def _few_rows(record: EffectRecord) -> Scene:
    """Rows about an hour long in a turning field, each channel at its reference value and beside it."""
    t = np.linspace(0.0, 3600.0, TRIED)
    turn = np.linspace(0.0, 2.0, TRIED)
    field = 30e3 * np.column_stack([np.cos(turn), np.sin(turn), np.cos(2 * turn)])
    channels = {name: record.reference_value[name] + turn for name in record.channels}
    return Scene(t, np.zeros(TRIED, dtype=np.intp), field, channels, np.full(TRIED, "", dtype=np.str_))
