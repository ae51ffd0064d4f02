"""From bench.toml to instruments: drivers, emulators and the simulated lab are found by entry point, never imported."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from contextlib import ExitStack, suppress
from dataclasses import dataclass, field, fields
from functools import cache
from itertools import takewhile
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn, TypeVar, cast, get_type_hints

from labcal import entry_files, plugin_loading
from labcal.bench.clock import Clock, RealClock
from labcal.bench.driver_kit.roles import Instrument
from labcal.bench.essentials import AXES, Essentials
from labcal.bench.links import EmulatedLink, Emulator, Link, SharedWire, open_link, ports
from labcal.bench.links.urls import split
from labcal.errors import InputError

DRIVERS, EMULATORS, TWINS = "labcal.drivers", "labcal.emulators", "labcal.twins"
WHICH = ("address", "axis", "output", "channel", "id")  # settings that tell instruments on one line apart
ZERO_IS = 0.25  # of the current limit, at most: what is read back below it counts as zero
T = TypeVar("T")

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

    from labcal.bench.config import BenchConfig, InstrumentConfig
    from labcal.bench.links.modbus import ModbusLink


@dataclass
class Loader:
    """Opens what one bench.toml names: each link once, each emulator once, one simulated lab for all of them."""

    path: Path
    config: BenchConfig
    clock: Clock
    seed: int
    links: dict[str, Link] = field(default_factory=dict)
    masters: dict[str, ModbusLink] = field(default_factory=dict)
    twin: Any = None

    def instrument(self, name: str) -> Instrument:
        """The driver of the instrument `name`, on the kind of link and with the settings that its `__init__` states."""
        self._refuse_second(name)
        driver, hints, settings = self.driver(name)
        modbus = speaks_modbus(hints)
        link = self.modbus(name) if modbus else self.link(name)
        self.links[self.line_of(name)].never.add(driver.never, settings.address if modbus else None)
        return cast(Instrument, driver(name, link, self.clock, settings))

    def driver(self, name: str) -> tuple[Any, dict[str, Any], Any]:
        """The driver's class, the types that its `__init__` states, and its checked settings."""
        driver = self._load(DRIVERS, self.config.instruments[name].driver, ("instruments", name, "driver"))
        entry, hints = self.config.instruments[name], get_type_hints(driver.__init__)
        if entry.role.split("-")[0] not in driver.roles:
            self.refuse(f"{entry.driver} cannot be the {entry.role}", ("instruments", name, "role"))
        settings = self.settings(name, hints["settings"])
        self._refuse_unsafe(name, entry, settings)
        return driver, hints, settings

    def _refuse_unsafe(self, name: str, entry: InstrumentConfig, settings: Any) -> None:
        """Numbers that are none, and a supply's own statements that would make coils safe by words alone."""
        where = ("instruments", name, "settings")
        for f in fields(settings):
            value = getattr(settings, f.name)
            if isinstance(value, float) and not math.isfinite(value):
                self.refuse("must be a finite number", (*where, f.name))
        axis = entry.role.removeprefix("coil-")
        if axis not in AXES:  # no coil's, or a misspelt one, of which the essentials of a bench know nothing more
            return
        most_A = self.config.cage.limits.current_A[AXES.index(axis)]
        if not 0 < getattr(settings, "zero_current_A", ZERO_IS * most_A) <= ZERO_IS * most_A:
            self.refuse(f"zero is above 0 A and at most {ZERO_IS * most_A:g} A, a quarter of current_A",
                        (*where, "zero_current_A"))  # fmt: skip
        if not getattr(settings, "ramp_A_per_s", 1.0) > 0:
            self.refuse("must be above 0 A/s", (*where, "ramp_A_per_s"))

    def settings(self, name: str, kind: type[T]) -> T:
        """The instrument's settings as its driver's own `Settings`. Raises InputError naming file, line and key."""
        stated, where = self.config.instruments[name].settings, ("instruments", name, "settings")
        known = [f.name for f in fields(kind)]  # type: ignore[arg-type]
        for key in stated:
            if key not in known:
                self.refuse(f"{key} is no setting of this driver; it knows {', '.join(known)}", (*where, key))
        if isinstance(cast(object, self.config), Essentials) and (plain := _plain_settings(kind, stated)) is not None:
            return plain
        from pydantic import TypeAdapter, ValidationError

        try:
            return TypeAdapter(kind).validate_python(stated)
        except ValidationError as error:
            from labcal.bench.config import sentence

            first = error.errors()[0]
            self.refuse(sentence(first), (*where, *map(str, first["loc"])))

    def look_over(self) -> None:
        """See that drivers, settings and links are sound, and no supply is named twice; opens nothing.

        Raises InputError.
        """
        for name, entry in self.config.instruments.items():
            self.driver(name)
            try:
                split(entry.link)
            except InputError as error:
                self.refuse(error.what, ("instruments", name, "link"))
            self._refuse_shared_interlock(name)
            self._refuse_second(name)
            self._refuse_other_spelling(name)

    def _refuse_second(self, name: str) -> None:
        """What the file puts where it has put another before."""
        for other in self._at_the_port_of(name):
            if self._which(other) == self._which(name):
                self.refuse(f"{other} has the same link, address and output", ("instruments", name))

    def _refuse_other_spelling(self, name: str) -> None:
        """One port is one line, whose URL is stated once or always alike."""
        for other in self._at_the_port_of(name):
            if self.line_of(other) != self.line_of(name):
                self.refuse(f"{other} has this port too, and spells it otherwise; write both alike",
                            ("instruments", name, "link"))  # fmt: skip

    def _at_the_port_of(self, name: str) -> list[str]:
        before = takewhile(lambda other: other != name, self.config.instruments)
        return [other for other in before if self._port(other) == self._port(name)]

    def _port(self, name: str) -> str:
        line = self.line_of(name)
        return line if line.startswith("emulated://") else ports.port_of(line)

    def _which(self, name: str) -> tuple[Any, ...]:
        """What tells it from others on its line; nothing that another has, where the file states it wrongly."""
        try:
            settings = self.driver(name)[2]
        except InputError:
            return (name,)
        return tuple(getattr(settings, which, None) for which in WHICH)

    def _refuse_shared_interlock(self, name: str) -> None:
        """What hangs on an interlock's line could keep its heartbeat back, or what it cuts could share its fault."""
        if self.config.instruments[name].role != "interlock":
            return
        for other in self.config.instruments:
            if other != name and self.line_of(other) == self.line_of(name):
                self.refuse(f"an interlock needs a line of its own, and {other} has this one too",
                            ("instruments", name, "link"))  # fmt: skip

    def meet_group(self) -> None:
        """See that locks lie where the group of `[safety]` finds them, if one is named. Raises InputError."""
        if self.config.simulated:
            return
        try:
            ports.meet(self.config.safety.group, self.config.safety.runtime)
        except InputError as error:
            self.refuse(error.what, ("safety", "group"))

    def link(self, name: str) -> Link:
        """The link of one instrument; instruments that state the same link share it."""
        key = self.line_of(name)
        if key not in self.links:
            if key.startswith("emulated://"):
                self.links[key] = EmulatedLink(key, self.emulator(name), self.clock)
            else:
                self.links[key] = self._open(name)
        return self.links[key]

    def line_of(self, name: str) -> str:
        """What instruments on one line have in common: its URL; a bare emulated:// is a line of its own."""
        url = self.config.instruments[name].link
        return url if url != "emulated://" else f"emulated://{name}"

    def _open(self, name: str) -> Link:
        try:
            return open_link(self.config.instruments[name].link, self.clock)
        except InputError as error:
            self.refuse(error.what, ("instruments", name, "link"))

    def modbus(self, name: str) -> ModbusLink:
        """The Modbus master on the line of one instrument; devices on one line share it."""
        line = self.link(name)
        from labcal.bench.links.modbus import modbus_link  # slow to import, and seldom needed

        if line.url not in self.masters:
            self.masters[line.url] = modbus_link(line, self.clock)
        return self.masters[line.url]

    def close(self) -> None:
        """Let go of every link."""
        with ExitStack() as steps:
            for link in self.links.values():
                steps.callback(link.close)

    def refuse(self, what: str, keys: tuple[str, ...]) -> NoReturn:
        """Raise InputError for the key `keys` of this file."""
        from labcal.bench.config import line_of  # to say where: who is not refused waits for none of it

        line = None
        with suppress(OSError, ValueError):  # it may be gone since it was read, or another file
            line = line_of(self.path.read_text(encoding="utf-8"), keys)
        raise InputError(f"{'.'.join(keys)}: {what}", file=self.path, line=line)

    def emulator(self, name: str) -> Emulator:
        """What is emulated on the line of `name`: each device by an emulator of its own, given all its roles."""
        if self.twin is None:
            self.twin = self._twin()
        devices: dict[tuple[str, Any], list[str]] = {}
        for other, entry in self.config.instruments.items():
            if self.line_of(other) == self.line_of(name):
                devices.setdefault((entry.driver, getattr(self.driver(other)[2], "address", None)), []).append(other)
        ends = [self._emulated(names) for names in devices.values()]
        return ends[0] if len(ends) == 1 else SharedWire(ends)

    def _emulated(self, names: list[str]) -> Emulator:
        """The emulator of one device that plays the parts of all these instruments."""
        entries = [self.config.instruments[name] for name in names]
        emulator = self._load(EMULATORS, entries[0].driver, ("instruments", names[0], "driver"))
        roles = {entry.role: entry.settings for entry in entries}
        return cast(Emulator, emulator(self.twin, roles, self.driver(names[0])[2]))

    def _twin(self) -> Any:
        table = dict(self.config.twin)
        kind = table.pop("kind", "cage")
        from pydantic import ValidationError

        from labcal.bench.config import sentence

        try:
            return self._load(TWINS, kind, ("twin", "kind"))(table, self.seed)
        except ValidationError as error:
            first = error.errors()[0]
            self.refuse(sentence(first), ("twin", *map(str, first["loc"])))
        except (ValueError, TypeError) as error:
            self.refuse(str(error), ("twin",))

    def _load(self, group: str, name: str, keys: tuple[str, ...]) -> Any:
        found: Mapping[str, plugin_loading.AnyEntry] = entry_files.entries(group)
        if name not in found:
            found = _installed(group)
        if name not in found:
            if group == EMULATORS:
                where = f'{name} = "module:Class" in [project.entry-points."{EMULATORS}"] of its package'
                self.refuse(f"the driver {name!r} has no emulator: declare {where}, and install again", keys)
            what = "driver" if group == DRIVERS else "twin"
            self.refuse(f"there is no {what} {name!r}; there are {', '.join(sorted(found))}", keys)
        try:
            return plugin_loading.load(found[name])
        except InputError as error:
            self.refuse(str(error), keys)


@cache
def _installed(group: str) -> dict[str, EntryPoint]:
    """What the installed packages bring, by name, wherever they are; to look takes 40 ms."""
    from importlib.metadata import entry_points

    return {entry.name: entry for entry in entry_points(group=group)}


def recogniser(driver: str) -> Callable[[str], dict[str, str] | None]:
    """What tells a driver's settings by an answer to *IDN?; None where it knows no such instrument."""
    return cast("Callable[[str], dict[str, str] | None]", plugin_loading.load(_installed(DRIVERS)[driver]).recognise)


def drivers_of(path: Path, config: BenchConfig) -> None:
    """See that all that can hurt has a driver and sound settings, and load these. Raises InputError."""
    loader = Loader(path, config, RealClock(), 0)
    for name in config.guarded:
        loader.driver(name)


def speaks_modbus(hints: Mapping[str, Any]) -> bool:
    """Whether a driver with these type hints of `__init__` wants registers instead of bytes."""
    return bool(hints["link"].__name__ == "ModbusLink")


def _plain_settings(kind: type[T], stated: Mapping[str, Any]) -> T | None:
    """Settings of values that need no look at a driver's types; None where any is not of its default's, or not above 0.

    For who only switches off and has no time to load what reads types: a session has read the same ones wholly.
    """
    defaults = {f.name: f.default for f in fields(kind)}  # type: ignore[arg-type]
    given = {}
    for key, value in stated.items():
        of = type(defaults[key])
        number = of is float and type(value) is int
        if not (number or (type(value) is of and of in (bool, int, float, str))) or not (value or of is bool):
            return None
        if of in (int, float) and not 0 < value < math.inf:
            return None
        given[key] = float(value) if number else value
    try:
        return kind(**given)
    except (TypeError, ValueError):  # one that has to be stated is not, or its own check refuses it
        return None
