"""One driver on its own emulator, with a simulated lab behind it and everything heard that goes over the line."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime
from functools import cache
from importlib.metadata import EntryPoints, entry_points
from typing import Any, get_type_hints

from labcal.bench.clock import VirtualClock
from labcal.bench.driver_kit.roles import (
    CoilSupply,
    DutStream,
    Interlock,
    Magnetometer,
    PolarityRelay,
    RotationPlatform,
)
from labcal.bench.links import EmulatedLink
from labcal.bench.links.modbus import ModbusLink
from labcal.testing.require import require
from labcal.twin import open_twin

ROLES: dict[str, type] = {
    "coil": CoilSupply,
    "polarity": PolarityRelay,
    "interlock": Interlock,
    "platform": RotationPlatform,
    "reference": Magnetometer,
    "dut": DutStream,
}


@dataclass(frozen=True)
class DriverCase:
    """A driver that is tried: its class, its emulator's, and what a bench file would have to state.

    `forbidden`: messages that its `never` must refuse, whole as they would go over the line (of Modbus without CRC).
    `to_panel`: what a supply says last, once zero and off are read back, so that its front panel works again.
    `resolution_A`: how finely a supply can be set. `knows_its_place`: a stage that need not move to find home.
    """

    driver: Any
    emulator: Callable[..., Any]
    forbidden: Sequence[bytes]
    settings: Mapping[str, Any] = field(default_factory=dict)
    to_panel: bytes = b""
    resolution_A: float = 0.001
    knows_its_place: bool = False

    def __post_init__(self) -> None:
        name = getattr(self.driver, "__name__", repr(self.driver))
        text = f"No emulator for {name}: check_driver(Driver, Emulator, …), or the driver's name where it is installed."
        require(self.emulator is not None, text)
        for stated, form in (("roles", '("coil",)'), ("never", r'(rb"RST",)')):
            require(hasattr(self.driver, stated), f"{name} states no `{stated}`: add {stated} = {form} to the class.")
        roles, never = self.driver.roles, self.driver.never
        require(_all_are(str, roles) and roles, f'{name}.roles is {roles!r}: a tuple of words, such as ("coil",).')
        unknown = sorted(set(roles) - set(ROLES))
        require(not unknown, f"{name}.roles names {', '.join(map(repr, unknown))}; the roles are {', '.join(ROLES)}.")
        text = f'{name}.never is {never!r}: a tuple of patterns in bytes, such as (rb"RST",).'
        require(_all_are(bytes, never), text)
        text = f'forbidden is {self.forbidden!r}: a list of messages in bytes, such as [b"RST\\n"].'
        require(_all_are(bytes, self.forbidden), text)

    @property
    def types(self) -> dict[str, Any]:
        """The types that the driver's `__init__` states: they decide the kind of link and of settings."""
        hints = get_type_hints(self.driver.__init__)
        for name in ("link", "settings"):
            require(name in hints, f"{self.driver.__name__}.__init__ states no type of its argument `{name}`: add it.")
        return hints

    @property
    def modbus(self) -> bool:
        """Whether it speaks registers instead of bytes."""
        return self.types["link"] is ModbusLink

    def rig(self, *, coil: str = "x", **stated: Any) -> DriverRig:
        """It on a line of its own, a supply at this coil; `stated` are settings beside the case's own."""
        settings = self.types["settings"](**{**self.settings, **stated})
        if "coil" in self.driver.roles:
            text = f"The Settings of {self.driver.__name__} lack max_current_A: a supply has one."
            require(hasattr(settings, "max_current_A"), text)
        return DriverRig(self, settings, coil)


def _all_are(kind: type, things: Any) -> bool:
    return isinstance(things, tuple | list) and all(isinstance(one, kind) for one in things)


def installed(name: str, **stated: Any) -> DriverCase:
    """The case of a driver by its name in bench.toml; `stated` are the fields of DriverCase."""
    return DriverCase(_entry("labcal.drivers", name), _entry("labcal.emulators", name), **stated)


@cache
def _entries(group: str, path: tuple[str, ...]) -> EntryPoints:
    """What the packages on this search path bring; to look takes 40 ms, as long as a test of a driver."""
    return entry_points(group=group)


def _entry(group: str, name: str) -> Any:
    found = list(_entries(group, tuple(sys.path)).select(name=name))
    text = f'Declare {name} = "module:Class" in [project.entry-points."{group}"] of pyproject.toml and install again'
    require(found, f"No installed package has {name!r} in {group}. {text}.")
    require(len(found) == 1, f"{name!r} is there twice in {group}: two packages bring one name. Rename yours.")
    return found[0].load()


class Foretold:
    """An emulator that is held to what it foresees: who serves it sleeps until then."""

    def __init__(self, emulator: Any) -> None:
        self._emulator, self.take, self.due_s = emulator, emulator.take, emulator.due_s

    def emit(self, until_s: float) -> list[tuple[float, bytes]]:
        """What is on the line up to `until_s`; the first piece is there when `due_s` says."""
        due_s, pieces = self.due_s(), self._emulator.emit(until_s)
        first_s = min((t for t, _ in pieces), default=None)
        kept = due_s > until_s if first_s is None else abs(first_s - due_s) <= 1e-6
        require(kept, f"due_s() of the emulator says {due_s} s, and its next bytes are on the line at {first_s} s.")
        return list(pieces)


class DriverRig:
    """One driver on its emulator, and what went over the line."""

    def __init__(self, case: DriverCase, settings: Any, coil: str = "x") -> None:
        self.case, self.settings = case, settings
        self.role = case.driver.roles[0]
        self.lab, self.clock = open_twin({}, 1), VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
        plays = f"coil-{coil}" if self.role == "coil" else self.role
        self.emulator = case.emulator(self.lab, {plays: {}}, settings)
        end = Foretold(self.emulator) if hasattr(self.emulator, "due_s") else self.emulator
        self.line = EmulatedLink("emulated://rig", end, self.clock)
        self.line.never.add(case.driver.never, settings.address if case.modbus else None)
        self.sent: list[bytes] = []
        self._overhear()
        link: Any = ModbusLink(self.line, self.clock) if case.modbus else self.line
        self.driver: Any = case.driver("rig", link, self.clock, settings)

    def _overhear(self) -> None:
        send = self.line.send

        def heard(data: bytes) -> None:
            send(data)
            self.sent.append(data)

        self.line.send = heard  # type: ignore[method-assign]

    @property
    def name(self) -> str:
        """How the driver is spoken of."""
        return str(self.case.driver.__name__)

    def wait(self, seconds: float) -> None:
        """Let time pass in the simulated lab."""
        self.clock.wait_until(self.clock.now() + seconds)

    def coil_A(self) -> float:
        """What truly flows in coil x now, asked of the physics and not of any instrument."""
        return float(self.lab.coils["x"].current.now(self.clock.now()))

    def angle_deg(self) -> float:
        """Where the platform truly is now."""
        return float(self.lab.platform.now(self.clock.now())[0])
