"""The window is killed in the middle of a turn: started again, it offers the run, goes on with it, and fits it."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from PySide6.QtCore import QSettings, Qt
from PySide6.QtWidgets import QPushButton

from labcal import session
from labcal.gui.theming.theme import LIGHT
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.window import Window

BENCH = Path(__file__).parents[2] / "examples" / "simulated.toml"
BEGUN = """
import sys
from PySide6.QtCore import QSettings, QTimer
from PySide6.QtWidgets import QApplication
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.window import Window

SHORT = {"magnitudes_nT": "20000", "reverse": "no", "modes": "nominal", "rate_deg_per_s": "20", "zero_s": "3"}
app = QApplication([])
settings = QSettings(sys.argv[2], QSettings.Format.IniFormat)
settings.setValue("pace", "20 times")
settings.setValue("seed", 3)
app_state = AppState(settings)
window = Window(app_state)
window.show()
app_state.open_bench(sys.argv[1])
app_state.set_identity(operator="J. Doe", dut="EM-07")
begun, turned = [], set()

def look():
    if app_state.facts and not begun:
        begun.append(True)
        app_state.start("preflight", SHORT)
    turned.add(app_state.run.segment)
    if len(turned) > 2 and app_state.run.segment:  # the second turn: one is finished
        print("measuring", flush=True)
    elif app_state.run.state == "asking":
        app_state.run.answer(app_state.run.prompt.choices[0])

timer = QTimer()
timer.timeout.connect(look)
timer.start(5)
app.exec()
"""


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="needs SIGKILL, which Windows lacks")
def test_a_run_whose_window_was_killed_is_gone_on_with_and_fitted(
    qtbot, by_mouse, tmp_path, monkeypatch, patience, windows
):
    monkeypatch.setenv("LABCAL_HOME", str(tmp_path))
    command = [sys.executable, "-c", BEGUN, str(BENCH), str(tmp_path / "w.ini")]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as killed:
        assert killed.stdout.readline() == "measuring\n"
        os.kill(killed.pid, signal.SIGKILL)
    qtbot.waitUntil(lambda: [one.status for one in session.runs()] == ["interrupted"], timeout=patience)

    settings = QSettings(str(tmp_path / "w.ini"), QSettings.Format.IniFormat)
    settings.setValue("pace", "at once")
    window = Window(AppState(settings), LIGHT)
    windows.append(window)
    app_state, run = window.app_state, window.app_state.run
    try:
        window.show()
        app_state.open_bench(str(settings.value("bench")))  # as `labcal gui` does
        start, live = window.page("Start"), window.page("Run").live
        qtbot.waitUntil(lambda: start.interrupted.isVisible() and bool(app_state.facts), timeout=patience)
        start.refresh()
        qtbot.waitUntil(lambda: not app_state.quick_worker.busy, timeout=patience)
        again = start.interrupted.findChildren(QPushButton)[-1]
        assert again.text().startswith("Go on with")
        qtbot.mouseClick(again, Qt.MouseButton.LeftButton)
        asked = []
        while run.state != "ended":
            qtbot.waitUntil(lambda: run.state in ("asking", "ended"), timeout=patience)
            if run.state == "asking":
                asked.append(run.prompt.key)
                by_mouse(live.prompt.choices[run.prompt.choices[0]])
        assert (run.status, run.fault) == ("finished", None)
        assert run.measurements["closure z"].verdict == "PASS"
        assert app_state.lab.state.now.coils_at_zero
        assert [one.status for one in session.runs()] == ["finished"]
        qtbot.waitUntil(lambda: not live.fit.visibleRegion().isEmpty(), timeout=patience)  # it has its place
        qtbot.mouseClick(live.fit, Qt.MouseButton.LeftButton)
        study = app_state.study_vm
        qtbot.waitUntil(lambda: "ml" in study.fits, timeout=patience)  # it begins by itself
        assert window.page_shown() == "Fit"
        assert study.fits["ml"].fit.ok
    finally:
        window.leave()
