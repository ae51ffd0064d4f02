"""After a run that ended badly the lab is read on until it is at zero; one button reads all; both yield at once."""

import time
from dataclasses import replace

import pytest
from lab_states import told
from PySide6.QtCore import Qt

from labcal.bench.coils.state import CoilReading, Heard, LabState, PlatformReading, Witness, unread
from labcal.gui.ipc.answers import CoilEnd, Ended, SwitchedOff
from labcal.gui.ipc.lab_messages import InstrumentRead, ReadLab
from labcal.gui.ipc.messages import RunProcedure, SwitchOff
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels import lab_watch
from labcal.gui.viewmodels.lab_now import LOOK_S

SUPPLIES = ("supply_x", "supply_y", "supply_z")
LOST = Fault("instrument", "supply_z: the link was lost.", "Look at its cable.")


def read(still, **currents):
    """Answer what is asked: everybody is there, coils carry these currents (None: silent), 0 A else."""
    facts, now = still.app_state.facts, time.monotonic()
    (asked,) = still.app_state.watch_worker.commands(ReadLab)
    said = []
    for name, one in facts.instruments.items():
        if asked.names and name not in asked.names:
            continue
        coil = one.role[-1] if one.role.startswith("coil-") else ""
        current = currents.get(coil, 0.0) if coil else None
        silent = Fault("instrument", f"{name}: silent") if coil and current is None else None
        field = (2e4, 0.0, 4e4) if one.role == "reference" else None
        said.append(
            InstrumentRead(name, one.role, one.link, "" if silent else f"a {name}", silent, False, now, current,
                           current is not None and abs(current) < 0.005, field)
        )  # fmt: skip
    still.app_state.watch_worker.answer(ReadLab, tuple(said))
    stands = InstrumentRead("stage", "platform", "", "a stage", None, False, now, angle_deg=0.0, moving=False)
    while still.app_state.watch_worker.commands(ReadLab) == [ReadLab(asked.bench, ("stage",))]:
        still.app_state.watch_worker.answer(ReadLab, (stands,))
    return asked


def lost_in_a_run(still):
    """A run has ended over a supply, with a coil on; nobody could switch it off."""
    app_state = still.app_state
    app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    told(still, (0.0, 0.0, None))
    app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", LOST))
    ends = (*(CoilEnd(a, 0.0, "zero, open", True, time.monotonic()) for a in "xy"), CoilEnd("z", None, "silent", False))
    app_state.off_worker.answer(SwitchOff, SwitchedOff(ends))
    return app_state


def test_after_a_lost_run_the_lab_is_read_until_it_is_at_zero(still):
    app_state = lost_in_a_run(still)
    assert still.fault.isVisible()
    app_state.watch.look()
    assert read(still, z=None).names == SUPPLIES  # at one moment: what was read before the others is not fresh
    assert still.side.zero_words.text().startswith("✕ coils NOT confirmed at zero")
    app_state.watch.look()
    assert read(still).names == SUPPLIES[:2]  # they do not wait for the one that is silent
    assert read(still, z=1.1).names == SUPPLIES[2:]
    assert still.side.zero_words.text() == "● coils on: z +1.100 A"
    assert still.side.coils.values[2].text() == "+1.100"
    app_state.watch.look()
    assert read(still).names == SUPPLIES
    assert still.side.zero_words.text().startswith("■ coils read back at zero by their supplies")
    assert not still.fault.isVisible()
    app_state.watch.look()
    assert read(still).names == SUPPLIES  # nothing is wrong: it is looked at on, and the platform after them
    assert app_state.lab.state.now.platform_words.startswith("platform stands")
    assert next(light for name, light, _ in app_state.lab.state.now.lights if name == "supply_z") == "ok"


def test_a_plug_that_is_back_is_seen_and_a_platform_that_may_turn_is_looked_at(still, monkeypatch):
    app_state = still.app_state
    app_state.take_lab(
        LabState(unread(), instruments=(Heard("dut", None, "no samples"),), platform=PlatformReading(fault="silent"))
    )
    app_state.watch.look()
    now, asked = time.monotonic(), []
    dut = InstrumentRead("dut", "dut", "", "an RM3100", None, False, now)
    stage = InstrumentRead("stage", "platform", "", "a stage", None, False, now, angle_deg=41.0, moving=True)

    def answered():
        while commands := app_state.watch_worker.commands(ReadLab):
            asked.append(commands[0].names)
            said = tuple(one for one in (dut, stage) if one.name in commands[0].names)
            app_state.watch_worker.answer(ReadLab, said)

    answered()
    assert asked[0] == SUPPLIES
    assert sorted(asked[1:]) == [("dut",), ("stage",)]
    assert app_state.lab.state.now.platform_words == "platform turns, at 41°"
    asked.clear()
    monkeypatch.setattr(lab_watch.time, "monotonic", lambda: now + LOOK_S)
    app_state.watch.look()
    answered()
    assert asked == [SUPPLIES, ("stage",)]


@pytest.mark.parametrize("wants", ["F12", "a run"])
def test_whoever_wants_the_lines_has_them(qtbot, still, wants):
    app_state = lost_in_a_run(still)
    app_state.watch.look()
    assert app_state.watch_worker.commands(ReadLab)
    if wants == "F12":
        qtbot.keyClick(still, Qt.Key.Key_F12)
        assert app_state.watch_worker.killed == 1  # at once: its process lets go of every port
        assert app_state.off_worker.commands(SwitchOff)
    else:
        app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    before = app_state.known
    read(still, z=1.1)  # what comes too late
    assert app_state.known is before
    app_state.watch.look()
    assert app_state.watch_worker.commands(ReadLab) == []


def test_one_button_reads_all_and_says_who_answered(qtbot, still):
    bench = still.page("Bench")
    assert still.side.read_all.isEnabled()
    qtbot.mouseClick(still.side.read_all, Qt.MouseButton.LeftButton)
    assert not still.side.read_all.isEnabled()
    assert read(still, y=None).names == ()
    assert still.side.read_all.isEnabled()
    assert still.message.text() == "6 of 7 instruments were read: ✕ supply_y"
    assert still.side.field.values[1].text() != "–"
    assert bench.table.text(list(still.app_state.facts.instruments).index("dut"), 3).startswith("a dut")
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    still.app_state.grow_old()
    qtbot.mouseClick(still.side.read_all, Qt.MouseButton.LeftButton)  # the run reads them itself, and that is said
    assert still.message.text().startswith("A run goes on and reads the instruments itself; the DUT is read again in")
    assert still.app_state.watch_worker.commands(ReadLab) == []


def test_where_somebody_was_slow_while_a_person_had_all_read_it_is_looked_at_once_more(still, monkeypatch):
    """What the quick ones said is old by then."""
    app_state, begun = still.app_state, time.monotonic()
    app_state.watch.read_all()
    monkeypatch.setattr(lab_watch.time, "monotonic", lambda: begun + LOOK_S + 1.0)
    read(still)
    assert read(still).names == SUPPLIES


def test_what_another_process_has_stays_as_it_was_known(still):
    app_state = lost_in_a_run(still)
    app_state.watch.read_all()
    before = app_state.known.coils
    held = tuple(InstrumentRead(n, i.role, i.link, held=True) for n, i in app_state.facts.instruments.items())
    app_state.watch_worker.answer(ReadLab, held)
    assert app_state.known.coils == before
    assert "another process has supply_x, supply_y" in still.message.text()


def test_a_worker_that_broke_says_so_and_the_button_is_back(still):
    still.app_state.watch.read_all()
    still.app_state.watch_worker.asked[-1].failed(Fault("ended", "The work was killed (signal 9, SIGKILL)."))
    assert still.side.read_all.isEnabled()
    assert still.message.text() == "The work was killed (signal 9, SIGKILL)."


@pytest.mark.parametrize("over", ["finished", "stopped", "failed: aborted by the operator", "read all"])
def test_after_a_run_and_after_read_all_it_is_watched_until_somebody_wants_the_lines(still, over, qtbot):
    app_state, order = still.app_state, RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe")
    app_state.watch.look()
    assert app_state.watch_worker.commands(ReadLab) == [], "nobody has asked for anything here yet"
    if over == "read all":
        app_state.watch.read_all()
        read(still)
    else:
        app_state.run.start(order)
        told(still)
        app_state.bench_worker.answer(RunProcedure, Ended("r1", over))
    for _ in range(3):
        app_state.watch.look()
        assert read(still).names == SUPPLIES
        assert still.side.hands.text().startswith(("✓ Hands may go in", "● Hands may go in"))
    app_state.watch.look()
    app_state.off.order()
    assert app_state.watch_worker.killed == 1
    app_state.watch_worker.asked = []
    app_state.off_worker.answer(SwitchOff, SwitchedOff(tuple(CoilEnd(a, 0.0, "zero", True, time.monotonic())
                                                             for a in "xyz")))  # fmt: skip
    app_state.watch.look()
    assert read(still).names == SUPPLIES, "after COILS OFF they are looked at, at once and by themselves"
    assert read(still).names == SUPPLIES
    app_state.run.start(order)
    app_state.watch.look()
    assert app_state.watch_worker.commands(ReadLab) == []


def test_the_headline_after_coils_off_is_green_only_as_long_as_both_have_just_been_read(still, later):
    """Of a simulated lab supplies and platform are read on, and its reference is not: how old that is, is said."""
    app_state, live = still.app_state, still.page("Run").live
    app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    app_state.off.order()
    now = app_state.now_s()
    coils = tuple(CoilReading(axis, 0.0, 0.0, True, True, now) for axis in "xyz")
    app_state.bench_worker.states.emit(
        LabState(coils, Witness("agrees", "", read_s=now), platform=PlatformReading(223.0, False, now))
    )
    app_state.bench_worker.answer(RunProcedure, Ended("r1", "failed: aborted by the operator"))

    def said():
        live.draw()
        words = live.verdict.word.text().replace("\N{NO-BREAK SPACE}", " ")
        return words, live.verdict._state

    def read_again():
        coils = tuple(replace(one, read_s=app_state.now_s()) for one in app_state.known.coils)
        platform = PlatformReading(223.0, False, app_state.now_s())
        app_state.take_lab(replace(app_state.known, coils=coils, platform=platform))

    assert said() == ("✓ COILS OFF: coils at zero, platform stands", "good")
    later(2.5)
    read_again()
    assert said() == ("✓ COILS OFF: coils at zero, platform stands", "good")
    later(1.0)
    read_again()
    assert said() == ("■ COILS OFF: coils at zero, platform stands", "")
    later(31.5)
    read_again()
    assert said() == ("■ COILS OFF: coils at zero, platform stands", "")
    later(40.0)  # nobody reads the supplies either
    words, state = said()
    assert state == "warning"
    assert "(40 s ago)" in words
