"""The benches of the campaign: the example's lab with supplies of several kinds, and the process that serves one."""

from __future__ import annotations

import json
import os
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"
SERVES = Path(__file__).with_name("faulty_lab.py")
ALL = ("tti", "korad", "riden-pair", "kepco")
WITH_CONTACTS = ("tti", "korad", "riden-pair")
LINES_OF_THEIR_OWN = ("tti", "korad", "kepco")
WITH_AN_INTERLOCK, WITH_WATCHDOGS = "interlock", "watchdogs"
WATCHDOG_S = 2  # of either
DRIVERS = {
    "tti": "tti-pl", "korad": "korad-ka3005p", "riden-pair": "riden-rd60xx", "kepco": "kepco-bop",
    WITH_AN_INTERLOCK: "tti-pl", WITH_WATCHDOGS: "keysight-e36300",
}  # fmt: skip
INTERLOCK = f"""[instruments.interlock]
driver = "waveshare-interlock"
link = "emulated://"
role = "interlock"
settings = {{ watchdog_s = {WATCHDOG_S} }}

"""


def bench_text(kind: str) -> str:
    """The example's bench file with three supplies of this kind, otherwise as it stands."""
    text = EXAMPLE.read_text(encoding="utf-8").replace("settle_s = 0.3", "settle_s = 0.15")
    text = text.replace("surprise = true", "")
    for number, axis in enumerate("xyz", 1):
        of_tti = f'driver = "tti-pl"\nlink = "emulated://"\nrole = "coil-{axis}"'
        assert of_tti in text
        new = of_tti.replace("tti-pl", DRIVERS[kind])
        if kind == "riden-pair":
            new = new.replace("emulated://", "emulated://pair") + f"\nsettings = {{ address = {number} }}"
        if kind == "korad":  # deaf for 80 ms after each command, as it sees them: the lab's process may see one late
            new += "\nsettings = { gap_s = 0.13 }"
        if kind == WITH_WATCHDOGS:
            new += f"\nsettings = {{ watchdog_s = {WATCHDOG_S} }}"
        text = text.replace(of_tti, new)
    if kind == WITH_WATCHDOGS:  # their outputs drive 6 V
        text += "coils = { resistance_ohm = 3.0 }\n"
    if kind == WITH_AN_INTERLOCK:
        text = text.replace("[instruments.stage]", f"{INTERLOCK}[instruments.stage]")
    return text if kind != "kepco" else _without(text, "reversers")


def _without(text: str, name: str) -> str:
    """`text` without the table of this instrument."""
    before, _, after = text.partition(f"[instruments.{name}]")
    return before + after[after.index("\n[") + 1 :]


class Bench:
    """One bench, served by a process; `ask` asks that one what is true. `served`: it says that it is simulated."""

    def __init__(self, kind: str, *, served: bool = False) -> None:
        self.kind, self.folder = kind, Path(tempfile.mkdtemp(prefix="camp-", dir="/tmp"))
        source, self.file = self.folder / "bench.toml", self.folder / "served.toml"
        source.write_text(bench_text(kind), encoding="utf-8")
        address = str(self.folder / "truth")
        env = os.environ | {"OPENBLAS_NUM_THREADS": "1"}
        self._process = subprocess.Popen(
            [sys.executable, str(SERVES), str(source), str(self.file), address, *(["served"] if served else [])],
            stdout=subprocess.PIPE, text=True, env=env,
        )  # fmt: skip
        assert self._process.stdout is not None
        assert self._process.stdout.readline() == "ready\n"
        self._truth = socket.socket(socket.AF_UNIX)
        self._truth.connect(address)
        self._lines = self._truth.makefile("rb")

    def ask(self, do: str, **what: Any) -> Any:
        """What the lab's own socket answers."""
        self._truth.sendall(json.dumps({"do": do} | what).encode() + b"\n")
        return json.loads(self._lines.readline())

    def env(self, home: Path) -> dict[str, str]:
        """Of this folder's labcal, whichever is installed, on this bench; nothing of this user's but his home."""
        runtime = self.folder / "run"
        runtime.mkdir(exist_ok=True)
        kept = {key: value for key, value in os.environ.items() if key in ("PATH", "HOME", "LANG")}
        return kept | {
            "TMPDIR": str(runtime), "LABCAL_HOME": str(home), "OPENBLAS_NUM_THREADS": "1",
            "QT_QPA_PLATFORM": "offscreen", "TERM": "xterm", "PYTHONPATH": str(EXAMPLE.parents[1]),
        }  # fmt: skip

    def line_of(self, axis: str) -> str:
        """The name under which the lab knows the line of this axis' supply."""
        return f"supply_{axis}"

    def axes_on_line(self, axis: str) -> str:
        """The axes that share a line with this one."""
        return "xyz" if self.kind == "riden-pair" else axis

    def at_rest(self) -> bool:
        """Whether nothing flows."""
        return max(self.ask("currents").values()) < 0.005

    def close(self) -> None:
        """The process ends and its files go."""
        self._lines.close()
        self._truth.close()
        self._process.kill()
        self._process.communicate()
        shutil.rmtree(self.folder, ignore_errors=True)


def until(true: Any, at_most_s: float) -> bool:
    """Wait until `true()`; False where it is not within that time."""
    begun = time.monotonic()
    while not (now := true()) and time.monotonic() - begun < at_most_s:
        time.sleep(0.03)
    return bool(now)
