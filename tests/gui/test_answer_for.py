"""The check standard keeps a run from beginning: a person answers for it in the window, signed or not."""

import io

import pytest
from PySide6.QtCore import Qt

from labcal import session
from labcal.errors import OutOfControl, Stopped
from labcal.gui.ipc.bench_commands import run
from labcal.gui.ipc.channel import Channel
from labcal.gui.ipc.messages import AnswersFor, ListKeys, RunProcedure
from labcal.gui.ipc.wire import Fault, fault_of

WORDS = "the check standard CS-1 is out of control (offset x: a point beyond 3 sigma)"
REFUSED = OutOfControl(WORDS, "Measure it again (--dut CS-1)", file="/home/jdoe/bench.toml")
SECRET = "four words for nobody"


@pytest.fixture
def kept_from_beginning(still):
    """The card, below the fault of a run that was refused."""
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {"axes": "z"}, "EM-07", "J. Doe"))
    still.app_state.bench_worker.asked[-1].failed(fault_of(REFUSED))
    still.app_state.quick_worker.answer(ListKeys, ("roe",))
    return still.page("Run").live.answer_for


def begun(window):
    return window.app_state.bench_worker.commands(RunProcedure)[-1]


def test_who_answers_and_why_goes_with_the_same_order_and_begins_it(still, kept_from_beginning, qtbot):
    card, fault = kept_from_beginning, still.page("Run").live.fault
    assert (fault.heading.text(), fault.text.text()) == ("✕ The check standard is out of control", WORDS)
    assert "--" not in fault.remedy.text()
    assert (card.isVisible(), card.who.text(), card.begin.isEnabled()) == (True, "J. Doe", False)
    card.because.setText("it was dropped")
    qtbot.mouseClick(card.begin, Qt.MouseButton.LeftButton)
    by = AnswersFor("J. Doe", "it was dropped")
    assert begun(still) == RunProcedure("preflight", "bench.toml", {"axes": "z"}, "EM-07", "J. Doe", answered_for=by)
    assert still.app_state.run.alive
    assert not card.isVisible()


@pytest.mark.parametrize(("who", "because"), [("", "dropped"), ("J. Doe", " "), ("12|;", "dropped")])
def test_nothing_begins_without_a_name_and_a_reason(kept_from_beginning, who, because):
    kept_from_beginning.who.setText(who)
    kept_from_beginning.because.setText(because)
    assert not kept_from_beginning.begin.isEnabled()


def test_a_passphrase_goes_to_the_worker_and_stays_nowhere(still, kept_from_beginning, qtbot):
    card = kept_from_beginning
    card.because.setText("it was dropped")
    card.key.setCurrentIndex(1)
    assert not card.begin.isEnabled()
    card.passphrase.setText(SECRET)
    qtbot.mouseClick(card.begin, Qt.MouseButton.LeftButton)
    assert begun(still).answered_for == AnswersFor("J. Doe", "it was dropped", "roe", SECRET)
    assert SECRET not in repr(begun(still))
    assert (card.passphrase.text(), still.app_state.run.order.answered_for) == ("", None)


def test_where_the_key_does_not_open_it_is_asked_for_again(still, kept_from_beginning, qtbot):
    card = kept_from_beginning
    card.because.setText("it was dropped")
    card.key.setCurrentIndex(1)
    card.passphrase.setText("another key's")
    qtbot.mouseClick(card.begin, Qt.MouseButton.LeftButton)
    still.app_state.bench_worker.asked[-1].failed(Fault("input", "roe.pem: does not open"))
    assert card.isVisible()
    assert (card.because.text(), card.key.currentData(), card.passphrase.text()) == ("it was dropped", "roe", "")
    assert still.page("Run").live.fault.text.text() == "roe.pem: does not open"


def test_another_fault_asks_nobody_to_answer_for_it(still, kept_from_beginning):
    kept_from_beginning.passphrase.setText(SECRET)
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    assert not kept_from_beginning.isVisible()
    still.app_state.bench_worker.asked[-1].failed(fault_of(Stopped("stopped by the operator")))
    assert (kept_from_beginning.isVisible(), kept_from_beginning.passphrase.text()) == (False, "")


def test_the_worker_hands_it_to_the_session_and_says_no_passphrase_again(monkeypatch, pytestconfig):
    asked, going, begins = [], [], Channel.run_begins

    def watched(channel, simulated, told):
        going.append(told)
        begins(channel, simulated, told)

    def refused(*_, override, **__):
        asked.append(override)
        raise REFUSED

    monkeypatch.setattr(session, "run", refused)
    monkeypatch.setattr(Channel, "run_begins", watched)
    bench = str(pytestconfig.rootpath / "examples" / "simulated.toml")
    order = RunProcedure("preflight", bench, answered_for=AnswersFor("Dr. Roe", "dropped", "roe", SECRET))
    channel = Channel(io.StringIO(), io.StringIO())
    for one in (order, RunProcedure("preflight", bench)):
        with pytest.raises(OutOfControl):
            run(channel, one)
    assert asked == [session.Override("Dr. Roe", "dropped", "roe", SECRET), None]
    assert [told.order.answered_for for told in going] == [None, None]  # what a window that comes back hears
