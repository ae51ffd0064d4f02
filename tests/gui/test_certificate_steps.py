"""The Certificate page's steps, key, approve, sign, hand out: their order, their rules, and what moves where."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QApplication
from test_path import RUN, SIGNATURE, calibration

from labcal.gui.ipc.messages import Approve, ListCalibrations, ListKeys, NewKey, Sign
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.key_rules import as_key_name
from labcal.gui.viewmodels.signing import steps
from labcal.gui.widgets.stated_fields import day_stated

DRAFT = calibration(signed=False)
APPROVED = replace(DRAFT, approvers=("a.smith",))
ONE_SIGNED = replace(calibration(provisional=True), approvers=("a.smith",))
RELEASED = replace(calibration(), approvers=("jdoe@lab",))
NOT_VALID = calibration(valid=False)
OUTDATED = replace(RELEASED, standing=replace(RELEASED.standing, status="superseded"))
STATES = {  # file, who has a key, handed out: how key, approve, sign and hand out stand
    "nobody has a key": (DRAFT, (), False, "now later later later"),
    "the operator alone": (DRAFT, ("j.doe",), False, "now later later later"),
    "somebody else as well": (DRAFT, ("a.smith", "j.doe"), False, "done now later later"),
    "approved": (APPROVED, ("a.smith",), False, "done done now later"),
    "approved elsewhere": (APPROVED, (), False, "done done now later"),
    "one has signed": (ONE_SIGNED, ("a.smith",), False, "done done now later"),
    "signed alone": (calibration(provisional=True), ("j.doe",), False, "done never done now"),
    "released": (RELEASED, ("a.smith",), False, "done done done now"),
    "handed out": (RELEASED, ("a.smith",), True, "done done done done"),
    "not valid": (NOT_VALID, (), False, "done never never never"),
    "superseded": (OUTDATED, (), False, "done done done never"),
}
ALWAYS = ("nobody has a key", "somebody else as well", "approved", "released", "not valid")  # each button, and none


def certificate_page(window):
    window.resize(1360, 860)
    window.app_state.set_identity(dut="EM-07", operator="J. Doe")
    window.open_page("Certificate")
    return window.page("Certificate")


@pytest.fixture
def page(same_window):
    return certificate_page(same_window)


@pytest.fixture
def new_page(new_window):
    """Where what was typed before would count."""
    return certificate_page(new_window)


def settle():
    for _ in range(5):
        QApplication.processEvents()


def told(page, one, *keys):
    """The page knows this file, and who has a key."""
    worker = page._app_state.quick_worker
    worker.answer(ListCalibrations, (one,))
    worker.answer(ListKeys, keys)
    settle()


@pytest.mark.parametrize("state", STATES)
def test_each_step_has_its_state_and_says_why(state):
    one, keys, handed_out, marks = STATES[state]
    stands = steps(one, keys, "J. Doe", handed_out=handed_out)
    assert [step.mark for step in stands] == marks.split()
    assert all(step.words for step in stands if step.mark != "now")


@pytest.mark.parametrize(
    "state", [state if state in ALWAYS else pytest.param(state, marks=pytest.mark.slow) for state in STATES]
)
def test_one_button_at_most_is_blue_and_it_is_that_of_the_step_to_do_now(page, state):
    one, keys, handed_out, marks = STATES[state]
    if handed_out:
        page._app_state.path.take_handed_out(one)
    told(page, one, *keys)
    buttons = (page.steps.new_key, page.steps.approve, page.steps.sign, page.paper.export)
    assert [one.objectName() == "primary" for one in buttons] == [mark == "now" for mark in marks.split()]


def test_the_rules_stand_there_before_anything_is_typed(page):
    told(page, DRAFT)
    for rule in ("without blanks", "ten characters", "common word", "nothing brings it back"):
        assert rule in page.steps.key.rules.text()
    assert "No passphrase: an approval is a name in the draft. It binds once" in page.steps.approval.rules.text()
    assert page.steps.key.rules.isVisible()
    assert not page.steps.key.wrong.isVisible()


@pytest.mark.parametrize(
    ("name", "passphrase", "again", "said"),
    [
        pytest.param("ada smith", "", "", "No key can bear “ada smith”", marks=pytest.mark.slow),
        ("ada|", "", "", "No key can bear “ada|”"),
        pytest.param("jdoe", "", "", "jdoe has a key here already, as j.doe.", marks=pytest.mark.slow),
        pytest.param("ada.smith", "short", "", "has 5 characters and needs 10", marks=pytest.mark.slow),
        ("ada.smith", "password123", "", "a common word alone"),
        ("ada.smith", "four plain words here", "four plane", "The two passphrases differ."),
        pytest.param("ada.smith", "four plain words here", "four pl", "", marks=pytest.mark.slow),
    ],
)
def test_what_is_typed_for_a_key_is_checked_as_it_is_typed(page, name, passphrase, again, said):
    told(page, DRAFT, "j.doe")
    steps = page.steps
    for entry, text in ((steps.key_name, name), (steps.new_words, passphrase), (steps.again, again)):
        entry.setText(text)
    assert (said in steps.key.wrong.text(), steps.key.wrong.isVisible()) == (True, bool(said))
    assert not steps.new_key.isEnabled()


def test_who_measured_cannot_approve_and_is_said_so_before_the_click(new_page):
    page = new_page
    told(page, DRAFT, "a.smith", "j.doe")
    assert (page.steps.approver.currentText(), page.steps.approve.isEnabled()) == ("a.smith", True)
    page.steps.approver.setCurrentText("j.doe")
    assert page.steps.approval.wrong.text() == "✕ j.doe is the operator, J. Doe: another person approves."
    assert not page.steps.approve.isEnabled()


def place(widget):
    return widget.mapTo(widget.window(), QPoint(0, 0)), widget.size()


def test_a_second_click_on_new_key_falls_on_new_key_which_is_grey(page, qtbot):
    told(page, DRAFT)
    steps, worker = page.steps, page._app_state.quick_worker
    steps.key_name.setText("a.smith")
    for entry in (steps.new_words, steps.again):
        entry.setText("four plain words here")
    before = place(steps.new_key)
    qtbot.mouseClick(steps.new_key, Qt.MouseButton.LeftButton)
    worker.answer(NewKey, "a.smith")
    settle()
    assert place(steps.new_key)[0].x() == before[0].x()
    where = steps.new_key.mapTo(page.window(), steps.new_key.rect().center())
    under = page.window().childAt(where)
    assert under is steps.new_key
    assert not steps.new_key.isEnabled()
    qtbot.mouseClick(steps.new_key, Qt.MouseButton.LeftButton)
    assert [worker.commands(kind) for kind in (NewKey, Approve, Sign)] == [[], [], []]


def test_after_each_step_the_focus_is_where_the_next_one_begins(new_page, qtbot):
    page = new_page
    told(page, DRAFT)
    steps, worker = page.steps, page._app_state.quick_worker
    steps.key_name.setText("a.smith")
    for entry in (steps.new_words, steps.again):
        entry.setText("four plain words here")
    steps.new_key.setFocus()
    steps.new_key.click()
    worker.answer(NewKey, "a.smith")
    assert steps.approver.hasFocus() or steps.approver.isAncestorOf(page.focusWidget())
    assert steps.approver.currentText() == "a.smith"
    steps.approve.setFocus()
    steps.approve.click()
    worker.answer(Approve, APPROVED)
    assert steps.signer.currentText() == "a.smith"
    assert steps.passphrase.hasFocus()


def test_a_fault_squeezes_nothing_the_page_is_scrolled(page):
    told(page, DRAFT)
    before = [one.height() for one in (page.steps, page.table, page.paper)]
    page.fault.show_fault(Fault("input", "a reason of many words " * 8, "and what to do " * 8))
    settle()
    assert [one.height() for one in (page.steps, page.table, page.paper)] == before
    assert page.table.height() > 5 * page.table.verticalHeader().defaultSectionSize()


def test_a_fault_comes_into_sight_wherever_the_page_was_scrolled_to(page):
    page.window().resize(1024, 700)
    told(page, DRAFT)
    area = page.window().lazy_pages["Certificate"].area
    area.verticalScrollBar().setValue(area.verticalScrollBar().maximum())
    assert page.steps.visibleRegion().isEmpty()
    page.fault.show_fault(Fault("input", "a reason"))
    settle()
    assert page.fault.visibleRegion().boundingRect().height() == page.fault.height()


def test_the_signatures_of_others_are_awaited_by_name():
    one = replace(ONE_SIGNED, standing=replace(ONE_SIGNED.standing, signatures=(SIGNATURE,)))
    words = steps(one, ("b.jones",), "J. Doe")[2].words
    assert words == "Good to use as PROVISIONAL; a.smith has still to sign. Their key is not on this computer."


@pytest.mark.parametrize(
    ("typed", "day"),
    [("", ""), ("2027-11-29", "2027-11-29"), ("29.11.2027", "2027-11-29"), ("9.1.2027", "2027-01-09"),
     ("31.11.2027", None), ("soon", None), ("29.11.27", None)],
)  # fmt: skip
def test_a_day_is_taken_as_it_is_written(typed, day):
    assert day_stated(typed) == day


def test_what_is_refused_says_so_at_its_field_and_moves_nothing(new_page):
    page = new_page
    told(page, APPROVED, "a.smith")
    page.steps.passphrase.setText("wrong")
    page.steps.sign.click()
    before = page.steps.mapTo(page, QPoint(0, 0))
    (asked,) = [one for one in page._app_state.quick_worker.asked if isinstance(one.command, Sign)]
    asked.failed(Fault("input", "the passphrase is not that of the key"))
    settle()
    assert not page.fault.isVisible()
    assert page.steps.mapTo(page, QPoint(0, 0)) == before
    assert "passphrase" in page.steps.signature.wrong.text()
    assert page.steps.passphrase.property("state") == "bad"
    page.steps.passphrase.setText("again")
    assert page.steps.passphrase.property("state") == ""
    page.refresh()
    told(page, DRAFT, "a.smith")
    page.steps.approver.setCurrentText("a.smith")
    page.steps.stated.until.setText("31.11.2027")
    assert "“31.11.2027” is no day" in page.steps.approval.wrong.text()
    assert not page.steps.approve.isEnabled()
    assert page.steps.stated.until.property("state") == "bad"


def test_a_key_s_name_is_made_of_a_person_s_and_all_that_is_wrong_is_said(page):
    told(page, DRAFT)
    steps = page.steps
    for entry, words in ((steps.key_name, "L. Holm"), (steps.new_words, "short")):
        entry.setText(words)
    assert "“L. Holm”" in steps.key.wrong.text()
    assert "5 characters" in steps.key.wrong.text()
    steps.key_name.editingFinished.emit()
    assert steps.key_name.text() == "l.holm"
    assert "l.holm, made of “L. Holm”" in steps.key.done.text()
    assert [as_key_name(name) for name in ("Jürgen O'Brien", "山田", "a.smith")] == ["jurgen.o.brien", "", "a.smith"]


def test_what_was_done_is_said_in_the_card_of_its_step(new_page):
    page = new_page
    told(page, DRAFT, "a.smith")
    page.steps.approver.setCurrentText("a.smith")
    page.steps.approve.click()
    page._app_state.quick_worker.answer(Approve, APPROVED)
    assert page.steps.approval.done.text() == "Approved by a.smith."
    assert not page.paper.said.text()


def test_until_when_it_will_be_good_and_whence_that_comes_is_said_before_it_is_signed(page):
    told(page, DRAFT, "a.smith", "j.doe")
    valid, beside_its_field = page.steps.valid, page.steps.valid_once_approved
    assert valid.isVisible()
    assert valid.text() == "No last day of use is stated: it never expires by itself."
    page.steps.stated.until.setText("2027-11-21")
    assert valid.text() == "Good until 2027-11-21."  # whence stands once, where it is stated
    assert beside_its_field.text().startswith(f"{valid.text()} That day is stated by who approves (2), by the interval")
    page.steps.stated.until.setText("2025-01-01")
    assert page.steps.stated.until.property("state") == "bad"
    assert not page.steps.approve.isEnabled()
    assert "2025-01-01 is over" in page.steps.approval.wrong.text()
    for refused in ("2025-01-01", "21.13.2027", "31.2.2027"):  # one is stated, and it is not taken
        page.steps.stated.until.setText(refused)
        assert page.steps.approval.wrong.text()
        assert (valid.text(), beside_its_field.text()) == ("", "")
    page.steps.stated.until.setText("")
    assert valid.text().startswith("No last day of use is stated")
    page.refresh()
    told(page, replace(APPROVED, until="2027-11-21"), "a.smith")
    assert valid.text() == "Good until 2027-11-21. So it was stated when it was approved."
    page.refresh()
    told(page, replace(RELEASED, until="2027-11-21"), "a.smith")
    assert valid.text() == "Good until 2027-11-21."


def test_next_is_said_of_one_thing_what_is_shown_of_another_dut_is_to_be_done_here(page):
    told(page, DRAFT, "a.smith", "j.doe")
    page._app_state.set_identity(dut="EM-99")
    assert (page.to_do.text(), page.window().next.text()) == ("To do here: Approve (2)", "Next: Calibrate EM-99")


def test_what_a_field_wants_is_read_to_its_end_beside_the_others(page):
    told(page, DRAFT, "a.smith", "j.doe")
    page.window().resize(1024, 700)
    settle()
    for field in page.names.laboratory[1:]:
        assert field.fontMetrics().horizontalAdvance(field.placeholderText()) < field.contentsRect().width() - 20


def test_an_empty_last_day_is_said_beside_its_field_before_anybody_approves(new_page):
    page = new_page
    told(page, DRAFT, "a.smith", "j.doe")
    said, card = page.steps.valid_once_approved, page.steps.approval
    assert card.isAncestorOf(said)
    assert said.isVisible()
    assert said.text().startswith("No last day of use is stated: it never expires by itself.")
    page.steps.stated.until.setText("2099-11-21")
    assert said.text().startswith("Good until 2099-11-21.")
    told(page, APPROVED, "a.smith", "j.doe")
    assert not said.isVisible()
    assert page.steps.valid.text().endswith("None was when it was approved, and none can be added any more.")


@pytest.mark.parametrize(
    ("method", "left_nT", "says"),
    [
        ("ml", 130.52, "▲ Not traced: 130.5 nT of |b| are left over beyond the map"),
        ("ml", None, "▲ Not traced: nobody has looked for the cause"),
        ("closed-loop", 9.0, ""),
    ],
)
def test_a_run_that_was_never_traced_says_so_above_its_approval(page, method, left_nT, says):
    page._app_state.path.take_runs((RUN,))
    told(page, replace(DRAFT, method=method, left_nT=left_nT), "a.smith", "j.doe")
    assert page.doubt.text().startswith(says)
    assert page.doubt.isVisible() is bool(says)
    assert page.to_do.text() == page.window().next.text() == "Next: Trace the residual"  # one source for both
    assert page.steps.approval.mark.text() == "● to do now"  # and it may be approved as it is
    page._app_state.path.take_runs((replace(RUN, verdict="explained"),))
    assert not page.doubt.isVisible()
    assert page.to_do.text() == "Next: Approve (2)"


def test_fields_and_buttons_of_a_row_stand_at_one_height_where_one_mark_has_no_room_beside_its_heading(page):
    page.window().resize(1024, 700)
    told(page, DRAFT, "a.smith", "j.doe")
    page.steps.approval.mark.setText("● to do now, by somebody else")
    settle()
    cards = page.steps.key, page.steps.approval, page.steps.signature
    assert page.steps.approval.mark.y() > page.steps.approval.heading.y() + page.steps.approval.heading.height() // 2
    firsts = page.steps.key_name, page.steps.approver, page.steps.signer
    assert len({one.mapTo(page, one.rect().topLeft()).y() for one in firsts}) == 1
    assert len({card.button.mapTo(page, card.button.rect().topLeft()).y() for card in cards}) == 1


def test_each_sentence_on_how_a_file_stands_has_its_line_and_nobody_is_awaited_once_it_is_signed(page):
    told(page, DRAFT, "a.smith")
    assert page.standing.text() == "Operator J. Doe; approved by nobody yet."
    said = ("VALID: signed by jdoe@lab.", "SIMULATED: it describes no real sensor.")
    signed = calibration()
    page.refresh()
    told(page, replace(signed, standing=replace(signed.standing, sentences=said)), "a.smith")
    assert page.standing.text().splitlines() == [*said, "Operator J. Doe."]


def test_enter_in_the_passphrase_signs_or_says_what_is_missing(qtbot, page):
    told(page, APPROVED, "a.smith")
    sign = page.steps
    qtbot.keyClick(sign.passphrase, Qt.Key.Key_Return)
    assert sign.signature.wrong.text() == "✕ Type the passphrase first."
    sign.passphrase.setText("four words are easy")
    sign.names_known()
    page.names.line = lambda: ""
    sign._lacks = lambda: ""  # whom it names was asked before
    qtbot.keyClick(sign.passphrase, Qt.Key.Key_Return)
    assert isinstance(page._app_state.quick_worker.asked[-1].command, Sign)


def test_the_page_stays_where_it_is_as_its_file_is_signed(qtbot, page, same_window):
    """It rolled down to what Qt gives the focus next, and that it is signed was out of sight."""
    same_window.resize(1024, 700)
    told(page, APPROVED, "a.smith")
    sign, area = page.steps, same_window.lazy_pages["Certificate"].area
    sign._lacks = lambda: ""
    sign.passphrase.setText("four words are easy")
    area.ensureWidgetVisible(sign.sign)
    settle()
    before = area.verticalScrollBar().value()
    qtbot.mouseClick(sign.sign, Qt.MouseButton.LeftButton)
    settle()
    assert area.verticalScrollBar().value() == before
    page._app_state.quick_worker.asked[-1].then(RELEASED)
    settle()
    assert area.verticalScrollBar().value() <= before


def test_what_a_step_says_is_not_said_twice(qtbot, new_page):
    page = new_page
    told(page, DRAFT, "a.smith")
    qtbot.mouseClick(page.steps.approve, Qt.MouseButton.LeftButton)
    page._app_state.quick_worker.asked[-1].then(APPROVED)
    settle()
    assert page.steps.approval.words.text() == "Approved by a.smith."
    assert page.steps.approval.words.isVisible()
    assert not page.steps.approval.done.isVisible()
