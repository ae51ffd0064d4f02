"""What a technician reads and switches: the loop without figures, theme and size in the window, a key where none is."""

import re
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import pytest
from PySide6.QtCore import Qt
from test_choose import looked_at, told_by_the_loop
from test_path import calibration

from labcal.gui.ipc.messages import CloseLoop, ListCalibrations, ListKeys, LookAt, NewKey
from labcal.gui.theming.chosen import chosen_theme
from labcal.gui.theming.theme import DARK, LIGHT
from labcal.gui.viewmodels.loop_words import MEANS, as_a_drop, plain_reason, said_plainly
from labcal.gui.widgets import secret
from labcal.loop.narrative import why_accepted, why_rejected


@pytest.mark.parametrize("verdict", MEANS)
def test_the_loop_is_said_without_figures_and_names_the_cause_where_it_has_one(verdict):
    loop = replace(told_by_the_loop("reverse"), verdict=verdict, summary="50 to 30 nT held out (p = 0.001)")
    said = said_plainly(loop)
    assert not re.search(r"\d+ (nT|nats)|p =|held out", said)
    assert ("offset-current (i_eps)" in said) == (verdict not in ("clean", "unexplained"))


def test_nats_are_said_of_a_cause_that_is_chosen_and_not_in_the_list(still, qtbot, patience):
    worker, study, page = still.app_state.fit_worker, still.app_state.study_vm, still.page("Loop")
    study.open("r1")
    worker.answer(LookAt, looked_at("r1"))
    study.close_loop()
    told = told_by_the_loop("reverse")
    fell = SimpleNamespace(before=9.0, after=8.0)
    wander, little, much = (SimpleNamespace(evidence=e, drop=1.0) for e in (-3.1, 5.0, 728.0))
    reasons = [why_rejected(wander), why_rejected(little), why_accepted(fell, much)]
    named = [replace(told.accepted[0], why=one) for one in reasons]
    worker.answer(CloseLoop, replace(told, accepted=tuple(named[2:]), rejected=tuple(named[:2])))
    qtbot.waitUntil(lambda: page.others.rowCount() == 4, timeout=patience)
    rows = [[page.others.text(row, column) for column in range(5)] for row in range(4)]
    assert not [one for row in rows for one in row if "nats" in one]
    assert [row[2] for row in rows] == ["enough", "–", "no evidence", "too little"]
    assert [row[4] for row in rows if "rival" not in row[3]] == [
        "it alone takes 1.0 nT off the held-out rms beside declared errors",
        "no better than chance or a slow wander", "too little evidence"
    ]  # fmt: skip
    page.others.selectRow(0)
    qtbot.waitUntil(lambda: page.change_why.text().endswith(as_a_drop(reasons[2])), timeout=patience)
    assert "728.0 nats" in page.change_why.text()


def test_a_cause_that_stays_chosen_has_the_reason_of_the_answer_that_is_shown(still, qtbot, patience):
    worker, study, page = still.app_state.fit_worker, still.app_state.study_vm, still.page("Loop")
    study.open("r1")
    worker.answer(LookAt, looked_at("r1"))
    told = told_by_the_loop("reverse")
    for why in ("by the first answer", "by the second"):
        study.close_loop()
        accepted = tuple(replace(one, why=why) for one in told.accepted)
        worker.answer(CloseLoop, replace(told, accepted=accepted, rejected=()))
        qtbot.waitUntil(lambda: page.others.rowCount() > 0, timeout=patience)
        page.others.selectRow(0)
        qtbot.waitUntil(lambda why=why: page.change_why.text().endswith(why), timeout=5000)


def test_a_cause_that_is_not_named_says_so_without_the_square_of_the_noise():
    step = SimpleNamespace(evidence=900.0, drop=26.0)
    assert plain_reason(why_rejected(step)) == "explains nothing beyond what is named already"
    step = SimpleNamespace(evidence=900.0, drop=1e-6)
    assert plain_reason(why_rejected(step)) == "explains too little to be worth its parameters"
    assert plain_reason("of its own") == "of its own"


def test_the_figures_of_the_loop_are_one_click_deeper(still, qtbot):
    page = still.page("Loop")
    assert page.summary.isHidden()
    page.fold.click()
    assert not page.summary.isHidden()
    page.fold.click()


def test_theme_and_size_are_switched_in_the_window_and_the_theme_is_kept(still, qtbot):
    try:
        qtbot.mouseClick(still.theme_switch, Qt.MouseButton.LeftButton)
        assert (still.theme, chosen_theme(still.app_state.settings), still.theme_switch.text()) == (
            DARK,
            DARK,
            "Go light",
        )
        qtbot.mouseClick(still.theme_switch, Qt.MouseButton.LeftButton)
        assert (still.theme, chosen_theme(still.app_state.settings), still.theme_switch.text()) == (
            LIGHT,
            LIGHT,
            "Go dark",
        )
        qtbot.mouseClick(still.size_switch, Qt.MouseButton.LeftButton)
        assert (still.wall, still.size_switch.text()) == (True, "Smaller   F11")
    finally:
        still.app_state.settings.remove("theme")
        still.toggle_wall()
        still.style_queue.finish()


def test_where_nobody_has_a_key_one_is_made_first_and_no_passphrase_stays(still, qtbot):
    still.open_page("Certificate")
    page, worker = still.page("Certificate"), still.app_state.quick_worker
    steps = page.steps
    worker.answer(ListCalibrations, (calibration(signed=False),))
    worker.answer(ListKeys, ())
    assert (steps.new_key.isEnabled(), steps.approve.isEnabled(), steps.sign.isEnabled()) == (False, False, False)
    steps.key_name.setText("jdoe@lab")
    for entry in (steps.new_words, steps.again):
        entry.setText("a long passphrase")
    qtbot.mouseClick(steps.new_key, Qt.MouseButton.LeftButton)
    assert worker.commands(NewKey) == [NewKey("jdoe@lab", "a long passphrase")]
    steps.passphrase.setText("a long passphrase")
    still.open_page("History")
    assert [one.text() for one in (steps.passphrase, steps.new_words, steps.again)] == ["", "", ""]
    steps.key_name.clear()


def test_from_the_first_letter_of_a_passphrase_the_window_leaves_no_core_dump(still, qtbot, monkeypatch):
    still.open_page("Certificate")
    page, kept = still.page("Certificate"), []
    monkeypatch.setattr(secret, "kept_private", lambda: kept.append(True))
    answers = still.page("Run").live.answer_for.passphrase
    for entry in (page.steps.passphrase, page.steps.new_words, page.steps.again, answers):
        entry.setEnabled(True)
        kept.clear()
        qtbot.keyClicks(entry, "a")
        assert kept
        entry.clear()


def test_which_calibration_is_chosen_is_whole_in_its_tip(still):
    still.open_page("Certificate")
    one = replace(calibration(), run_id="20261123T150524-95b0")
    still.app_state.quick_worker.answer(ListCalibrations, (one,))
    chooser = still.page("Certificate").list
    assert chooser.toolTip() == chooser.currentText()
    assert Path(one.path).stem in chooser.toolTip()
    still.app_state.path.take_calibrations(())
