"""A run of the store as a list shows it."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class RunLine:
    """A run of the store in one line, with the verdict and figures of its loop where there is one."""

    run_id: str
    started_utc: str
    status: str
    dut_serial: str
    operator: str
    procedure: str
    simulated: bool = False
    verdict: str = ""
    site: str = ""  # of a run of the archive, and which one it is there: names of runs repeat
    sha256: str = ""
    left_nT: tuple[float, float, float] | None = None  # by its loop: before, after, and noise alone
    stopped: bool = False  # by a person
    by_off: bool = False  # and that by COILS OFF
    bench: str = ""  # of an interrupted one: the name of that which it was begun on
    instruments: tuple[tuple[str, str], ...] = ()  # who answered there then: name, and as it said who it is
    bench_kind: str = ""  # whether that is real, simulated, or a simulated one on lines of this computer
