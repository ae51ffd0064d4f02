"""What tells causes apart, through the real workers: its plan is read, it is measured, joined, and decided again."""

from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import pytest
from PySide6.QtCore import QSettings, Qt

pytestmark = pytest.mark.slow
BENCH = Path(__file__).parents[2] / "examples" / "simulated.toml"
SHORT = {"axes": "x,y,z", "magnitudes_nT": "20000", "reverse": "no", "modes": "nominal", "rate_deg_per_s": "20"}


def test_a_second_run_is_planned_measured_joined_and_the_loop_decides_again(
    qtbot, by_mouse, tmp_path, monkeypatch, windows, patience
):
    from labcal import session
    from labcal.bench.clock import VirtualClock
    from labcal.gui.ipc.answers import Proposal
    from labcal.gui.theming.theme import LIGHT
    from labcal.gui.viewmodels.app_state import AppState
    from labcal.gui.window import Window

    monkeypatch.setenv("LABCAL_HOME", str(tmp_path))
    clock = VirtualClock(datetime(2026, 1, 5, tzinfo=UTC))
    first = session.run("preflight", BENCH, SHORT | {"zero_s": "3"}, dut="EM-07", operator="J. Doe", clock=clock)
    settings = QSettings(str(tmp_path / "w.ini"), QSettings.Format.IniFormat)
    settings.setValue("pace", "at once")
    window = Window(AppState(settings), LIGHT)
    windows.append(window)
    window.show()
    app_state, study, run = window.app_state, window.app_state.study_vm, window.app_state.run

    def click(widget):
        qtbot.waitUntil(lambda: widget.isVisible() and widget.isEnabled(), timeout=patience)
        qtbot.mouseClick(widget, Qt.MouseButton.LeftButton)

    try:
        app_state.open_bench(str(BENCH))
        app_state.set_identity(dut="EM-07", operator="J. Doe")
        qtbot.waitUntil(lambda: bool(app_state.facts), timeout=patience)
        window.open_page("Loop")
        loop = window.page("Loop")
        study.open(first.run_id)
        click(loop.close_loop)
        qtbot.waitUntil(lambda: study.loop is not None or study.fault is not None, timeout=patience)
        assert study.fault is None
        rows = len(study.loop.change.before)
        study.loop = replace(study.loop, next_experiment=Proposal("", "", "reverse"))  # whatever was found
        study.changed.emit()
        click(loop.next)
        choose = window.page("Run").choose
        qtbot.waitUntil(lambda: "added to run" in choose.plan.text(), timeout=patience)
        click(choose.start)
        live = window.page("Run").live
        while run.state != "ended":
            qtbot.waitUntil(lambda: run.state in ("asking", "ended"), timeout=patience)
            if run.state == "asking":
                by_mouse(live.prompt.choices[run.prompt.choices[0]])
        assert run.status == "finished", run.fault
        second = run.run_id
        qtbot.waitUntil(
            lambda: study.fault is not None or (study.loop is not None and bool(study.measured)), timeout=patience
        )
        assert study.fault is None
        assert study.run not in (first.run_id, second)
        assert len(study.loop.change.before) > rows
        assert f"reverse ({second})" in loop.unknown.toPlainText()
        assert loop.verdict.text()
        assert {one.run_id for one in session.runs()} == {first.run_id, second, study.run}
    finally:
        window.leave()
