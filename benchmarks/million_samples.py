"""A run of a million samples in the store, opened in the window: seconds until it is shown, and the longest event.

    QT_QPA_PLATFORM=offscreen python benchmarks/million_samples.py [HOME]

HOME keeps the run for the next time. Exit 1 beyond 2 s from Open on the History page to the loci on the Fit page.
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

RUN, RATE_HZ, SECONDS, IN_TIME_S = "million", 1000, 1000, 2.0
TURN_S = 36.0


def record() -> None:
    """Write the run as a bench does: 1 kHz of the DUT, the reference, an angle and a current, committed each second."""
    from labcal.record import ChannelSpec, Dut, Reference, RunHeader, Segment
    from labcal.record.stream import Block, SegmentClosed, SegmentOpened
    from labcal.store import Store

    channel = ChannelSpec("i_eps", "A", "current")
    header = RunHeader(
        RUN, "2026-01-05T07:00:00Z", True, "J. Doe", Dut("EM-07"), Reference("vector"), (channel,), "rate-sweep"
    )
    segment, rng = (
        Segment("z-50uT", "rotation", axis_body=(0.0, 0.0, 1.0), axis_cage=(0.0, 0.0, 1.0)),
        np.random.default_rng(0),
    )
    with Store.open() as store, store.begin(header) as writer:
        writer.write(SegmentOpened(0.0, segment))
        for second in range(SECONDS):
            t = second + np.arange(RATE_HZ) / RATE_HZ
            turn = 2 * np.pi * t / TURN_S
            field = 3e4 * np.column_stack([np.cos(turn), -np.sin(turn), np.ones(len(t))])
            writer.write(Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), t, field + rng.normal(0, 25, field.shape)))
            fixed = np.tile([3e4, 0.0, 3e4], (100, 1))
            writer.write(Block("reference", "ref", ("ref_x", "ref_y", "ref_z"), t[::10], fixed))
            writer.write(Block("angle", "stage", ("angle_deg",), t[::10], np.degrees(turn[::10, None]) % 360))
            writer.write(Block("channel", "dut", ("i_eps",), t[::100], rng.normal(0.4, 0.01, (10, 1))))
            writer.commit()
        writer.write(SegmentClosed(float(SECONDS)))


def main() -> int:
    """Open it, by the clicks of a person."""
    os.environ["LABCAL_HOME"] = sys.argv[1] if len(sys.argv) > 1 else tempfile.mkdtemp(prefix="labcal-million-")
    from labcal.store import Store

    with Store.open() as store:
        there = any(one.run_id == RUN for one in store.runs())
    if not there:
        record()
    from window_budget import timed_application

    application = timed_application()
    from PySide6.QtCore import QSettings

    from labcal.gui.theming.theme import LIGHT
    from labcal.gui.viewmodels.app_state import AppState
    from labcal.gui.window import Window

    window = Window(
        AppState(QSettings(str(Path(os.environ["LABCAL_HOME"]) / "w.ini"), QSettings.Format.IniFormat)), LIGHT
    )
    window.show()
    for name in ("History", "Fit"):
        window.page(name)
    window.app_state.study_vm.prepare()  # as the window itself does, soon after it is up
    window.open_page("History")
    history, study = window.page("History"), window.app_state.study_vm

    def until(so: object) -> float:
        begun = time.perf_counter()
        while not so():
            if window.fault.isVisible() or study.fault is not None or time.perf_counter() > begun + 120:
                sys.exit(f"it never came: {study.fault}")
            application.processEvents()
            time.sleep(0.001)
        return time.perf_counter() - begun

    until(lambda: history.table.rowCount() > 0 and not window.app_state.quick_worker.busy)
    history.table.selectRow(0)
    until(lambda: not window.app_state.quick_worker.busy and bool(study.methods))
    application.forget()
    history.open.click()
    took_s = until(lambda: study.look is not None and window.page("Fit").isVisible())
    print(f"a run of {study.look['n_samples']} samples is shown {took_s:.2f} s after Open; {application.longest()}")
    window.close()
    return int(took_s > IN_TIME_S)


if __name__ == "__main__":
    sys.exit(main())
