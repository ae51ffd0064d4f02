"""A burst is a scan and a person is not, by when keys were struck: the clock is the test's own."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFileDialog, QLineEdit, QPushButton


class Clock:
    def __init__(self):
        self.now_s = 100.0

    def __call__(self):
        return self.now_s


@pytest.fixture
def keys(still, qtbot, patience):
    """Type `text` into a widget, `apart_s` between two keys."""
    clock = Clock()
    still.scanner.now = clock
    still.scanner.wait.setInterval(3_600_000)  # nothing is decided but by the clock above, or at the end

    def struck(widget, text, apart_s, ends_with=None):
        widget.setFocus()
        qtbot.waitUntil(lambda: QApplication.focusWidget() is widget, timeout=patience)
        for letter in text:
            clock.now_s += apart_s
            qtbot.keyClicks(widget, letter)
        if ends_with is not None:
            clock.now_s += apart_s
            qtbot.keyClick(widget, ends_with)
        still.scanner.flush()

    return struck


def shown(still):
    card = still.scan_card
    buttons = [one.text() for one in (card.take, card.leave, card.undo) if one.isVisible()]
    return (card.words.text(), buttons) if card.isVisible() else None


@pytest.mark.parametrize("leave", [Qt.Key.Key_Tab, "click"])
def test_what_a_busy_window_holds_back_is_typed_before_the_focus_goes(still, keys, qtbot, leave):
    keys(still.top.dut, "", 0.2)
    still.top.dut.selectAll()
    for letter in "EM-19":
        still.scanner.now.now_s += 0.2
        qtbot.keyClick(still.top.dut, letter)
    if leave == "click":  # as the screen sends it: to the window, which gives the focus away before any widget hears
        there = still.top.operator.mapTo(still, still.top.operator.rect().center())
        QTest.mouseClick(still.windowHandle(), Qt.MouseButton.LeftButton, pos=there)
    else:
        qtbot.keyClick(still.top.dut, leave)
    assert still.top.operator.hasFocus()
    assert still.top.dut.text() == "EM-19"


def test_a_burst_where_no_field_waits_for_it_is_a_question_and_can_be_undone(still, keys, qtbot):
    keys(still.sidebar, "EM-19", 0.01, Qt.Key.Key_Return)
    state = still.app_state.lab.state
    assert (state.dut_serial, state.operator) == ("EM-07", "J. Doe")
    asked = "Scanned EM-19. Is it the DUT from here on? Until now: EM-07."
    assert shown(still) == (asked, ["Take EM-19", "Leave EM-07"])
    main = [one.text() for one in still.scan_card.findChildren(QPushButton, "primary") if one.isVisible()]
    assert main == ["Leave EM-07"]  # it changes nothing
    qtbot.mouseClick(still.scan_card.take, Qt.MouseButton.LeftButton)
    assert still.top.dut.text() == "EM-19"
    assert shown(still) == ("The DUT is EM-19, in place of EM-07.", ["Close", "Undo"])
    qtbot.mouseClick(still.scan_card.undo, Qt.MouseButton.LeftButton)
    assert still.top.dut.text() == "EM-07"
    assert shown(still) is None


def test_a_scan_that_is_left_or_answered_by_typing_changes_nothing(still, keys, qtbot):
    for _ in range(2):
        keys(still.sidebar, "EM-19", 0.01)
        qtbot.mouseClick(still.scan_card.leave, Qt.MouseButton.LeftButton)
        assert (shown(still), still.app_state.lab.state.dut_serial) == (None, "EM-07")
    keys(still.sidebar, "EM-19", 0.01)
    still.app_state.set_identity(dut="EM-33")
    assert (shown(still), still.app_state.lab.state.dut_serial) == (None, "EM-33")


def test_a_question_of_a_scan_is_gone_when_a_run_begins(still, keys):
    from labcal.gui.ipc.messages import RunProcedure

    keys(still.sidebar, "EM-19", 0.01)
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    assert shown(still) is None
    keys(still.top.dut, "EM-19", 0.01)  # whose run it is stands fixed
    assert (shown(still), still.app_state.lab.state.dut_serial) == (None, "EM-07")


def test_a_scan_goes_into_the_serial_or_the_search_that_has_the_focus(still, keys):
    keys(still.top.dut, "EM-19", 0.01)
    assert (still.app_state.lab.state.dut_serial, shown(still)) == ("EM-19", None)
    still.open_page("History")
    search = still.page("History").search
    search.setText("what was searched before")
    keys(search, "EM-21", 0.01)
    assert (search.text(), still.app_state.lab.state.dut_serial, shown(still)) == ("EM-21", "EM-19", None)
    search.clear()


def test_what_is_no_serial_is_not_taken_and_says_why(still, keys):
    keys(still.sidebar, "EM-07/!?<b>", 0.01)
    assert shown(still) is None
    assert still.message.text().startswith("✕ Scanned, and not taken: 'EM-07/!?<b>' is no serial number")
    still.app_state.set_identity(dut="EM 07/!?<b>")
    assert still.top.dut.property("state") == "bad"
    choose = still.page("Run").choose
    assert "is no serial number" in still.top.reason.text()
    assert choose.objection.text() == "Correct what is red at the top."
    assert not choose.start.isEnabled()
    still.app_state.set_identity(dut="EM-07")
    assert (still.top.dut.property("state"), choose.start.isEnabled(), still.message.text()) == ("", True, "")


def test_serials_are_those_of_the_pattern_of_the_bench_file(still, keys, monkeypatch):
    monkeypatch.setattr(still.app_state, "facts", replace(still.app_state.facts, serial_pattern=r"EM-\d\d"))
    keys(still.sidebar, "FM-19", 0.01)
    assert shown(still) is None
    assert r"they match EM-\d\d" in still.message.text()
    keys(still.sidebar, "EM-19", 0.01)
    assert shown(still) is not None


def test_a_scan_reaches_no_answer_of_an_open_question(qtbot, still, keys, patience):
    from labcal.gui.ipc.messages import Answer, RunProcedure
    from labcal.record.stream import Prompt

    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    still.app_state.bench_worker.items.emit((Prompt(1.0, "why", "Why?", ()),))
    card = still.page("Run").live.prompt
    qtbot.waitUntil(lambda: card.alive, timeout=patience)
    entry = card.entry
    keys(entry, "EM-19", 0.01, Qt.Key.Key_Return)
    assert (entry.text(), shown(still)) == ("EM-19", None)  # where it was typed
    assert still.app_state.bench_worker.said == []
    entry.clear()
    keys(entry, "lift", 0.2, Qt.Key.Key_Return)
    assert still.app_state.bench_worker.said == [Answer("why", "lift")]


@pytest.mark.parametrize("focus", ["entry", "sidebar"])
def test_a_scan_answers_a_question_for_the_serial_wherever_the_focus_is(still, keys, focus):
    from labcal.gui.ipc.messages import Answer, RunProcedure
    from labcal.record.stream import Prompt

    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    asked = Prompt(1.0, "serial-mount-x", "Scan it.", (), acts=True, drawing={"serial": "EM-07"})
    still.app_state.bench_worker.items.emit((asked,))
    entry = still.page("Run").live.prompt.entry
    keys(entry if focus == "entry" else still.sidebar, "EM-19", 0.01, Qt.Key.Key_Return)
    assert still.app_state.bench_worker.said == [Answer("serial-mount-x", "EM-19")]
    assert still.app_state.lab.state.dut_serial == "EM-07"
    assert not still.scan_card.isVisible()


@pytest.mark.parametrize("apart_s", [0.015, 0.05, 0.2])
def test_what_a_person_types_stays_where_it_is_typed(still, keys, apart_s):
    still.top.operator.clear()
    keys(still.top.operator, "A. Smith", apart_s)
    assert still.top.operator.text() == "A. Smith"
    assert still.app_state.lab.state.dut_serial == "EM-07"


def test_keys_that_a_busy_window_hears_late_are_judged_by_when_they_were_struck(still, keys):
    operator, scanner = still.top.operator, still.scanner
    operator.clear()
    operator.setFocus()
    for n, letter in enumerate("Smith"):
        event = QKeyEvent(QEvent.Type.KeyPress, ord(letter.upper()), Qt.KeyboardModifier.NoModifier, letter)
        event.setTimestamp(5_000 + 200 * n)
        assert scanner.handle_key(operator, event)  # all at once by the clock on the wall
    scanner.flush()
    assert operator.text() == "Smith"


def test_a_badge_takes_the_place_of_a_name_and_quick_fingers_go_on_with_theirs(still, keys):
    operator = still.top.operator
    operator.setFocus()
    keys(still.top.dut, "", 0.2)  # whoever leaves the field has done with the name
    keys(operator, "A. Smith", 0.01, Qt.Key.Key_Return)
    assert (operator.text(), still.app_state.lab.state.operator) == ("A. Smith", "A. Smith")
    keys(operator, "jdoe@lab", 0.01, Qt.Key.Key_Return)
    assert still.app_state.lab.state.operator == "jdoe@lab"
    operator.selectAll()
    keys(operator, "Al", 0.2)
    keys(operator, "exander Doe", 0.01)
    assert (still.app_state.lab.state.operator, shown(still)) == ("Alexander Doe", None)


def test_a_lab_is_not_ready_until_the_question_of_a_scan_is_answered(still, keys):
    start, choose = still.page("Start"), still.page("Run").choose
    assert choose.start.isEnabled()
    keys(still.sidebar, "EM-19", 0.01)
    assert start.question.text() == choose.objection.text() == "Answer first whether EM-19 is the DUT."
    assert [one.isEnabled() for one in (still.next, choose.start, start.calibrate, start.morning)] == [False] * 4
    still.scan_card.leave.click()
    assert start.question.text().startswith("Ready. EM-07")
    assert [one.isEnabled() for one in (still.next, choose.start, start.calibrate, start.morning)] == [True] * 4


@pytest.mark.parametrize("then", ["page", "operator", "scan", "setting"])
def test_what_was_said_of_a_scan_is_past_with_the_next_input_that_is_accepted(still, keys, then):
    keys(still.sidebar, "EM-07/!?<b>", 0.01)
    assert still.message.text().startswith("✕ Scanned, and not taken")
    if then == "page":
        still.open_page("Start")
    elif then == "operator":
        keys(still.top.operator, "A. Smith", 0.01)
    elif then == "scan":
        keys(still.sidebar, "EM-19", 0.01)
    else:
        still.page("Run").choose.form.set_text("rate_deg_per_s", "20")
    assert still.message.text() == ""


def test_quick_fingers_in_a_number_field_are_no_scan(still, keys):
    field = still.page("Run").choose.form.fields["magnitudes_nT"]
    field.clear()
    keys(field, "20000; abc", 0.0315)  # xdotool type --delay 60
    assert (field.text(), shown(still)) == ("20000; abc", None)


@pytest.mark.parametrize("typed", ["50,5", "20000.5", "-1000", "2000, 50000"])
def test_a_number_typed_fast_into_a_field_of_numbers_is_no_scan_whatever_ends_it(still, keys, typed):
    field = still.page("Run").choose.form.fields["inclination_deg" if "," not in typed else "magnitudes_nT"]
    field.clear()
    keys(field, typed, 0.01, Qt.Key.Key_Tab)
    assert (field.text(), shown(still), still.app_state.lab.state.dut_serial) == (typed, None, "EM-07")


@pytest.mark.parametrize("typed", ["EM-19", "4006381333931", "10.00x20abc"])
def test_what_comes_fast_into_a_field_that_takes_text_stays_there(still, keys, typed):
    field = still.page("Run").choose.form.fields["inclination_deg"]
    field.clear()
    keys(field, typed, 0.01, Qt.Key.Key_Return)
    assert (field.text(), shown(still), still.app_state.lab.state.dut_serial) == (typed, None, "EM-07")


def test_a_day_typed_fast_is_the_day(still, keys):
    field = QLineEdit(still.top)
    field.show()
    keys(field, "2027-11-30", 0.012)
    assert (field.text(), shown(still)) == ("2027-11-30", None)
    field.deleteLater()


def test_what_has_blanks_is_no_scan_and_a_secret_that_missed_its_field_is_shown_nowhere(still, keys):
    keys(still.sidebar, "copper lamp river nine", 0.012, Qt.Key.Key_Return)
    assert shown(still) is None
    assert still.message.text() == "✕ Scanned, and not taken: no serial has blanks"


@pytest.mark.parametrize("page", ["Start", "Run", "Certificate"])
def test_the_question_of_a_scan_moves_nothing_of_the_page(still, keys, page):
    still.open_page(page)
    QApplication.processEvents()
    before = still.stack.geometry()
    keys(still.sidebar, "EM-19", 0.01)
    QApplication.processEvents()
    card = still.scan_card
    assert card.isVisible()
    assert still.stack.geometry() == before
    assert still.stack.rect().contains(card.geometry())
    assert still.childAt(card.take.mapTo(still, card.take.rect().center())) is card.take  # in front of the page
    card.leave.click()


@pytest.fixture
def measured(still):
    """Another DUT's run asks for a mounting."""
    from labcal.gui.ipc.messages import RunProcedure
    from labcal.record.stream import Prompt

    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    still.app_state.bench_worker.items.emit((Prompt(1.0, "mode-full", "Switch it.", ("done",), True),))
    return still


def test_quick_fingers_lose_no_letter_in_a_field_of_names_while_a_run_asks(measured, keys):
    measured.open_page("Certificate")
    steps = measured.page("Certificate").steps
    steps.key.opened = True
    steps.key.fold()
    keys(steps.key_name, "bob", 0.015)
    keys(steps.key_name, " lee", 0.015)
    assert steps.key_name.text() == "bob lee"


def test_what_is_typed_fast_into_a_note_of_a_run_is_the_note(measured, keys):
    note = measured.page("Run").live.note
    keys(note, "lift", 0.015)
    keys(note, " moved", 0.015)
    assert note.text() == "lift moved"
    note.clear()
    keys(note, "EM-19", 0.01, Qt.Key.Key_Return)  # as a scanner ends it
    assert note.text() == "EM-19"
    note.clear()


def test_a_path_that_is_typed_quickly_into_a_dialog_of_files_is_taken(still, keys, tmp_path):
    """It was held for a scan: the dialog had nothing of it."""
    dialog = QFileDialog(still, "", str(tmp_path))
    dialog.setOption(QFileDialog.Option.DontUseNativeDialog)
    dialog.show()
    field = dialog.findChild(QLineEdit, "fileNameEdit")
    keys(field, str(tmp_path / "made.json"), 0.002)
    assert field.text() == str(tmp_path / "made.json")
    assert shown(still) is None
    dialog.close()
    dialog.deleteLater()
