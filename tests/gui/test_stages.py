"""Where a calibration file is on its way, and the one thing to do; what stands first on its page."""

import re
from dataclasses import replace

import pytest
from PySide6.QtWidgets import QApplication, QFileDialog
from test_certificate_steps import APPROVED, DRAFT, NOT_VALID, OUTDATED, RELEASED, certificate_page, settle, told
from test_path import RUN, calibration

from labcal.gui.ipc.customer_messages import Named, Party, StateNames, WhoIsNamed
from labcal.gui.ipc.messages import ListCalibrations, Sign, VerifyFile
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.stages import stages
from labcal.gui.widgets import next_button

ALONE = calibration(provisional=True)
NOBODY, BOTH = Named("", ""), Named("A lab, Bern (CH)", "Holm AS, Oslo (NO)")


@pytest.fixture
def page(new_window):
    return certificate_page(new_window)


@pytest.mark.parametrize(
    ("one", "handed_out", "verified", "said"),
    [
        (DRAFT, False, False, "● Approve  →  ○ Sign  →  ○ Release  →  ○ Hand out  →  ○ Verify"),
        (RELEASED, False, False, "✓ Approve  →  ✓ Sign  →  ✓ Release  →  ● Hand out  →  ○ Verify"),
        (RELEASED, True, True, "✓ Approve  →  ✓ Sign  →  ✓ Release  →  ✓ Hand out  →  ✓ Verify"),
        (
            calibration(provisional=True),
            True,
            False,
            "– Approve  →  ✓ Sign  →  ▲ provisional  →  ✓ Hand out  →  ● Verify",
        ),
        (NOT_VALID, False, False, "✓ Sign  →  ✕ not valid"),
        (OUTDATED, True, True, "✓ Sign  →  ▲ superseded"),
    ],
)
def test_a_file_is_at_one_stage(one, handed_out, verified, said):
    assert stages(one, handed_out=handed_out, verified=verified) == said


def test_first_stands_what_it_is_then_what_to_do_and_the_figures_last(page):
    told(page, APPROVED, "a.smith")
    order = (page.drop, page.detail, page.steps, page.paper, page.figures)
    tops = [part.y() for part in order]
    assert tops == sorted(tops)
    assert page.to_do.text() == "To do here: Sign (3)"
    assert page.drop.choose.text() == "Verify a file …"
    assert page.drop.choose.y() < page.detail.y()


def test_the_fourth_step_keeps_its_place_and_those_that_are_done_are_folded(page):
    told(page, RELEASED, "a.smith")
    assert page.steps.y() < page.paper.y()  # it jumped above the others at the last signature
    assert not page.steps.passphrase.isVisible()
    page.steps.signature.unfold.click()
    assert page.steps.passphrase.isVisible()
    page.refresh()
    told(page, APPROVED, "a.smith")
    assert page.steps.y() < page.paper.y()
    assert page.steps.passphrase.isVisible()


def known(page, said):
    page._app_state.quick_worker.answer(WhoIsNamed, said)
    settle()


def test_who_is_not_named_is_asked_for_before_a_signature_and_nobody_is_a_second_press(page):
    told(page, APPROVED, "a.smith")
    assert not page.names.isVisible()  # it is not known yet
    known(page, NOBODY)
    assert page.names.isVisible()
    page.steps.passphrase.setText("four words for it")
    page.steps.sign.click()
    asked = page._app_state.quick_worker.asked
    assert not [one for one in asked if isinstance(one.command, Sign)]
    assert (page.steps.sign.text(), page.steps.signature.asked.isVisible()) == ("Sign it all the same", True)
    page.steps.sign.click()
    assert [one for one in asked if isinstance(one.command, Sign)]


def test_a_double_click_on_sign_is_no_answer_to_what_the_first_click_asks(page, monkeypatch):
    monkeypatch.setattr(next_button, "TOO_SOON_MS", 700)
    told(page, APPROVED, "a.smith")
    known(page, NOBODY)
    page.steps.passphrase.setText("four words for it")
    page.steps.sign.click()
    page.steps.sign.click()
    asked = page._app_state.quick_worker
    assert (asked.commands(Sign), page.steps.signature.asked.isVisible()) == ([], True)
    monkeypatch.setattr(next_button, "TOO_SOON_MS", 0)
    page.steps.sign.click()
    assert asked.commands(Sign)


def test_who_is_named_stands_there_with_its_title_before_the_key_so_that_nothing_is_pushed_down(page):
    told(page, DRAFT)
    known(page, NOBODY)
    assert (page.names.isVisible(), page.names.heading.text()) == (True, "Named on the certificate")
    before = page.steps.y()
    page.refresh()
    told(page, DRAFT, "a.smith")
    assert page.steps.y() == before


def test_a_country_may_be_written_out_and_what_is_none_is_said(page):
    told(page, DRAFT)
    known(page, NOBODY)
    for field, words in zip(page.names.laboratory, ("A lab", "Bern", "Atlantis"), strict=True):
        field.setText(words)
    assert (page.names.keep.isEnabled(), page.names.wrong.isVisible()) == (False, True)
    assert page.names.wrong.text() == "✕ “Atlantis” is no country: two letters, as DE, or its name."
    for typed in ("Germany", "Deutschland", "de"):
        page.names.laboratory[2].setText(typed)
        assert (page.names.keep.isEnabled(), page.names.wrong.isVisible()) == (True, False)
    page.names.keep.click()
    (asked,) = page._app_state.quick_worker.commands(StateNames)
    assert asked.laboratory == Party("A lab", "Bern", "DE")


def test_who_is_kept_is_seen_and_may_be_changed_until_it_is_signed(page):
    told(page, DRAFT)
    known(page, Named("A lab, Bern (CH)", ""))
    assert page.names.stated.text() == "Laboratory: A lab, Bern (CH)"
    assert (page.names.laboratory[0].isVisible(), page.names.customer[0].isVisible()) == (False, True)
    page.names.change.click()
    assert page.names.laboratory[0].isVisible()


def test_where_both_are_named_it_says_so_and_asks_nothing(page):
    told(page, APPROVED, "a.smith")
    known(page, BOTH)
    assert (page.names.isVisible(), page.named.text()) == (
        True,
        "",
    )
    assert page.names.stated.text() == "Laboratory: A lab, Bern (CH)   Customer: Holm AS, Oslo (NO)"
    assert not page.names.keep.isVisible()
    page.steps.passphrase.setText("four words for it")
    page.steps.sign.click()
    assert [one for one in page._app_state.quick_worker.asked if isinstance(one.command, Sign)]


def test_after_a_signature_nobody_is_asked_for_any_more_but_it_is_said(page):
    told(page, replace(RELEASED), "a.smith")
    known(page, NOBODY)
    assert (page.names.isVisible(), page.named.text()) == (
        False,
        "The certificate names no laboratory and no customer.",
    )


def test_steps_below_each_other_are_folded_but_the_one_to_do_now(page):
    told(page, APPROVED, "a.smith")
    page.steps.setFixedWidth(300)
    settle()
    folded = [not card.holder.isVisible() for card in (page.steps.key, page.steps.approval, page.steps.signature)]
    assert folded == [True, True, False]
    page.steps.key.unfold.click()
    assert page.steps.key_name.isVisible()


def test_what_was_verified_is_said_with_file_and_time_until_another_dut_comes(page, monkeypatch, tmp_path):
    told(page, RELEASED, "a.smith")
    page.verify("c.json")
    page._app_state.quick_worker.answer(VerifyFile, RELEASED.standing)
    assert page.drop.name.text() == "✓ c.json"
    assert re.match(r"checked at \d\d:\d\d:\d\d: ", page.drop.words.text())
    page._app_state.set_identity(dut="EM-99")
    told(page, RELEASED, "a.smith")
    assert not page.drop.words.isVisible()
    opened = []
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *said: opened.append(said[2]) or ("", ""))
    page.paper.handed_out.emit(RELEASED, str(tmp_path / "EM-07.json"))
    page.drop.choose.click()
    assert opened == [str(tmp_path)]


def test_why_keep_is_grey_is_said_as_long_as_it_is(page):
    told(page, DRAFT)
    known(page, NOBODY)
    for field, words in zip(page.names.laboratory, ("A lab", "", "Germany"), strict=True):
        field.setText(words)
    assert (page.names.keep.isEnabled(), page.names.wrong.text()) == (
        False, "Keep waits for: Laboratory on the certificate: City."
    )  # fmt: skip
    page.names.laboratory[1].setText("Bern")
    assert (page.names.keep.isEnabled(), page.names.wrong.isVisible()) == (True, False)
    page.names.keep.click()
    assert (page.names.keep.isEnabled(), page.names.wrong.text()) == (False, "Being kept …")
    page._app_state.quick_worker.asked[-1].failed(Fault("input", "The disk is full."))
    assert (page.names.keep.isEnabled(), page.names.wrong.isVisible()) == (True, False)


@pytest.mark.parametrize(("one", "words"), [(DRAFT, "Approve (2)"), (APPROVED, "Sign (3)")])
def test_of_a_draft_one_set_of_steps_is_in_sight_and_next_says_the_same_everywhere(page, one, words):
    page._app_state.path.take_runs((replace(RUN, verdict="explained"),))
    told(page, one, "a.smith")
    assert (page.stage.isVisible(), page.to_do.text()) == (False, f"Next: {words}")
    assert page.window().next.text() == f"Next: {words}"


def test_who_approved_is_said_once(page):
    told(page, APPROVED, "a.smith")
    page.steps.approval.say_done(page.steps.approval.words.text())
    assert not page.steps.approval.done.isVisible()
    page.steps.approval.say_done("Something else.")
    assert page.steps.approval.done.isVisible()


def test_the_verdict_on_a_file_has_no_holes_between_its_lines(page):
    page._app_state.quick_worker.answer(ListCalibrations, ())  # nothing below takes the room
    page.drop.say("✓ EM-07.json", "checked at 11:09:49: VALID: signed by a.smith.", "good")
    settle()
    card = page.drop.card
    lines = sum(part.sizeHint().height() for part in (page.drop.name, page.drop.words, page.drop.close_card))
    margins = card.body.contentsMargins()
    assert card.height() <= lines + margins.top() + margins.bottom() + 2 * card.body.spacing() + 2


def test_who_keeps_the_names_goes_on_with_what_is_next(page):
    """The focus went to "Whose key", where there is one."""
    told(page, DRAFT, "a.smith")
    known(page, NOBODY)
    page.activateWindow()
    for field, words in zip(page.names.laboratory, ("A lab", "Bern", "CH"), strict=True):
        field.setText(words)
    page.names.keep.setFocus()
    page.names.keep.click()
    assert page.names.isAncestorOf(QApplication.focusWidget())  # as long as it is kept
    page._app_state.quick_worker.answer(StateNames, BOTH)
    assert QApplication.focusWidget() is page.begins_at
    assert not page.steps.key.isAncestorOf(page.begins_at)
