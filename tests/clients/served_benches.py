"""Emulators on real lines, as `labcal bench serve` puts them there: what other people's programs are let loose on."""

from __future__ import annotations

import json
import os
import select
import signal
import subprocess
import sys
import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlsplit

EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"
LONG_S = 300.0  # a busy machine gets there, a broken one does not
ROLES = ("coil-x", "coil-y", "coil-z", "polarity", "platform", "reference", "dut")
Part = tuple[str, dict[str, Any]]  # driver, settings
SERVE = """
import sys, threading
from pathlib import Path
from labcal.bench.serve import serve
from labcal.errors import InputError
def told(file):
    try:
        serve(Path(file), Path(file).with_suffix(".served"), lambda: print("ready\\n", end="", flush=True))
    except InputError as why:
        print(f"{why}\\n", end="", flush=True)
for file in sys.argv[1:]:
    threading.Thread(target=told, args=(file,), daemon=True).start()
threading.Event().wait()
"""


def table(model: str) -> Part:
    """A supply of `drivers/tables`."""
    return "scpi-table", {"model": model}


RELAY: Part = ("waveshare-relay", {"x": 0, "y": 1, "z": 2})
LINE: Part = ("csv-line", {"columns": ["t", "x", "y", "z", "temp_dut"]})
BENCHES: tuple[tuple[Part, ...], ...] = (  # in the order of ROLES
    (("tti-pl", {}), ("rigol-dp800", {}), ("keysight-e36300", {}), RELAY, ("zaber", {}), ("hmr2300", {}), LINE),
    (("kepco-bop", {}), ("korad-ka3005p", {}), ("riden-rd60xx", {"address": 1}), RELAY,
     ("newport-esp301", {}), ("metrolab", {}), ("pmag", {})),
    (("ea-9000", {"address": 1}), ("ea-ps2000b", {}), ("microcontroller", {}), RELAY,
     ("newport-smc100", {}), ("alphalab", {}), ("ccsds", {"apid": 42})),
    (table("siglent-spd3303x"), table("rohde-schwarz-hmp"), table("keithley-2200"), RELAY,
     ("oriental-az", {"address": 1}), ("labjack-t7", {"uT_per_V": [10.0, 10.0, 10.0]}), ("mavlink", {})),
    (table("siglent-spd1000x"), table("bk-9130b"), table("agilent-66xx"), RELAY,
     ("leadshine", {"address": 1}), ("gsm", {"period_s": 0.25}), LINE),
    (table("delta-sm"), table("agilent-e3631a"), ("genesys", {}), RELAY,
     ("thorlabs-apt", {}), ("twinleaf", {}), ("i2c-board", {"chip": "lis3mdl"})),
    (table("keithley-2260b"), table("kikusui-pbz"), table("rohde-schwarz-hmc804x"), RELAY,
     ("trinamic-tmcl", {"address": 1}), ("pos-1", {}), LINE),
    (table("keithley-2260b"), table("kikusui-pbz"), table("rohde-schwarz-hmc804x"), RELAY,
     ("standa-8smc5", {}), ("pos-1", {}), LINE),
)  # fmt: skip


@dataclass(frozen=True)
class Line:
    """Where an emulator is to be met: a port of this machine, or a pty."""

    link: str

    @property
    def port(self) -> int:
        """Of TCP; 0 for a pty."""
        return urlsplit(self.link.replace("socket://", "")).port or 0

    @property
    def path(self) -> str:
        """Of a pty."""
        return urlsplit(self.link).path

    @property
    def baud(self) -> int:
        """At which it listens."""
        return int(parse_qs(urlsplit(self.link).query)["baud"][0])

    @property
    def visa(self) -> str:
        """The same for VISA."""
        return f"TCPIP::127.0.0.1::{self.port}::SOCKET" if self.port else f"ASRL{self.path}::INSTR"


class Lab:
    """Every bench of BENCHES, served by one process."""

    def __init__(self, folder: Path) -> None:
        files = [folder / f"{number}.toml" for number in range(len(BENCHES))]
        for file, parts in zip(files, BENCHES, strict=True):
            file.write_text(bench_text(parts), encoding="utf-8")
        self._child = subprocess.Popen([sys.executable, "-c", SERVE, *map(str, files)], stdout=subprocess.PIPE)
        try:
            self._await_ready(len(files))
        except AssertionError:
            self.close()
            raise
        self._links = [_links(file.with_suffix(".served")) for file in files]

    def _await_ready(self, benches: int) -> None:
        out, said = self._child.stdout, b""
        assert out is not None
        while said.count(b"\n") < benches:
            assert select.select([out], [], [], LONG_S)[0], f"not served within {LONG_S:g} s"
            part = os.read(out.fileno(), 4096)
            assert part, f"the serving has ended: {said.decode()}"
            said += part
        assert said == b"ready\n" * benches, said.decode()

    def line(self, instrument: str) -> Line:
        """Of a driver's emulator, or of a table's."""
        number, role = WHERE[instrument]
        return Line(self._links[number][role])

    def close(self) -> None:
        """End it."""
        self._child.send_signal(signal.SIGTERM)
        self._child.communicate()


def bench_text(parts: tuple[Part, ...]) -> str:
    """The example's lab with these instruments."""
    head, rest = EXAMPLE.read_text(encoding="utf-8").split("[instruments.", 1)
    blocks = [head]
    for role, (driver, settings) in zip(ROLES, parts, strict=True):
        stated = ", ".join(f"{key} = {json.dumps(value)}" for key, value in settings.items())
        blocks.append(f'[instruments.{role}]\ndriver = "{driver}"\nlink = "emulated://"\nrole = "{role}"\n'
                      f"settings = {{ {stated} }}\n")  # fmt: skip
    return "\n".join([*blocks, "[twin]" + rest.split("[twin]", 1)[1]])


def _links(served: Path) -> dict[str, str]:
    instruments = tomllib.loads(served.read_text(encoding="utf-8"))["instruments"]
    return {entry["role"]: entry["link"] for entry in instruments.values()}


def _places() -> dict[str, tuple[int, str]]:
    found = dict[str, tuple[int, str]]()
    for number, parts in enumerate(BENCHES):
        for role, (driver, settings) in zip(ROLES, parts, strict=True):
            found.setdefault(str(settings.get("model", driver)), (number, role))
    return found


WHERE = _places()
