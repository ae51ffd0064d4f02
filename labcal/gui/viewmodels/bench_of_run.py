"""The bench that a run is driven on, as far as the run has to know it. No widgets."""

from __future__ import annotations

from labcal.gui.ipc.bench_facts import Bench
from labcal.gui.viewmodels.run import RunViewModel


def links_of(bench: Bench) -> dict[str, str]:
    """Over which link each instrument is heard, by its name."""
    return {name: one.link for name, one in bench.instruments.items()}


def stands_on(run: RunViewModel, bench: Bench) -> None:
    """The next run is of this bench: the unit of its DUT, its clock, and its links."""
    run.nominal_nT_per_unit, run.virtual_time = bench.dut.nominal_nT_per_unit, bench.virtual_time
    run.links = links_of(bench)


def limits_of(bench: Bench | None) -> tuple[tuple[str, ...], float | None]:
    """The power modes that the DUT of a bench may be in, and how fast it may be turned there."""
    return ((), None) if bench is None else (bench.modes, bench.fastest_deg_per_s)
