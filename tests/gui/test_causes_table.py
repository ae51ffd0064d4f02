"""The causes on the Loop page are a table: figures stand in columns, any column sorts it, and no reason is cut."""

from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from test_choose import looked_at, told_by_the_loop

from labcal.gui.ipc.messages import CloseLoop, LookAt
from labcal.gui.viewmodels.loop_causes import CAUSE, EVIDENCE, REASON, TAKES_OFF, VERDICT, cause_rows
from labcal.model.records import EffectRecord

LONG = "taken, and given up on held-out blocks: 50.0 to 49.0 nT, but it is a detail beside others, or too much is left"


def refused(effect, why, *, before_nT=None, after_nT=None):
    return EffectRecord(
        effect, (), {}, "sensor", (), why=why, holdout_rms_before_nT=before_nT, holdout_rms_after_nT=after_nT
    )


def told():
    """One cause named, with a rival; three that are not, for as many reasons."""
    found = told_by_the_loop("reverse")
    why = "the held-out rms falls from 50.0 to 30.0 nT; evidence over a slow wander without a name: 40 nats, 12 needed"
    rejected = (
        refused("cross-field", "no better than chance or a slow wander: evidence −13.6 nats, 12 needed"),
        refused("gain-step", "too little evidence: 7.0 nats, 12 needed"),
        refused("axis-tilt", LONG, before_nT=50.0, after_nT=49.0),
    )
    return replace(found, accepted=(replace(found.accepted[0], why=why),), rejected=rejected)


@pytest.fixture
def page(still, qtbot, patience):
    still.open_page("Loop")
    study, worker = still.app_state.study_vm, still.app_state.fit_worker
    study.open("r1")
    worker.answer(LookAt, looked_at("r1"))
    study.close_loop()
    worker.answer(CloseLoop, told())
    shown = still.page("Loop")
    qtbot.waitUntil(lambda: shown.others.rowCount() == 5, timeout=patience)
    size = still.size()
    yield shown
    for order in (CAUSE, VERDICT):  # the window is left as it was
        shown.others.sort_by(order)
    shown.others.clearSelection()
    still.resize(size)


def column(page, number):
    return [page.others.text(row, number) for row in range(page.others.rowCount())]


def test_what_it_takes_off_and_the_evidence_are_the_loops_own():
    rows = {row.cause.effect: row for row in cause_rows(told())}
    assert {name: row.takes_off_nT for name, row in rows.items()} == {
        "offset-current": 20.0, "offset-drift": 19.0, "cross-field": None, "gain-step": None, "axis-tilt": 1.0
    }  # fmt: skip
    assert {name: row.evidence for name, row in rows.items()} == {
        "offset-current": "enough", "offset-drift": "–", "cross-field": "no evidence", "gain-step": "too little",
        "axis-tilt": "–",
    }  # fmt: skip


def test_figures_are_sorted_as_figures_and_what_is_chosen_stays_chosen(page):
    page.others.selectRow(column(page, CAUSE).index("gain-step"))
    page.others.sort_by(TAKES_OFF)
    assert column(page, TAKES_OFF) == ["20.0", "19.0", "1.0", "–", "–"]
    assert page.picked().cause.effect == "gain-step"
    page.others.sort_by(EVIDENCE)
    assert column(page, EVIDENCE)[:3] == ["enough", "too little", "no evidence"]
    page.others.sort_by(EVIDENCE)
    assert column(page, EVIDENCE)[-3:] == ["no evidence", "too little", "enough"]
    assert page.picked().cause.effect == "gain-step"


def test_it_is_sorted_by_keys_alone(page, still, qtbot):
    still.style_queue.finish()
    page.others.setFocus()
    assert column(page, VERDICT)[0] == "✓ named"
    qtbot.keyClick(page.others, Qt.Key.Key_Down, Qt.KeyboardModifier.ControlModifier)
    assert column(page, VERDICT)[-1] == "✓ named"
    qtbot.keyClick(page.others, Qt.Key.Key_Right, Qt.KeyboardModifier.ControlModifier)
    assert column(page, CAUSE) == sorted(column(page, CAUSE))
    qtbot.keyClick(page.others, Qt.Key.Key_Right, Qt.KeyboardModifier.ControlModifier)
    assert page.others.horizontalHeader().sortIndicatorSection() == TAKES_OFF  # past the ids, which are hidden here
    for _ in range(3):
        qtbot.keyClick(page.others, Qt.Key.Key_Left, Qt.KeyboardModifier.ControlModifier)
    assert column(page, REASON) == sorted(column(page, REASON))  # before the first column comes the last


def test_the_reason_of_what_is_chosen_stands_whole_below(page, still, qtbot):
    still.resize(1024, 700)
    still.style_queue.finish()
    page.others.selectRow(column(page, CAUSE).index("axis-tilt"))
    assert page.change_why.text() == f"axis-tilt: {LONG}"
    words = page.change_why
    qtbot.waitUntil(lambda: words.height() >= words.heightForWidth(words.width()) > words.fontMetrics().height())
    page.others.clearSelection()
    assert page.change_why.text() == "Choose one to see what it alone would change."
