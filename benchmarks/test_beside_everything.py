"""1 kHz from the DUT beside everything else on real lines, the field on and the platform turning: nothing lost.

The example's lab with an interlock, on ports and ptys of a process of its own; supplies, relays and interlock belong to
their guardian. Every line of the DUT is stamped by its own clock. `pytest benchmarks/test_beside_everything.py -s`
"""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from drivers.emulators.csv_line import CsvLineEmulator
from drivers.emulators.streaming import SampleClock
from labcal.bench import open_bench
from labcal.bench import serve as serving
from labcal.bench.clock import RealClock
from labcal.record.stream import Block, Event
from labcal.runner import find, run_procedure, yes_to_all
from labcal.store import Store

EXAMPLE = Path(__file__).parents[1] / "examples" / "simulated.toml"
RATE_HZ, TOGETHER_S = 1000.0, 0.01
INTERLOCK = '[instruments.guard]\ndriver = "waveshare-interlock"\nlink = "emulated://"\nrole = "interlock"\n\n'
TURNS = {"rate_deg_per_s": "20", "zero_s": "10", "inclination_deg": "50"}


class Bunched:
    """A DUT of 1 kHz whose lines leave a hundred times a second."""

    def __init__(self, emulator: Any, now_s: float) -> None:
        self._emulator, self._left_s = emulator, now_s
        emulator._beat = SampleClock(RATE_HZ, round(now_s, 3))

    def take(self, t_s: float, data: bytes) -> None:
        """It does not listen."""

    def due_s(self) -> float:
        """When it sends next."""
        return self._left_s + TOGETHER_S

    def emit(self, until_s: float) -> Any:
        """The lines that are due."""
        if until_s < self.due_s():
            return []
        self._left_s = until_s
        return self._emulator.emit(until_s)


def serve_fast(bench: Path, out: Path) -> None:
    """Serve until killed; the DUT on a TCP port, for a pty holds 70 ms of its lines."""
    pump, usual = serving._pump, serving.outlet_of

    def outlet(emulator: Any, modbus: bool) -> Any:
        return serving.TcpOutlet("tcp") if isinstance(emulator, CsvLineEmulator) else usual(emulator, modbus)

    def fast(lines: list[tuple[Any, Any]], clock: Any) -> None:
        now_s = clock.now()
        pump([(o, Bunched(e, now_s) if isinstance(e, CsvLineEmulator) else e) for o, e in lines], clock)

    serving.outlet_of, serving._pump = outlet, fast
    serving.serve(bench, out, lambda: print("ready", flush=True))


@contextmanager
def served(folder: Path) -> Iterator[Path]:
    """That lab on real lines."""
    text = EXAMPLE.read_text(encoding="utf-8").replace("[instruments.stage]", INTERLOCK + "[instruments.stage]")
    text = text.replace('serial = "SIM-0001" }', 'serial = "SIM-0001", stamp = "device" }')
    (bench := folder / "bench.toml").write_text(text, encoding="utf-8")
    out = folder / "served.toml"
    with subprocess.Popen([sys.executable, __file__, bench, out], stdout=-1, text=True) as process:
        try:
            assert process.stdout is not None
            assert process.stdout.readline() == "ready\n"
            yield out
        finally:
            process.kill()


def test_no_row_is_lost_beside_everything(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("LABCAL_HOME", str(tmp_path / "home"))
    clock = RealClock()
    with served(tmp_path) as bench, closing(open_bench(bench, clock=clock)) as opened, Store.open() as store:
        begun, busy = time.monotonic(), time.process_time()
        outcome = run_procedure(opened, find("rotate-axis"), TURNS, store=store, answer=yes_to_all(True))
        took, busy = time.monotonic() - begun, time.process_time() - busy
        items, run = list(store.items(outcome.run_id)), store.run(outcome.run_id)
    assert outcome.status == "finished", outcome.fault
    rows = {name: stamps(items, name) for name in ("dut", "reference", "angle")}
    steps = np.round(np.diff(rows["dut"]) * RATE_HZ).astype(int)
    lost, twice = int(np.sum(steps[steps > 1] - 1)), int(np.sum(steps < 1))
    said = [i for i in items if isinstance(i, Event) and i.kind == "stream"]
    print(f"\n{took:.0f} s, {len(rows['dut'])} rows of the DUT, {lost} lost, {twice} twice; beside them")
    beside = f"{len(rows['reference'])} of the reference, {len(rows['angle'])} angles"
    print(f"{beside}; {100 * busy / took:.0f} % of a core")
    assert (lost, twice, said) == (0, 0, [])
    assert len(rows["dut"]) > 0.97 * RATE_HZ * (rows["dut"][-1] - rows["dut"][0]) > 20_000
    assert len(rows["reference"]) >= 20 * np.ptp(rows["reference"]) - 2, "20 a second"
    assert np.isfinite(run.reading).all()


def stamps(items: list[Any], stream: str) -> np.ndarray:
    """When the samples of a stream were, as recorded."""
    return np.concatenate([i.t_s for i in items if isinstance(i, Block) and i.stream == stream])


if __name__ == "__main__":
    serve_fast(Path(sys.argv[1]), Path(sys.argv[2]))
