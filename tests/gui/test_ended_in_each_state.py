"""Stop, and the window closed, in each state of a run on real lines: the emulated supplies read zero afterwards."""

import sys
from pathlib import Path

import pytest
from PySide6.QtCore import QSettings, Qt
from served_lab import Served, at_zero, example, guardians, until

from labcal import session
from labcal.gui.theming.theme import LIGHT
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.window import Window

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(sys.platform == "win32", reason="needs ptys, which Windows lacks"),
]
ON_A = 0.3


@pytest.fixture
def lab(tmp_path, monkeypatch):
    served = Served(tmp_path, monkeypatch, example())
    yield served
    served.close()


@pytest.fixture
def shown(tmp_path, windows, lab, qtbot, patience):
    app_state = AppState(QSettings(str(tmp_path / "w.ini"), QSettings.Format.IniFormat))
    window = Window(app_state, LIGHT)
    windows.append(window)
    window.show()
    window.open_page("Run")
    window.page("Run")
    app_state.open_bench(str(lab.file))
    app_state.set_identity(operator="J. Doe", dut="EM-07")
    qtbot.waitUntil(lambda: bool(app_state.facts), timeout=patience)
    yield window
    window.leave()


def bring(qtbot, window, lab, patience, state):
    """The run into `state`: asking, energised, or stopping with the coils still on their way."""
    run = window.app_state.run
    window.app_state.start("field-hold", {"duration_s": "600"})
    qtbot.waitUntil(lambda: run.state in ("asking", "ended"), timeout=patience)
    assert run.state == "asking", run.fault
    if state == "asking":
        return
    run.answer(run.prompt.choices[0])
    qtbot.waitUntil(lambda: max(lab.currents().values()) > ON_A, timeout=patience)
    if state == "stopping":
        run.stop()


@pytest.mark.parametrize("state", ["starting", "asking", "energised", "stopping"])
def test_a_window_that_is_closed_leaves_the_coils_at_zero(qtbot, shown, lab, patience, state):
    if state == "starting":
        shown.app_state.start("field-hold", {"duration_s": "600"})
    else:
        bring(qtbot, shown, lab, patience, state)
    shown.close()
    if (question := shown.leaving.question) is not None and question.isVisible():
        qtbot.mouseClick(question.buttons["stop"], Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: not shown.isVisible(), timeout=patience)
    until(lambda: at_zero(lab))
    until(lambda: not guardians())
    assert at_zero(lab)
    assert all(one.status != "running" for one in session.runs())


def test_a_window_closed_to_go_on_later_sees_the_coils_at_zero_before_it_goes(qtbot, shown, lab, patience):
    bring(qtbot, shown, lab, patience, "energised")
    shown.leaving.take("later")  # this procedure offers no button for it
    going = shown.leaving.going
    qtbot.waitUntil(lambda: going.heading.text().startswith("The run has ended"), timeout=patience)
    assert shown.isVisible()
    assert at_zero(lab)
    assert not going.lab_lines.coils.text().startswith("● coils on")
    qtbot.waitUntil(lambda: not shown.isVisible(), timeout=patience)
    assert [one.status for one in session.runs()] == ["interrupted"]
    until(lambda: not guardians())


@pytest.mark.parametrize("state", ["asking", "energised"])
def test_stop_leaves_the_coils_at_zero(qtbot, shown, lab, patience, state):
    bring(qtbot, shown, lab, patience, state)
    run, live = shown.app_state.run, shown.page("Run").live
    qtbot.mouseClick(live.stop, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: run.state == "ended", timeout=patience)
    assert (run.status, run.coils_at_zero) == ("stopped", True)
    assert at_zero(lab)
    assert Path(shown.app_state.bench) == lab.file
