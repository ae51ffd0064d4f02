"""What every driver promises, whatever its role."""

from __future__ import annotations

import ast
import dataclasses
import inspect
from pathlib import Path
from typing import Any

from labcal.bench.driver_kit.quantity import quantity
from labcal.bench.driver_kit.roles import Identity, Instrument
from labcal.errors import InstrumentError
from labcal.testing.drivers.rig import ROLES, DriverCase
from labcal.testing.require import refused, require

OUTSIDE = {"os", "socket", "serial", "subprocess", "pymodbus", "ctypes"}  # ways to a line that no deny-list guards


def it_says_who_it_is(case: DriverCase) -> None:
    """The emulator's unit is identified, and says its model."""
    rig = case.rig()
    found = rig.driver.identify()
    require(isinstance(found, Identity), f"{rig.name}.identify() returned {found!r}: return an Identity.")
    require(found.model, f"{rig.name}.identify() found no model: read it from what the instrument answers.")


def it_has_the_methods_of_its_role(case: DriverCase) -> None:
    """A driver fits its role by having its methods."""
    rig = case.rig()
    for role in case.driver.roles:
        for kind in (Instrument, ROLES[role]):
            lacks = [name for name in _members(kind) if not hasattr(rig.driver, name)]
            sentence = f"{rig.name} cannot be a {role}: it lacks {', '.join(lacks)}"
            require(isinstance(rig.driver, kind), f"{sentence} ({kind.__name__} in labcal/bench/driver_kit/roles.py).")


def _members(kind: type) -> list[str]:
    return sorted(getattr(kind, "__protocol_attrs__", None) or {n for n in dir(kind) if not n.startswith("_")})


def make_safe_may_be_called_twice(case: DriverCase) -> None:
    """Whoever takes the lab to rest may not know that it is."""
    rig = case.rig()
    rig.driver.identify()
    rig.driver.make_safe()
    rig.driver.make_safe()
    rig.driver.close()


def it_explains_itself(case: DriverCase) -> None:
    """Module, class, settings and public methods say what they are."""
    module = inspect.getmodule(case.driver)
    public = [v for k, v in vars(case.driver).items() if not k.startswith("_") and callable(v)]
    things = (module, case.driver, case.types["settings"], *public)
    silent = [thing for thing in things if not (inspect.getdoc(thing) or "").strip()]
    names = ", ".join(str(getattr(thing, "__qualname__", getattr(thing, "__name__", thing))) for thing in silent)
    require(not silent, f"Without a docstring: {names}. Say in one sentence what each is.")


def its_numbers_have_units_and_words_and_limits(case: DriverCase) -> None:
    """A declared quantity has a unit and a sentence, and limits where it can be set."""
    for name, number in vars(case.driver).items():
        if isinstance(number, quantity):
            where = f"quantity `{name}` of {case.driver.__name__}"
            require(number.unit, f"{where} has no unit: state unit=.")
            require(number.__doc__, f"{where} has no words: state doc=.")
            require(not number.set or number.limits is not None, f"{where} can be set without a limit: state limits=.")


def its_settings_are_frozen(case: DriverCase) -> None:
    """What a bench file states does not change while the bench runs."""
    kind = case.types["settings"]
    frozen = dataclasses.is_dataclass(kind) and getattr(kind, "__dataclass_params__").frozen  # noqa: B009
    require(frozen, f"{kind.__qualname__} of {case.driver.__name__} must be a @dataclass(frozen=True).")


def a_forbidden_message_cannot_be_sent(case: DriverCase) -> None:
    """Its `never` refuses each message that the case names, before a byte is on the line."""
    rig = case.rig()
    require(case.forbidden, f"Name a message that {rig.name} must never send: forbidden=[b'…'].")
    for message in case.forbidden:
        sentence = f"{rig.name} could send {message!r}: add a pattern that matches it to `never`."
        with refused(InstrumentError, sentence, words="never sent", fault="forbidden"):
            rig.line.send(message)
    require(rig.sent == [], f"{rig.name} put {rig.sent!r} on the line although it was refused.")


def it_has_no_way_past_its_link(case: DriverCase) -> None:
    """Driver and emulator open nothing themselves: only a link, which asks the deny-list, puts bytes on a line."""
    for part in (case.driver, case.emulator):
        path = Path(inspect.getfile(part))
        found = sorted(imported(path) & OUTSIDE)
        require(not found, f"{path} imports {', '.join(found)}: bytes leave through the link that it is given.")


def imported(path: Path) -> set[str]:
    """The packages that a module names."""
    nodes: list[Any] = list(ast.walk(ast.parse(path.read_text(encoding="utf-8"))))
    plain = {alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names}
    return {n.split(".")[0] for n in plain | {node.module or "" for node in nodes if isinstance(node, ast.ImportFrom)}}


PROMISES = (
    it_says_who_it_is,
    it_has_the_methods_of_its_role,
    make_safe_may_be_called_twice,
    it_explains_itself,
    its_numbers_have_units_and_words_and_limits,
    its_settings_are_frozen,
    a_forbidden_message_cannot_be_sent,
    it_has_no_way_past_its_link,
)
