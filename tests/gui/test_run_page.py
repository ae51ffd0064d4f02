"""A run clicked through on the twin, through the real worker process."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QPushButton

from labcal import session
from labcal.gui.ipc.messages import RunProcedure
from labcal.record.stream import Block, Step

QUICK = {
    "axes": "x",
    "magnitudes_nT": "20000",
    "reverse": "no",
    "modes": "nominal",
    "rate_deg_per_s": "20",
    "zero_s": "2",
}
LONG_MS = 180_000
BENCH = Path(__file__).parents[2] / "examples" / "simulated.toml"


def read_at_zero(window):
    """What was known of the coils whenever the lab's state changed: the last reading in it, however old by now."""
    known = []
    window.app_state.lab.changed.connect(lambda state: known.append(state.now.coils_at_zero))
    return lambda: [good for good in known if good is not None][-1]


def begin(qtbot, window, procedure="preflight", given=QUICK):
    """The Run page with the procedure chosen, its form filled, Start clicked and the first question asked."""
    window.open_page("Run")
    page = window.page("Run")
    qtbot.waitUntil(lambda: page.choose.list.count() > 0, timeout=LONG_MS)
    page.open_procedure(procedure)
    for name, text in given.items():
        page.choose.form.set_text(name, text)
    qtbot.waitUntil(page.choose.start.isEnabled, timeout=LONG_MS)
    qtbot.mouseClick(page.choose.start, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: window.app_state.run.state in ("asking", "ended"), timeout=LONG_MS)
    return page


def answer_all(qtbot, by_mouse, window, page):
    """Click the first button of every card until the run has ended."""
    run = window.app_state.run
    while True:
        qtbot.waitUntil(lambda: run.state in ("asking", "ended"), timeout=LONG_MS)
        if run.state == "ended":
            return
        by_mouse(page.live.prompt.choices[run.prompt.choices[0]])


def test_a_preflight_is_clicked_through_to_its_verdicts_though_its_worker_is_killed_on_the_way(qtbot, by_mouse, window):
    at_zero = read_at_zero(window)
    page = begin(qtbot, window)
    run = window.app_state.run
    for words in ("turns to 0°. Hands off?", "body X up"):
        qtbot.waitUntil(lambda words=words: run.state == "asking" and words in run.prompt.text, timeout=LONG_MS)
        assert page.live.prompt.isVisible()
        assert words in page.live.prompt.text.text()
        by_mouse(page.live.prompt.choices["done"])
    qtbot.waitUntil(lambda: run.state == "asking", timeout=LONG_MS)
    os.kill(window.app_state.bench_worker.pid, signal.SIGKILL)
    qtbot.waitUntil(lambda: run.state == "ended", timeout=LONG_MS)
    assert run.fault.kind == "ended"
    assert page.live.fault.isVisible()
    qtbot.waitUntil(lambda: "zero" in window.app_state.lab.state.message, timeout=LONG_MS)
    window.open_page("Start")
    start = window.page("Start")
    qtbot.waitUntil(start.interrupted.isVisible, timeout=LONG_MS)
    qtbot.mouseClick(start.interrupted.findChildren(QPushButton)[0], Qt.MouseButton.LeftButton)
    assert window.stack.currentWidget() is window.lazy_pages["Run"]
    answer_all(qtbot, by_mouse, window, page)
    assert (run.status, run.fault) == ("finished", None)
    assert run.measurements["closure x"].verdict == "PASS"
    assert page.live.lights.worst["x"].text() == "X  ▲ not complete"  # one turn tells no delay
    assert page.live.verdict.word.text().replace("\N{NO-BREAK SPACE}", " ").startswith("▲ PASS, without delay x")
    assert [mark for _, mark in run.steps()] == ["done"] * run.step.total
    assert len(run.dut) > 500
    qtbot.waitUntil(at_zero, timeout=LONG_MS)
    assert page.live.fit.isEnabled()


def test_f12_ends_a_run_that_waits_for_an_answer_with_the_coils_at_zero(qtbot, window):
    at_zero = read_at_zero(window)
    begin(qtbot, window)
    qtbot.keyClick(window, Qt.Key.Key_F12)
    qtbot.waitUntil(lambda: window.app_state.run.state == "ended", timeout=LONG_MS)
    assert window.app_state.run.status == "interrupted"  # it may be gone on with
    assert window.app_state.run.message.endswith("stopped by COILS OFF")
    qtbot.waitUntil(at_zero, timeout=LONG_MS)


def test_stop_ends_the_run_in_order(qtbot, window):
    at_zero = read_at_zero(window)
    page = begin(qtbot, window)
    qtbot.mouseClick(page.live.stop, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: window.app_state.run.state == "ended", timeout=LONG_MS)
    assert window.app_state.run.status == "interrupted"
    assert "No turn was finished: Go on begins with the first step again" in page.live.fault.text.text()
    qtbot.waitUntil(at_zero, timeout=LONG_MS)


def test_what_cannot_be_gone_on_with_is_stopped(qtbot, window):
    page = begin(qtbot, window, "field-hold", {})
    qtbot.mouseClick(page.live.stop, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: window.app_state.run.state == "ended", timeout=LONG_MS)
    assert window.app_state.run.status == "stopped"


@pytest.mark.slow
def test_an_instrument_that_dies_is_named_and_the_coils_are_not_called_safe(qtbot, window, tmp_path):
    served = tmp_path / "served.toml"
    program = "from labcal.cli import main; main()"
    command = [sys.executable, "-c", program, "bench", "serve", str(BENCH), "--out", str(served)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as lab:
        assert lab.stdout.readline().strip() == "ready"
        window.app_state.open_bench(str(served))
        qtbot.waitUntil(lambda: window.app_state.facts.virtual_time is False, timeout=LONG_MS)
        assert window.top.simulated.isVisible()
        page = begin(qtbot, window, "axes-check", {})
        lab.kill()
    card = page.live.prompt
    qtbot.waitUntil(lambda: "No answer from supply_x" in card.details.text(), timeout=LONG_MS)
    assert "supply_z" in card.details.text()
    assert "NOT confirmed at zero" in card.hands.text()
    assert not card.choices["done"].isEnabled()
    qtbot.mouseClick(page.live.stop, Qt.MouseButton.LeftButton)  # the one answer that is left
    qtbot.waitUntil(lambda: window.app_state.run.state == "ended", timeout=LONG_MS)
    run = window.app_state.run
    assert run.fault.kind == "instrument"
    assert "supply_x" in run.fault.text
    assert window.fault.isVisible()
    assert window.fault.heading.text() == "✕ HANDS OFF: the coils may be on"
    assert not page.live.prompt.isVisible()
    assert not run.coils_at_zero
    assert [one.simulated for one in session.runs() if one.run_id == run.run_id] == [True]


def test_no_empty_graph_is_drawn_before_the_first_reading(still):
    """Axes from 0.1 to 0.9 stood there as a run began."""
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    still.open_page("Run")
    live = still.page("Run").live
    live.draw()
    plot, height = live.traces.plot, live.traces.height()
    assert not plot.isVisible()
    values = np.ones((4, 3))
    block = Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), np.arange(4.0), values)
    still.app_state.bench_worker.items.emit((Step(0.0, 1, 2, "zero", 60.0, ("zero", "x")), block))
    live.draw()
    assert (plot.isVisible(), live.traces.height()) == (True, height)
