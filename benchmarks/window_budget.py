"""The window's budget: 20 s of 1 kHz data through a worker process, the longest event, and what got lost.

    QT_QPA_PLATFORM=offscreen python benchmarks/window_budget.py

Prints the longest event of the loop (by the clock, and by the processor's own time, which a busy computer does not
stretch), the repaints a second and the rows that arrived; exit 1 beyond 50 ms of work or with a row lost.
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from typing import Any

import numpy as np

RATE_HZ, SECONDS, BATCH_S, LONGEST_MS = 1000, 20, 0.04, 50.0


def feed() -> None:
    """Be the worker: answer the first request with 20 s of samples at their true pace."""
    from labcal.gui.ipc.answers import Ended
    from labcal.gui.ipc.channel import stdio_channel
    from labcal.gui.ipc.codec import encode
    from labcal.gui.ipc.messages import Done
    from labcal.record import Segment
    from labcal.record.stream import Block, SegmentOpened, Step

    channel = stdio_channel()
    request = next(iter(channel.requests()))
    channel.send_item(Step(0.0, 1, 1, "turn", float(SECONDS), ("turn",)))
    channel.send_item(SegmentOpened(0.0, Segment("turn", "rotation")))
    begun, sent = time.monotonic(), 0
    while sent < RATE_HZ * SECONDS:
        time.sleep(BATCH_S)
        upto = min(RATE_HZ * SECONDS, int((time.monotonic() - begun) * RATE_HZ))
        t = np.arange(sent, upto) / RATE_HZ
        field = 2e4 * np.column_stack([np.cos(t), np.sin(t), np.full(len(t), 0.5)])
        channel.send_item(Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), t, field))
        channel.send_item(Block("angle", "stage", ("angle_deg",), t[:1], np.degrees(t[:1, None])))
        sent = upto
    channel.flush()
    channel.send(Done(request.number, encode(Ended("budget", "finished"))))


def timed_application() -> Any:
    """A QApplication that knows how long its longest event took."""
    from PySide6.QtCore import QEvent, QObject
    from PySide6.QtWidgets import QApplication

    class Timed(QApplication):
        """Times every event, by the clock and by the processor's own time, which a busy computer does not stretch."""

        def __init__(self) -> None:
            super().__init__([])
            self.depth, self.kind = 0, "all"
            self.forget()

        def forget(self) -> None:
            """Begin anew."""
            self.kinds: dict[str, tuple[float, float, str]] = {}  # clock, work [ms], and what the most work was

        @property
        def worked_ms(self) -> float:
            """The most work of an event."""
            return max((worked for _, worked, _ in self.kinds.values()), default=0.0)

        def longest(self) -> str:
            """The longest event in words."""
            longest = max(clock for clock, _, _ in self.kinds.values())
            worked, what = max((worked, what) for _, worked, what in self.kinds.values())
            return f"longest event {longest:.1f} ms by the clock, {worked:.1f} ms of work ({what})"

        def table(self) -> str:
            """The longest event of each kind, the most work first."""
            rows = sorted(((worked, clock, kind, what) for kind, (clock, worked, what) in self.kinds.items()))[::-1]
            return "\n".join(f"{worked:7.1f} ms of work  {clock:7.1f} ms by the clock  {kind}: {what}"
                             for worked, clock, kind, what in rows)  # fmt: skip

        def notify(self, receiver: QObject, event: QEvent) -> bool:
            """Hand the event on, timed."""
            if self.depth:  # a part of another one: asking for the time is dear itself
                return super().notify(receiver, event)
            self.depth, begun, worked = 1, time.perf_counter(), time.thread_time()
            done = super().notify(receiver, event)
            self.depth = 0
            self._keep(1000 * (time.perf_counter() - begun), 1000 * (time.thread_time() - worked), receiver, event)
            return done

        def _keep(self, took_ms: float, worked_ms: float, receiver: QObject, event: QEvent) -> None:
            longest, most, what = self.kinds.get(self.kind, (0.0, -1.0, ""))
            if worked_ms > most:
                what = f"{event.type().name} of {type(receiver).__name__}"
            self.kinds[self.kind] = max(longest, took_ms), max(most, worked_ms), what

    return Timed()


def main() -> int:
    """Show the Run page while the data comes, and time every event."""
    from PySide6.QtCore import QSettings

    os.environ["LABCAL_HOME"] = tempfile.mkdtemp(prefix="labcal-budget-")
    application = timed_application()
    from labcal.gui.ipc.client import Client
    from labcal.gui.ipc.messages import RunProcedure
    from labcal.gui.theming.theme import LIGHT
    from labcal.gui.viewmodels.app_state import AppState
    from labcal.gui.viewmodels.run import RunViewModel
    from labcal.gui.window import Window

    app_state = AppState(QSettings(os.path.join(os.environ["LABCAL_HOME"], "w.ini"), QSettings.Format.IniFormat))
    app_state.bench_worker = Client(app_state, (__file__, "feed"))
    app_state.run = RunViewModel(app_state.bench_worker)
    window = Window(app_state, LIGHT)
    window.show()
    window.open_page("Run")
    app_state.run.start(RunProcedure("budget", "none"))
    live = window.page("Run").live
    drawn = live.draw
    frames: list[float] = []
    live.frame_timer.timeout.disconnect()
    live.frame_timer.timeout.connect(lambda: (frames.append(time.perf_counter()), drawn()))
    while len(app_state.run.dut) < RATE_HZ:  # the first second builds what is built once
        application.processEvents()
    application.forget()
    frames.clear()
    while app_state.run.alive:
        application.processEvents()
        time.sleep(0.001)
    rows = app_state.run.dut.written
    rate = len(frames) / (frames[-1] - frames[0])
    print(f"{application.longest()}; {rate:.0f} repaints/s; {rows} rows arrived")
    window.close()
    return int(application.worked_ms > LONGEST_MS or rows != RATE_HZ * SECONDS)


if __name__ == "__main__":
    sys.exit(feed() if "feed" in sys.argv[1:] else main())
