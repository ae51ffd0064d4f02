"""States of the lab as a worker tells them: just read, or some time ago."""

from __future__ import annotations

import time

from labcal.bench.coils.state import CoilReading, LabState, Witness

SEEN = {"seen_nT": (20_400.0, 1_150.0, -43_700.0), "expected_nT": (20_400.0, 1_150.0, -43_700.0)}


def told(to, currents=(0.0, 0.0, 0.0), *, verdict="agrees", age_s=0.0):
    """The worker (of the window) `to` says how the coils are; a current of None was not read back."""
    worker = to.app_state.bench_worker if hasattr(to, "app_state") else to
    read_s = time.monotonic() - age_s
    coils = tuple(
        CoilReading(
            axis, None, i, i is not None and abs(i) < 0.005, None, read_s, f"{axis}: silent" if i is None else ""
        )
        for axis, i in zip("xyz", currents, strict=True)
    )
    witness = Witness(verdict, "no ambient field", **SEEN, difference_nT=98_900.0, limit_nT=2_000.0, read_s=read_s)
    worker.states.emit(LabState(coils, witness))


def runs_of(qtbot, window):
    """Ids of the runs of its store, as the History page has them."""
    window.open_page("History")
    page = window.page("History")
    page.search.clear()
    qtbot.waitUntil(lambda: page.table.rowCount() > 0, timeout=180_000)
    return [page.table.text(row, 6) for row in range(page.table.rowCount())]


def silent(axis, read_s):
    """A coil that was not read back."""
    return CoilReading(axis, read_s=read_s, fault=f"{axis}: silent")
