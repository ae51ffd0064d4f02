"""Every kind of event of the window on a short preflight of the simulated lab, and the longest of each kind.

    QT_QPA_PLATFORM=offscreen python benchmarks/window_events.py [HOME]

HOME keeps the run for the next time. Two figures for each kind: by the clock, and by the processor's own time, which
a busy computer does not stretch. Exit 1 where one took more than 50 ms of work.
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

BENCH = Path(__file__).parents[1] / "examples" / "simulated.toml"
SHORT = {"magnitudes_nT": "20000", "reverse": "no", "modes": "nominal", "rate_deg_per_s": "20", "zero_s": "3"}
PAGES = ("Start", "Bench", "Run", "Fit", "Loop", "Certificate", "History")
SETTLED_S = 0.4


def record() -> None:
    """A short preflight into the store, where there is none."""
    from labcal import session
    from labcal.bench.clock import VirtualClock

    if not session.runs():
        clock = VirtualClock(datetime(2026, 1, 5, tzinfo=UTC))
        session.run("preflight", BENCH, SHORT, dut="EM-07", operator="J. Doe", clock=clock, seed=3)


class UserActions:
    """Does what a person does, one kind after another, and lets the window live meanwhile."""

    def __init__(self, application: Any, window: Any) -> None:
        self.application, self.window = application, window

    def wait(self, until: Callable[[], bool], seconds: float = 300.0) -> None:
        """Until something is so."""
        end = time.monotonic() + seconds
        while not until():
            if time.monotonic() > end:
                sys.exit(f"{self.application.kind}: waited too long")
            self.application.processEvents()
            time.sleep(0.001)

    def settle(self) -> None:
        """Until nothing is asked and not answered, and a moment longer."""
        app_state = self.window.app_state
        self.wait(lambda: not app_state.quick_worker.busy and not app_state.study_vm.busy)
        end = time.monotonic() + SETTLED_S
        self.wait(lambda: time.monotonic() > end)

    def do(self, kind: str, act: Callable[[], object], until: Callable[[], bool] = lambda: True) -> None:
        """One act, inside an event as a click is, and all that follows from it."""
        from PySide6.QtCore import QTimer

        self.application.kind = kind
        done: list[object] = []
        QTimer.singleShot(0, self.window, lambda: (act(), done.append(True)))
        self.wait(lambda: bool(done))
        self.wait(until)
        self.settle()


def main() -> int:
    """Drive, and print the table."""
    os.environ["LABCAL_HOME"] = sys.argv[1] if len(sys.argv) > 1 else tempfile.mkdtemp(prefix="labcal-events-")
    record()
    from window_budget import LONGEST_MS, timed_application

    application = timed_application()
    from PySide6.QtCore import QSettings

    from labcal.gui import window as window_module
    from labcal.gui.viewmodels.app_state import AppState

    settings = QSettings(str(Path(os.environ["LABCAL_HOME"]) / "events.ini"), QSettings.Format.IniFormat)
    settings.setValue("pace", "at once")
    window = window_module.Window(AppState(settings))
    drive = UserActions(application, window)
    application.kind = "window comes up"
    window.show()
    drive_all(drive)
    print(application.table())
    window.close()
    return int(any(worked > LONGEST_MS for _, worked, _ in application.kinds.values()))


def drive_all(drive: UserActions) -> None:
    """The acts of a day."""
    from labcal.gui.theming.theme import DARK, LIGHT

    window, app_state = drive.window, drive.window.app_state
    drive.do("pages are built ahead", window.prebuild, lambda: all(one.page for one in window.lazy_pages.values()))
    drive.do("a bench is opened", lambda: app_state.open_bench(str(BENCH)), lambda: bool(app_state.facts))
    app_state.set_identity(operator="J. Doe", dut="EM-07")
    for name in PAGES:
        drive.do(f"page {name}, empty", lambda n=name: window.open_page(n))
    run(drive)
    study(drive)
    for name in PAGES:
        drive.do(f"page {name}, full", lambda n=name: window.open_page(n))
    for name in PAGES:
        drive.do(f"page {name}, full", lambda n=name: window.open_page(n))
        drive.do(f"theme on {name}", lambda: window.set_theme(DARK))
        drive.do(f"theme on {name}", lambda: window.set_theme(LIGHT))
        drive.do(f"wall size on {name}", window.toggle_wall)
        drive.do(f"wall size on {name}", window.toggle_wall)
        drive.do(f"resized on {name}", lambda: window.resize(1500, 900))
        drive.do(f"resized on {name}", lambda: window.resize(1360, 860))


def run(drive: UserActions) -> None:
    """A run with its questions, notes and end."""
    window, app_state = drive.window, drive.window.app_state
    vm, live = app_state.run, window.page("Run").live
    window.open_page("Run")
    drive.do("Check all", window.page("Bench").check_all, lambda: bool(app_state.answered))
    drive.do("a procedure is chosen", lambda: window.page("Run").open_procedure("axes-check"))
    drive.do("a procedure is chosen", lambda: window.page("Run").open_procedure("preflight"))
    drive.do("Start", lambda: app_state.start("preflight", SHORT), lambda: vm.state in ("asking", "ended"))
    while vm.state != "ended":
        drive.do("a question in the wall size", window.toggle_wall)
        drive.do("a question in the wall size", window.toggle_wall)
        choice = vm.prompt.choices[0]
        drive.do("a question comes alive", lambda: None, lambda: live.prompt.alive)
        drive.do("an answer, and a run at once", live.prompt.choices[choice].click,
                 lambda: vm.state in ("asking", "ended"))  # fmt: skip
    drive.do("put away", live.close_run.click)


def study(drive: UserActions) -> None:
    """Open, fit, trace, look at a cause, at drafts."""
    window, app_state = drive.window, drive.window.app_state
    vm, history, fit, loop = app_state.study_vm, window.page("History"), window.page("Fit"), window.page("Loop")
    drive.do("page History, empty", lambda: window.open_page("History"), lambda: history.table.rowCount() > 0)
    drive.do("a run is chosen", lambda: history.table.selectRow(0))
    drive.do("Open", history.open.click, lambda: vm.look is not None)
    drive.do("Fit", fit.fit.click, lambda: "ml" in vm.fits)
    drive.do("All methods", fit.all.click, lambda: len(vm.fits) == len(vm.methods))
    for n in range(fit.views.view.count()):
        drive.do(f"view {n + 1} of a fit", lambda n=n: (fit.views.view.setCurrentIndex(n),
                                                         fit.views.view.activated.emit(n)))  # fmt: skip
    drive.do("Trace the residual", fit.trace.click, lambda: vm.loop is not None)
    drive.do("page Loop, full", lambda: window.open_page("Loop"))
    if loop.others.count():
        drive.do("a cause is chosen", lambda: loop.others.setCurrentRow(loop.others.count() - 1))
    drive.do("page Certificate, full", lambda: window.open_page("Certificate"))


if __name__ == "__main__":
    sys.exit(main())
