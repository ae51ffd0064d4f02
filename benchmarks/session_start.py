"""How long a session takes to begin where each reply of seven instruments is 200 ms late: `session_start.py [TIMES]`.

The example's lab on ports and ptys of this computer, served by a process of its own; every reply is on the line 200 ms
later than its emulator has it. Three supplies and their relay board are identified by the guardian, a process that
begins with the session; a stage, a reference and the DUT beside it.
"""

from __future__ import annotations

import math
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from labcal.bench import open_bench
from labcal.bench import serve as serving

LATE_S = 0.2
EXAMPLE = Path(__file__).parents[1] / "examples" / "simulated.toml"


class Late:
    """An emulator whose replies come later; what it sends by itself (it never heard anything) does not."""

    def __init__(self, emulator: Any) -> None:
        self._emulator, self._waiting, self._asked = emulator, list[tuple[float, bytes]](), False

    def take(self, t_s: float, data: bytes) -> None:
        """Bytes from the host."""
        self._asked = True
        self._emulator.take(t_s, data)

    def due_s(self) -> float:
        """When it says something next."""
        inner = getattr(self._emulator, "due_s", lambda: math.inf)()
        return min(inner, self._waiting[0][0] if self._waiting else math.inf)

    def emit(self, until_s: float) -> list[tuple[float, bytes]]:
        """What is due."""
        late_s = LATE_S if self._asked else 0.0
        self._waiting += [(t_s + late_s, data) for t_s, data in self._emulator.emit(until_s)]
        due = [piece for piece in self._waiting if piece[0] <= until_s]
        self._waiting = self._waiting[len(due) :]
        return due


def serve_late(out: Path) -> None:
    """Serve until killed."""
    pump = serving._pump
    serving._pump = lambda lines, clock: pump([(outlet, Late(emulator)) for outlet, emulator in lines], clock)
    serving.serve(EXAMPLE, out, lambda: print("ready", flush=True))


def main(times: int) -> None:
    """Begin a session so often; print how long each took until all seven had said who they are."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "served.toml"
        command = [sys.executable, __file__, "--serve", str(out)]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as child:
            assert child.stdout is not None
            assert child.stdout.readline() == "ready\n"
            try:
                for _ in range(times):
                    begun = time.monotonic()
                    with open_bench(out) as bench:
                        all_s = time.monotonic() - begun
                        many = len(bench.instruments())
                    print(f"{many} instruments, each reply {1000 * LATE_S:g} ms late: {all_s:.2f} s")
            finally:
                child.kill()


if __name__ == "__main__":
    if sys.argv[1:2] == ["--serve"]:
        serve_late(Path(sys.argv[2]))
    else:
        main(int(sys.argv[1]) if len(sys.argv) > 1 else 3)
