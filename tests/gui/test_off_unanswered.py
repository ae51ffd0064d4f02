"""COILS OFF that nobody answers is red after two seconds (of lines that nobody has read yet after five), with who is
to be switched off by hand.
"""

import re
import time

from lab_states import told
from PySide6.QtCore import Qt

from labcal.bench.coils.at_zero import FREE_S
from labcal.bench.coils.state import CoilReading, LabState, Witness
from labcal.gui.ipc.answers import CoilEnd, Ended, SwitchedOff
from labcal.gui.ipc.lab_messages import InstrumentRead, ReadLab
from labcal.gui.ipc.messages import RunProcedure, SwitchOff
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels import app_state as module
from labcal.gui.viewmodels.known_lab import ANSWERS_S

ALL = "Switch off by hand: supply_x, supply_y, supply_z"
DOUBT = "it sees 20567 1260 12860 nT, 20366 1132 -43695 nT expected: 98.90 µT apart, 2.00 µT allowed"
ADVICE = "It is as if +1.10 A flowed in coil z: open the output of supply_z at its panel, or switch it off at its mains"


def ends(**silent):
    """As a worker says it: at zero but those that are named, with why."""
    return tuple(
        CoilEnd(a, None, silent[a], False)
        if a in silent
        else CoilEnd(a, 0.0, "zero, open", True, module.time.monotonic())
        for a in "xyz"
    )


def was_read(window, current_A=0.0):
    at_s = module.time.monotonic()
    zero = not current_A
    window.app_state.take_lab(LabState(tuple(CoilReading(a, None, current_A, zero, None, at_s) for a in "xyz")))


def test_nobody_is_sent_to_a_supply_that_nobody_has_asked_yet(qtbot, still, later):
    """The bench was just opened: the lines are to be opened first, and say meanwhile what is being done."""
    qtbot.keyClick(still, Qt.Key.Key_F12)
    later(FREE_S - 0.5)
    assert not still.fault.isVisible()
    assert still.app_state.lab.state.message == "Coils off: reading them back …"
    assert still.side.keep_off.text().endswith("HANDS OFF")
    later(1.0)
    assert (still.fault.isVisible(), still.fault.by_hand.text()) == (True, ALL)


def test_a_refusal_is_said_at_once(qtbot, still):
    qtbot.keyClick(still, Qt.Key.Key_F12)
    still.app_state.off_worker.asked[-1].failed(Fault("instrument", "a guardian holds the ports and does not answer."))
    assert (still.fault.isVisible(), still.fault.by_hand.text()) == (True, ALL)


def test_with_every_line_silent_it_is_red_as_soon_as_an_answer_is_missed(qtbot, still, later):
    was_read(still)
    later(0.1)
    qtbot.keyClick(still, Qt.Key.Key_F12)
    later(ANSWERS_S - 0.5)
    assert not still.fault.isVisible()
    assert still.side.zero_words.property("state") == "warning"
    later(1.0)
    assert still.fault.isVisible()
    assert (still.fault.heading.text(), still.fault.by_hand.text()) == ("✕ HANDS OFF: the coils may be on", ALL)
    assert still.side.zero_words.text() == "✕ coils NOT confirmed at zero"
    assert still.next.text() == "Next: See to the coils"


def test_that_it_was_pressed_stands_on_the_card_until_each_coil_was_read_back(qtbot, still, later):
    """Pressed again where the card stood already: else nothing would have come of it that anybody sees."""
    app_state = still.app_state
    qtbot.keyClick(still, Qt.Key.Key_F12)
    later(ANSWERS_S + 0.5)
    app_state.off_worker.asked[-1].failed(Fault("ended", "The work was killed (signal 9, SIGKILL)."))
    app_state.off.pressed = "00:00:00"  # the first time
    qtbot.keyClick(still, Qt.Key.Key_F12)
    app_state.off_worker.answer(SwitchOff, SwitchedOff(ends(x="silent", y="silent", z="silent")))
    later(60.0)
    said = re.search(r"COILS OFF was pressed at (\d\d:\d\d:\d\d); nobody has confirmed it", still.fault.coils.text())
    assert said is not None, still.fault.coils.text()
    assert said[1] != "00:00:00"
    zero = tuple(CoilReading(a, None, 0.0, True, None, module.time.monotonic()) for a in "xyz")
    app_state.take_lab(LabState(zero))
    assert app_state.off.pressed == ""


def test_a_supply_that_answers_in_time_alarms_nobody(qtbot, still, later):
    qtbot.keyClick(still, Qt.Key.Key_F12)
    still.app_state.off_worker.answer(SwitchOff, SwitchedOff(ends()))
    later(1.9)
    assert not still.fault.isVisible()
    later(20.0)
    assert not still.fault.isVisible()
    assert still.side.zero_words.text().startswith("◌ coils read back at zero")


def test_a_slow_ramp_is_waited_for(qtbot, still, later):
    cage = still.app_state.facts.cage
    coils = tuple(CoilReading(a, None, 1.5, False, None, time.monotonic()) for a in "xyz")
    still.app_state.take_lab(LabState(coils))
    qtbot.keyClick(still, Qt.Key.Key_F12)
    ramp_s = 1.5 / min(cage.ramp_A_per_s)
    later(ANSWERS_S + ramp_s - 0.3)
    assert not still.fault.isVisible()
    later(0.6)
    assert still.fault.isVisible()


def test_in_a_run_who_was_read_back_is_not_named(qtbot, still, later):
    app_state = still.app_state
    app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    told(still, (1.0, 1.0, 1.0))
    qtbot.keyClick(still, Qt.Key.Key_F12)
    later(0.1)
    told(still, (0.0, 0.0, 1.0), age_s=-0.1)
    later(3.5)
    assert still.fault.by_hand.text() == "Switch off by hand: supply_z"
    told(still, age_s=-3.6)
    assert not still.fault.isVisible()  # the reference agrees: it is over
    app_state.bench_worker.answer(RunProcedure, Ended("r1", "stopped", Fault("stopped", "stopped by the operator")))
    later(30.0)
    assert not still.fault.isVisible()


def test_the_supply_is_named_as_long_as_it_is_true_and_figures_are_a_click_deeper(qtbot, still, later):
    qtbot.keyClick(still, Qt.Key.Key_F12)
    later(2.5)
    raw = "tcp://127.0.0.1:9: no reply in 1.5 s, nothing came."
    still.app_state.off_worker.answer(SwitchOff, SwitchedOff(ends(z=raw)))
    card = still.fault
    assert card.by_hand.text() == "Switch off by hand: supply_z"
    assert card.by_hand.objectName() == "ask"
    assert card.coils.text().startswith("coils NOT confirmed at zero. COILS OFF was pressed at ")
    assert card.text.isHidden()
    assert raw in card.details.toPlainText()
    assert card.details.isHidden()
    still.app_state.fault.emit(Fault("instrument", "dut: silent"))  # what else goes wrong
    assert card.by_hand.isVisible()
    assert card.heading.text() == "✕ HANDS OFF: the coils may be on"
    later(60.0)
    assert card.by_hand.text() == "Switch off by hand: supply_z"
    still.app_state.watch.look()
    now = module.time.monotonic()
    three = tuple(
        InstrumentRead(f"supply_{a}", f"coil-{a}", "", "a supply", None, False, now, 0.0, True) for a in "xyz"
    )
    still.app_state.watch_worker.answer(ReadLab, three)
    assert card.isHidden()


def test_of_a_field_that_no_supply_owns_to_the_one_that_could_make_it_is_named(still, later):
    coils = tuple(CoilReading(a, None, 0.0, True, True, time.monotonic()) for a in "xyz")
    still.app_state.take_lab(LabState(coils, Witness("disagrees", DOUBT, advice=ADVICE)))
    assert still.app_state.by_hand() == ("supply_z",)
    still.app_state.take_lab(LabState(coils, Witness("disagrees", DOUBT)))
    assert still.app_state.by_hand() == ("supply_x", "supply_y", "supply_z")
