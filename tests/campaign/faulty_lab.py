"""A bench's emulated instruments on faulty lines, in a process of its own, and a socket that tells the truth.

`python faulty_lab.py BENCH OUT SOCKET [served]` writes OUT, the bench file with real links, and prints `ready`; with
`served` all of them are ports, and OUT says that it is simulated, as `labcal bench serve` does. The socket takes one
JSON object a line, {"do": NAME, …}, and answers with one: labcal does not know of it.
"""

from __future__ import annotations

import json
import os
import random
import select
import socket
import sys
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
from faulty_ends import End, PtyEnd, TcpEnd
from faulty_line import WELL, FaultyLine, Trouble
from faulty_supply import Front, clear_watchdog, panel

from labcal.bench.clock import RealClock
from labcal.bench.config import AXES, read_config
from labcal.bench.links import Nobody
from labcal.bench.loading import Loader, speaks_modbus
from labcal.bench.serve import toml
from labcal.files.atomic import write_text
from labcal.twin.coils import Coil

LONGEST_S = 0.1
AHEAD = -10  # instruments do not wait for this machine; where it may not be asked for, they do


class FaultyLab:
    """The simulated lab, its lines, and everything that can go wrong with them."""

    def __init__(self, path: Path, out: Path, served: bool = False) -> None:
        self.clock, self._served = RealClock(), served
        self._zero_s = time.monotonic() - self.clock.now()  # of the bench's clock, on the machine's
        self._loader = Loader(path, config := read_config(path), self.clock, 0)
        self._loader.twin = self._loader._twin()
        self._fronts = {axis: Front(coil) for axis, coil in self._loader.twin.coils.items()}
        self._loader.twin.coils = self._fronts
        self._sent = {axis: Front(Coil(front.resistance_ohm, front.tau_s)) for axis, front in self._fronts.items()}
        self._overhearing = Loader(path, config, self.clock, 0, twin=SimpleNamespace(coils=self._sent))
        self._whole = (self._loader.twin.reference_nT, self._loader.twin.dut_reading, self._loader.twin.ambient)
        self.lines = dict[str, FaultyLine]()
        self._axes = dict[str, str]()  # of which line each supply is
        for name in config.instruments:
            self._lay(name, out.parent)
        self._plugged = {name: line.hears for name, line in self.lines.items()}
        table = config.model_dump(mode="json", exclude_defaults=True) | ({"served": True} if served else {})
        for name in config.instruments:
            table["instruments"][name]["link"] = self._line(name).end.url
        write_text(out, toml(table))

    def _lay(self, name: str, folder: Path) -> None:
        entry, url = self._loader.config.instruments[name], self._loader.line_of(name)
        if entry.role.startswith("coil-"):
            self._axes[entry.role[-1]] = url
        if url not in self.lines:
            device = self._loader.emulator(name)
            supply = entry.role.startswith("coil-")
            overhears = self._overhearing.emulator(name) if supply else Nobody()
            end: End
            scheme = "modbus-rtu" if speaks_modbus(self._loader.driver(name)[1]) else "serial"
            if getattr(device, "wire", "serial") == "tcp":
                end = TcpEnd("tcp")
            else:
                end = TcpEnd(scheme) if self._served else PtyEnd(scheme, folder / name)
            self.lines[url] = FaultyLine(name, end, device, overhears)

    def _line(self, name: str) -> FaultyLine:
        return self.lines[self._loader.line_of(name)]

    # what the socket may be told

    def trouble(self, name: str, seed: int = 0, **what: Any) -> None:
        """Something is wrong with the line of `name` from now on."""
        self._line(name).chance = random.Random(seed)
        self._line(name).trouble = Trouble(**what)

    def half_open(self, name: str) -> None:
        """The connection that is there is served by nobody."""
        self._line(name).end.half_open()

    def unplug(self, name: str) -> None:
        """Its cable is out."""
        self._line(name).unplug()

    def plug(self, name: str) -> None:
        """Its cable is in."""
        self._line(name).end.plug()

    def swap(self, one: str, other: str) -> None:
        """Each cable goes into the other's instrument."""
        a, b = self._line(one), self._line(other)
        a.hears, b.hears = b.hears, a.hears

    def lie(self, axis: str, measures_truly: bool) -> None:
        """This supply says yes and does nothing."""
        self._fronts[axis].lie(measures_truly)

    def panel(self, axis: str, current_A: float, on: bool) -> None:
        """This supply has these values by itself."""
        device = self._plugged[self._axes[axis]]
        panel(device, self._fronts[axis], self.clock.now(), current_A, on)

    def freeze(self, role: str) -> None:
        """The reference or the DUT repeats its reading."""
        twin = self._loader.twin
        if role == "reference":
            at = twin.reference_nT(np.array([self.clock.now()]))
            twin.reference_nT = lambda t_s: np.repeat(at, len(t_s), axis=0)
        else:
            reading, channels = twin.dut_reading(np.array([self.clock.now()]))
            twin.dut_reading = lambda t_s: (
                np.repeat(reading, len(t_s), axis=0),
                {name: np.repeat(values, len(t_s)) for name, values in channels.items()},
            )

    def truck(self, field_nT: list[float]) -> None:
        """Something magnetic has stopped beside the cage."""
        ambient = self._loader.twin.ambient
        self._loader.twin.ambient = replace(ambient, earth_nT=ambient.earth_nT + np.array(field_nT))

    def well(self) -> None:
        """Everything is well again."""
        twin = self._loader.twin
        twin.reference_nT, twin.dut_reading, twin.ambient = self._whole
        for front in self._fronts.values():
            front.repent(self.clock.now())
        for url, line in self.lines.items():
            line.trouble, line.hears = WELL, self._plugged[url]
            line.end.plug()
        for device in self._plugged.values():
            if hasattr(device, "has_watchdog"):
                clear_watchdog(device, self.clock.now())

    def currents(self) -> dict[str, float]:
        """What flows now [A]."""
        return {axis: abs(float(front.coil.current.now(self.clock.now()))) for axis, front in self._fronts.items()}

    def begin(self) -> None:
        """Forget what was: a trial begins."""
        for front in (*self._fronts.values(), *self._sent.values()):
            del front.orders[:-1]
            front.coil.current = _now_only(front.coil.current, self.clock.now())
        for line in self.lines.values():
            line.log.clear()

    def truth(self) -> dict[str, Any]:
        """All since the trial began, at the machine's monotonic clock: what flowed, was sent, was heard, and when."""
        return {
            "now_s": time.monotonic(),
            "tau_s": {axis: front.tau_s for axis, front in self._fronts.items()},
            "flow": {axis: self._flow(front.coil.current) for axis, front in self._fronts.items()},
            "heard": {axis: self._moved(front.orders) for axis, front in self._fronts.items()},
            "sent": {axis: self._moved(front.orders) for axis, front in self._sent.items()},
        }

    def bytes_on(self, name: str) -> list[Any]:
        """Every piece that was sent, heard and said on a supply's line."""
        return self._moved(self._line(name).log)

    def _flow(self, current: Any) -> list[list[float]]:
        """From when, from what, to what."""
        rows = zip(current._t, current._from, current._to, strict=True)
        return [[max(t + self._zero_s, 0.0), a, b] for t, a, b in rows]

    def _moved(self, stamped: list[Any]) -> list[Any]:
        return [[t + self._zero_s, *rest] for t, *rest in stamped]


def _now_only(current: Any, now: float) -> Any:
    fresh = type(current)(current._tau)
    fresh._from, fresh._to = [current.now(now)], [current.target]
    return fresh


class Telling:
    """The socket on which the truth is asked."""

    def __init__(self, address: str, lab: FaultyLab) -> None:
        self._listener = socket.socket(socket.AF_UNIX)
        self._listener.bind(address)
        self._listener.listen()
        self._callers = dict[int, socket.socket]()
        self._lab = lab

    def files(self) -> list[int]:
        """What becomes readable."""
        return [self._listener.fileno(), *self._callers]

    def look(self, readable: list[int]) -> None:
        """Answer who has asked."""
        if self._listener.fileno() in readable:
            caller = self._listener.accept()[0]
            self._callers[caller.fileno()] = caller
        for file in set(readable) & set(self._callers):
            self._answer(file)

    def _answer(self, file: int) -> None:
        line = b""
        with suppress(OSError):
            while not line.endswith(b"\n") and (piece := self._callers[file].recv(65536)):
                line += piece
        if not line:
            self._callers.pop(file).close()
            return
        said = json.loads(line)
        do: Callable[..., Any] = getattr(self._lab, said.pop("do"))
        self._callers[file].sendall(json.dumps(do(**said)).encode() + b"\n")


def main(bench: Path, out: Path, address: str, served: bool) -> None:
    """Serve until the process is ended, or the one that began it is gone."""
    parent = os.getppid()
    with suppress(PermissionError):
        os.nice(AHEAD)
    lab = FaultyLab(bench, out, served)
    telling = Telling(address, lab)
    print("ready", flush=True)
    while os.getppid() == parent:
        for line in lab.lines.values():
            line.carry(lab.clock.now())
        now = lab.clock.now()
        wait_s = min(line.due_s(now) for line in lab.lines.values()) - now
        files = [file for line in lab.lines.values() for file in line.end.files()]
        telling.look(select.select([*files, *telling.files()], [], [], min(max(wait_s, 0.0), LONGEST_S))[0])


if __name__ == "__main__":
    assert set(AXES) == set("xyz")
    main(Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3], sys.argv[4:] == ["served"])
