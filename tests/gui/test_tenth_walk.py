"""What two technicians stumbled over in one evening: clicks that did nothing, words that said what was not so."""

import ast
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import QLocale, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialogButtonBox, QFileDialog, QLabel, QLineEdit, QPushButton
from test_nothing_is_cut import settle

import labcal.gui
from labcal.bench.coils.state import Heard, LabState
from labcal.bench.config import read_config
from labcal.errors import InputError
from labcal.gui.ipc.answers import Ended, RunLine
from labcal.gui.ipc.messages import ReadBench, RunProcedure
from labcal.gui.ipc.record_messages import TellTurned
from labcal.gui.ipc.wire import Fault, fault_of
from labcal.gui.theming.theme import GRID
from labcal.gui.translations import translate
from labcal.gui.viewmodels.hands import coming
from labcal.gui.viewmodels.lab_now import lab_now
from labcal.gui.widgets.key_sheet import KeySheet
from labcal.record.stream import Measurement, Prompt, Step

GUI = Path(labcal.gui.__file__).parent


@pytest.fixture
def in_language(qapp):
    yield lambda code: translate.install_translator(qapp, QLocale(code))
    translate.install_translator(qapp, QLocale("en"))


def click(dialog, button):
    """As a person's: what popped up over the dialog has the mouse."""
    under = QApplication.activePopupWidget() or dialog
    at = under.mapFromGlobal(button.mapToGlobal(button.rect().center()))
    QTest.mouseClick(under.windowHandle(), Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, at)


@pytest.mark.parametrize("which", ["Open", "COILS OFF"])
def test_the_first_click_counts_where_a_path_was_typed(same_window, tmp_path, qtbot, which):
    (tmp_path / "served.toml").write_text("", encoding="utf-8")
    dialog, heard = QFileDialog(same_window, "Open", str(GUI)), []
    dialog.setOption(QFileDialog.Option.DontUseNativeDialog)
    dialog.setFileMode(QFileDialog.FileMode.ExistingFile)
    dialog.accepted.connect(lambda: heard.append("Open"))
    same_window.coils_off.connect(lambda: heard.append("COILS OFF"))
    dialog.show()
    field = dialog.findChild(QLineEdit, "fileNameEdit")
    settle(same_window)
    QTest.keyClicks(field, str(tmp_path / "served.toml"))
    qtbot.wait(300)  # for what its list of files would offer
    accept = dialog.findChild(QDialogButtonBox).button(QDialogButtonBox.StandardButton.Open)
    click(dialog, accept if which == "Open" else dialog.findChild(QPushButton, "off"))
    assert heard == [which]
    dialog.close()


def test_the_sheet_of_keys_is_as_high_as_its_rows_where_there_is_room(same_window):
    same_window.resize(1360, 1060)
    same_window.show_keys()
    settle(same_window)
    (sheet,) = same_window.findChildren(KeySheet)
    assert sheet.area.verticalScrollBar().maximum() == 0
    sheet.close()


def test_no_two_keys_are_said_to_do_the_same(same_window):
    listed = same_window.keys()
    said = [words for _, words in listed]
    assert sorted(said) == sorted(set(said))


def test_after_a_colon_a_sentence_goes_on_with_a_small_letter_but_in_german(in_language):
    asked = Prompt(0.0, "ready", "The coils go to 50 µT. Hands off?")
    assert coming(asked, "The coils go to 50 µT.") == "Next: the coils go to 50 µT."
    assert coming(asked, "DUT and coils.") == "Next: DUT and coils."
    in_language("de")
    assert coming(asked, "Die Spulen gehen auf 50 µT.").endswith(": Die Spulen gehen auf 50 µT.")


def test_every_word_that_a_widget_shows_by_itself_is_in_the_ts_file(in_language):
    """`translated("…")` is read by no tool: what stands in no table stayed English."""
    said = {
        call.args[0].value
        for path in GUI.rglob("*.py")
        for call in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(call, ast.Call)
        and getattr(call.func, "id", "") == "translated"
        and call.args
        and isinstance(call.args[0], ast.Constant)
    }
    listed = (GUI / "translations" / "labcal_fr.ts").read_text(encoding="utf-8")
    words = listed.partition("<name>Words</name>")[2].partition("</context>")[0]
    escaped = {one: one.replace("&", "&amp;").replace("'", "&apos;").replace('"', "&quot;") for one in said}
    assert "COILS OFF   F12" in said
    assert {one for one, text in escaped.items() if f"<source>{text}</source>" not in words} == set()


def test_a_file_that_is_no_bench_says_so_and_which_bench_stays_and_leaves_with_the_next_page(same_window, tmp_path):
    (tmp_path / "pyproject.toml").write_text('[build-system]\nrequires = ["hatchling"]\n', encoding="utf-8")
    with pytest.raises(InputError) as refused:
        read_config(tmp_path / "pyproject.toml")
    app_state, card = same_window.app_state, same_window.fault
    before = app_state.bench
    for leaves in (
        lambda: same_window.open_page("History"),
        lambda: app_state.bench_known(before, app_state.facts),
    ):
        same_window.open_page("Bench")
        app_state.open_bench(str(tmp_path / "pyproject.toml"))
        asked = next(one for one in reversed(app_state.quick_worker.asked) if isinstance(one.command, ReadBench))
        asked.failed(fault_of(refused.value))
        assert "is no bench file" in card.text.text()
        assert card.remedy.text() == f"The bench that was open stays open: {app_state.facts.name}."
        assert card.isVisible()
        assert app_state.bench == before
        leaves()
        assert not card.isVisible()


def test_while_a_bench_is_opened_nothing_says_that_none_is_open(same_window):
    app_state = same_window.app_state
    same_window.open_page("Start")
    app_state.facts = None
    app_state.lab.update(bench="", opening=True)
    said = [one.text() for one in same_window.findChildren(QLabel) if one.isVisible()]
    assert "The bench is being opened …" in said
    assert "No bench is open." not in said
    app_state.lab.update(opening=False)
    assert "No bench is open." in [one.text() for one in same_window.findChildren(QLabel) if one.isVisible()]


RAW = {
    "reference: '#' was answered with '3,057 173  - 6,555', not SER#.": "reference: does not answer as it should.",
    "address 1 on reversers (modbus-rtu:///dev/pts/0?baud=9600): no valid Modbus reply.": "reversers: no answer.",
    "address 1 on modbus-rtu:///dev/pts/0?baud=9600: no valid Modbus reply.": "address 1: no answer.",
}


@pytest.mark.parametrize("raw", RAW)
def test_what_came_over_a_line_is_told_in_plain_words_and_stands_in_the_details(same_window, raw):
    card = same_window.fault
    same_window.app_state.fault.emit(Fault("instrument", raw, "Look at its panel."))
    assert card.text.text() == RAW[raw]
    assert card.fold.isVisible()
    assert raw in card.details.toPlainText()


@pytest.mark.parametrize("raw", RAW)
def test_the_list_of_instruments_quotes_no_protocol(raw):
    known = LabState((), instruments=(Heard("reference", 1.0, raw),))
    ((_, light, words),) = lab_now(known, 1.0, {"reference": "reference"}, 1.0).lights
    assert light == "fault"
    assert words.startswith("does not answer as it should" if "was answered" in raw else "no answer")
    assert "'" not in words
    assert "://" not in words


def test_coils_off_and_the_hands_are_in_sight_in_every_frame_of_another_theme(same_window):
    same_window.app_state.take_lab(LabState((), instruments=()))
    same_window.open_page("Run")
    settle(same_window)
    assert same_window.side.keep_off.isVisible()
    same_window.theme_switch.click()
    frames = 0
    while same_window.style_queue.waits:
        QApplication.processEvents()
        seen = same_window.screen().grabWindow(same_window.winId()).toImage()
        for part in (same_window.top.off, same_window.side.keep_off):
            at = part.mapTo(same_window, part.rect().topLeft())
            across = range(at.x(), at.x() + part.width(), 2)
            colours = {seen.pixel(x, at.y() + part.height() // 2) for x in across}
            assert len(colours) > 1, f"{part.text()} is not painted in frame {frames}"
        frames += 1
    assert frames > 1


def test_why_a_serial_is_not_accepted_moves_nothing(same_window):
    same_window.open_page("Run")
    settle(same_window)
    parts = same_window.stack, same_window.side, same_window.sidebar, same_window.top.simulated
    before = [one.geometry() for one in parts]
    same_window.app_state.set_identity(dut="EM 0/7; rm *")
    settle(same_window)
    reason = same_window.top.reason
    assert reason.isVisible()
    assert "is no serial number" in reason.text()
    assert [one.geometry() for one in parts] == before
    assert reason.height() <= 3 * GRID  # it lies in the page's margin, over no words
    same_window.app_state.set_identity(dut="EM-07")
    assert not reason.isVisible()


def test_the_badge_stands_at_one_place_on_every_page(same_window):
    places = set()
    for name in ("Start", "Bench", "Run", "Fit", "Loop", "Certificate", "History"):
        same_window.open_page(name)
        settle(same_window)
        places.add(same_window.top.simulated.x())
    assert len(places) == 1


TURN = "x+20uT-nominal"
NAMES = ("offset and first position", "axes-check", TURN, "x+50uT-nominal")
OLD = Measurement(3.0, "body X up: zero", 1.0, 0.1, "nT", 5.0)


def left_at(window, number, *measured):
    """A preflight that was stopped in step `number`."""
    app_state = window.app_state
    app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    app_state.bench_worker.items.emit((Step(0.0, number, len(NAMES), NAMES[number - 1], 60.0, NAMES), OLD, *measured))
    ended = Ended("r1", "interrupted", Fault("stopped", "stopped by the operator"))
    app_state.bench_worker.answer(RunProcedure, ended)
    return app_state.run


def test_of_a_run_without_a_finished_turn_no_step_is_ticked_and_go_on_shows_nothing_old(still):
    run = left_at(still, 3)
    assert [mark for _, mark in run.steps()] == ["next", "next", "broken", "next"]
    assert OLD.name in run.measurements  # what was measured may be looked at until it begins again
    still.app_state.resume("r1", "preflight", "EM-07")
    assert not run.measurements
    assert not run.drawn.earlier
    assert not [one for one in still.app_state.quick_worker.asked if isinstance(one.command, TellTurned)]


def test_a_finished_turn_is_ticked_and_used(still):
    run = left_at(still, 4, Measurement(4.0, f"{TURN}: coverage", 1.0, 0.1, "1", 5.0))
    assert [mark for _, mark in run.steps()] == ["done", "done", "done", "broken"]
    still.app_state.resume("r1", "preflight", "EM-07")
    assert OLD.name in run.measurements


def test_settings_that_are_wrong_beside_the_serial_are_said_too(still):
    still.open_page("Run")
    choose = still.page("Run").choose
    still.app_state.set_identity(dut="EM 0/7; rm *")
    assert choose.objection.text() == "Correct what is red at the top."
    choose.form.set_text("axes", "w")
    assert choose.objection.text() == "Correct what is red at the top, and what is marked ✕ above."


def test_each_page_says_what_kind_of_number_its_own_is(same_window):
    same_window.open_page("Certificate")
    units = [one.toolTip() for one in same_window.page("Certificate").findChildren(QLabel) if one.text() == "U: k=2"]
    assert ["of the parameter in its line alone" in tip and "rms on the Fit" in tip for tip in units] == [True]


def test_what_is_not_kept_of_a_run_is_said_with_the_button_that_makes_it(same_window):
    run = RunLine("r9", "2026-01-05T07:00:00Z", "finished", "EM-07", "J. Doe", "preflight", verdict="explained")
    run = replace(run, left_nT=(228.5, 27.0, 27.5))
    same_window.app_state.path.take_runs((run,))
    same_window.app_state.one_dut.open("r9")
    same_window.open_page("Loop")
    words = same_window.page("Loop").empty.text()
    assert "228.5 → 27.0 nT rms of the vector, noise alone 27.5 nT rms" in words
    assert words.endswith("“Work it out again” makes them.")
