"""A run clicked through on the twin, through the real worker process."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QPushButton

QUICK = {
    "axes": "x",
    "magnitudes_nT": "20000",
    "reverse": "no",
    "modes": "nominal",
    "rate_deg_per_s": "20",
    "zero_s": "2",
}
LONG_MS = 60_000
BENCH = Path(__file__).parents[2] / "examples" / "simulated.toml"


def begin(qtbot, window, procedure="preflight", given=QUICK):
    """The Run page with the procedure chosen, its form filled, Start clicked and the first question asked."""
    window.open_page("Run")
    page = window.page("Run")
    qtbot.waitUntil(lambda: page.choose.list.count() > 0, timeout=LONG_MS)
    page.choose.choose(procedure)
    for name, text in given.items():
        page.choose.form.set_text(name, text)
    qtbot.waitUntil(page.choose.start.isEnabled, timeout=LONG_MS)
    qtbot.mouseClick(page.choose.start, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: window.desk.run.state in ("asking", "ended"), timeout=LONG_MS)
    return page


def answer_all(qtbot, window, page):
    """Click the first button of every card until the run has ended."""
    run = window.desk.run
    while True:
        qtbot.waitUntil(lambda: run.state in ("asking", "ended"), timeout=LONG_MS)
        if run.state == "ended":
            return
        qtbot.mouseClick(page.live.prompt.choices[run.prompt.choices[0]], Qt.MouseButton.LeftButton)


def test_a_preflight_is_clicked_through_to_its_verdicts(qtbot, window):
    page = begin(qtbot, window)
    assert page.live.prompt.isVisible()
    assert "body X up" in page.live.prompt.text.text()
    answer_all(qtbot, window, page)
    run = window.desk.run
    assert (run.status, run.fault) == ("finished", None)
    assert run.measurements["closure x"].verdict == "PASS"
    assert page.live.lights["x"].text() == "X ✓ PASS"
    assert [mark for _, mark in run.steps()] == ["done"] * run.step.total
    assert len(run.dut) > 500
    assert window.desk.lab.state.coils_at_zero
    assert page.live.fit.isEnabled()


def test_f12_ends_a_run_that_waits_for_an_answer_with_the_coils_at_zero(qtbot, window):
    begin(qtbot, window)
    qtbot.keyClick(window, Qt.Key.Key_F12)
    qtbot.waitUntil(lambda: window.desk.run.state == "ended", timeout=LONG_MS)
    assert window.desk.run.status == "failed: aborted by the operator"
    assert window.desk.run.coils_at_zero


def test_stop_ends_the_run_in_order(qtbot, window):
    page = begin(qtbot, window)
    qtbot.mouseClick(page.live.stop, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: window.desk.run.state == "ended", timeout=LONG_MS)
    assert window.desk.run.status == "stopped"
    assert window.desk.run.coils_at_zero


def test_a_worker_that_is_killed_is_a_red_card_with_words_and_the_coils_are_switched_off(qtbot, window):
    page = begin(qtbot, window)
    os.kill(window.desk.bench_worker.pid, signal.SIGKILL)
    qtbot.waitUntil(lambda: window.desk.run.state == "ended", timeout=LONG_MS)
    assert window.desk.run.fault.kind == "crash"
    assert page.live.fault.isVisible()
    qtbot.waitUntil(lambda: "zero" in window.desk.lab.state.message, timeout=LONG_MS)


def test_enter_never_answers_a_card_that_acts(qtbot, window):
    page = begin(qtbot, window)
    button = page.live.prompt.choices["done"]
    button.setFocus()
    for key in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space):
        qtbot.keyClick(button, key)
    qtbot.keyClick(button, button.key)  # pressed, not held
    qtbot.wait(900)
    assert window.desk.run.state == "asking"


def test_its_own_key_held_for_a_moment_answers(qtbot, window):
    page = begin(qtbot, window)
    key, before = page.live.prompt.choices["done"].key, window.desk.run.prompt
    qtbot.keyPress(window, key)
    qtbot.waitUntil(lambda: window.desk.run.prompt is not before, timeout=3000)
    qtbot.keyRelease(window, key)


def test_a_burst_of_characters_is_a_scan_and_goes_to_the_serial(qtbot, window):
    window.top.operator.setFocus()
    qtbot.keyClicks(window.top.operator, "EM-07")
    qtbot.keyClick(window.top.operator, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: window.desk.lab.state.dut_serial == "EM-07", timeout=3000)
    assert window.desk.lab.state.operator == "J. Doe"
    assert window.top.dut.text() == "EM-07"


@pytest.mark.parametrize("text", ["E", "em"])
def test_what_a_person_types_stays_where_it_is_typed(qtbot, window, text):
    window.top.operator.clear()
    window.top.operator.setFocus()
    qtbot.keyClicks(window.top.operator, text, delay=60)
    qtbot.waitUntil(lambda: window.top.operator.text() == text, timeout=3000)
    assert window.desk.lab.state.dut_serial != text


def test_a_setting_out_of_range_is_named_and_start_waits(qtbot, window):
    window.open_page("Run")
    page = window.page("Run")
    qtbot.waitUntil(lambda: page.choose.list.count() > 0, timeout=LONG_MS)
    page.choose.choose("preflight")
    page.choose.form.set_text("inclination_deg", "80")
    assert not page.choose.start.isEnabled()
    assert "35 to 65" in page.choose.form._complaints["inclination_deg"].text()


def test_no_operator_no_run(qtbot, window):
    window.desk.who(operator="")
    window.open_page("Run")
    page = window.page("Run")
    qtbot.waitUntil(lambda: page.choose.list.count() > 0, timeout=LONG_MS)
    assert not page.choose.start.isEnabled()
    assert "operator" in page.choose.objection.text()


def test_an_interrupted_run_is_offered_at_start_and_goes_on(qtbot, window):
    page = begin(qtbot, window)
    qtbot.mouseClick(page.live.prompt.choices["done"], Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: window.desk.run.state == "asking", timeout=LONG_MS)
    os.kill(window.desk.bench_worker.pid, signal.SIGKILL)
    qtbot.waitUntil(lambda: window.desk.run.state == "ended", timeout=LONG_MS)
    window.open_page("Start")
    start = window.page("Start")
    qtbot.waitUntil(start.interrupted.isVisible, timeout=LONG_MS)
    again = start.interrupted.findChildren(QPushButton)[0]
    qtbot.mouseClick(again, Qt.MouseButton.LeftButton)
    assert window.stack.currentWidget() is window.later["Run"]
    answer_all(qtbot, window, page)
    assert (window.desk.run.status, window.desk.run.fault) == ("finished", None)


@pytest.mark.slow
def test_an_instrument_that_dies_is_named_and_the_coils_are_not_called_safe(qtbot, window, tmp_path):
    served = tmp_path / "served.toml"
    program = "from labcal.cli import main; main()"
    command = [sys.executable, "-c", program, "bench", "serve", str(BENCH), "--out", str(served)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as lab:
        assert lab.stdout.readline().strip() == "ready"
        window.desk.open_bench(str(served))
        qtbot.waitUntil(lambda: window.desk.facts["simulated"] is False, timeout=LONG_MS)
        page = begin(qtbot, window, "axes-check", {})
        lab.kill()
    qtbot.waitUntil(lambda: window.desk.run.state == "ended", timeout=LONG_MS)
    run = window.desk.run
    assert run.fault.kind == "instrument"
    assert page.live.fault.isVisible()
    assert not page.live.prompt.isVisible()
    assert not run.coils_at_zero
