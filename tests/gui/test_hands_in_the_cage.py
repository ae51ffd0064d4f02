"""What a technician is told whose hands are in the cage: true at each moment, said once, and what is to be done."""

from dataclasses import replace

import numpy as np
import pytest
from lab_states import told

from labcal.bench.coils.agreement import BEFORE_HANDS, NO_AMBIENT
from labcal.bench.coils.state import AT_ZERO, CoilReading, Heard, LabState, PlatformReading, Witness
from labcal.bench.mounting import how_to_mount
from labcal.errors import InstrumentError
from labcal.gui.ipc.answers import CoilEnd, Ended, SwitchedOff
from labcal.gui.ipc.lab_messages import InstrumentRead, ReadLab
from labcal.gui.ipc.messages import Identify, ResumeRun, RunProcedure, SwitchOff
from labcal.gui.ipc.wire import Fault, fault_of
from labcal.gui.viewmodels import app_state as window_clock
from labcal.gui.viewmodels.known_lab import AMBIENT_S, ANSWERS_S, LOST_FIRST_S, KnownLab
from labcal.gui.viewmodels.lab_now import WATCHED_S
from labcal.record import Segment
from labcal.record.stream import Event, Prompt, SegmentOpened, Step

STEPS = ("zero", "mount-z", "z+20uT", "closing")
MOUNT = Prompt(2.0, "mount-z", "Mount it.", ("done",), True, {"body_from_cage": np.eye(3).tolist()})
READY = Prompt(3.0, "ready", "The coils go to 20 µT. Hands off?", ("done", "redo x"), True)
LOST = Fault("instrument", "supply_z: the link was lost.", "Look at its cable.")
AMBIENT = (20_400.0, 1_150.0, -43_700.0)
ADVICE = "It is as if +1.52 A flowed in coil z: open the output of supply_z at its panel"


@pytest.fixture
def running(still):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    send(still, Step(0.0, 1, 4, "zero", 60.0, STEPS, 20.0))
    return still


@pytest.fixture
def real(still):
    """The same bench on lines of its own."""
    still.app_state.facts = replace(still.app_state.facts, virtual_time=False)
    return still


def now_s():
    """By the window's clock, which `later` puts forward."""
    return window_clock.time.monotonic()


def send(window, *items):
    window.app_state.bench_worker.items.emit(items)


def lab(currents=(0.0, 0.0, 0.0), platform=None, faulty=(), witness=None):
    """Just read, by the window's clock; a current of None was not, as the supply is lost."""
    now = now_s()
    coils = (
        CoilReading(a, None, i, i is not None and not i, None, now, "the link was lost" if i is None else "")
        for a, i in zip("xyz", currents, strict=True)
    )
    heard = tuple(Heard(name, now, "silent") for name in faulty)
    return LabState(tuple(coils), witness or Witness(), None, heard, platform=platform)


def says(window, *args, **more):
    window.app_state.bench_worker.states.emit(lab(*args, **more))


def headline(window):
    live = window.page("Run").live
    live.draw()
    return live.headline.text()


def stands(moving=False, age_s=0.0):
    return PlatformReading(40.0, moving, now_s() - age_s)


def test_between_two_questions_nobody_is_called_away_before_anything_moves(running):
    run = running.app_state.run
    says(running, platform=stands())
    send(running, MOUNT)
    run.answer("done")
    assert (headline(running), run.message) == ("offset and first position", "It goes on.")
    says(running, platform=stands(moving=True))
    assert headline(running).startswith("Hands off")
    says(running, (0.0, 0.0, 0.5), platform=stands())
    assert headline(running).startswith("Hands off")
    says(running, platform=stands(age_s=5.0))
    assert headline(running).startswith("Hands off")  # nobody knows whether it stands


def test_who_has_said_hands_off_keeps_them_off_until_the_next_question(running):
    run = running.app_state.run
    says(running, platform=stands())
    send(running, READY)
    run.answer("done")
    assert (headline(running)[:9], run.message) == ("Hands off", "Hands off: it goes on.")
    send(running, Event(4.0, "answer", "done", {"key": "mount-z"}))  # as a window that came back hears it
    assert headline(running) == "offset and first position"
    send(running, READY)
    run.answer("redo x")
    assert headline(running) == "offset and first position"
    send(running, SegmentOpened(5.0, Segment("zero", "zero")))
    assert headline(running).startswith("Hands off")  # it is being measured


def test_what_the_headline_said_before_a_question_does_not_come_back_after_it(running):
    says(running, (0.0, 0.0, 0.5), platform=stands(moving=True))
    assert headline(running).startswith("Hands off")
    send(running, MOUNT)
    says(running, platform=stands())
    running.app_state.run.answer("done")
    assert running.page("Run").live.headline.text() == "offset and first position"  # no frame was drawn yet


def test_the_time_that_is_left_is_not_promised_of_a_step_that_begins_with_a_question(running):
    send(running, READY)
    running.app_state.run.answer("done")
    send(running, Step(9.0, 2, 4, "mount-z", 60.0, STEPS, 15.0, 0.0, "mount-z"))
    says(running, platform=stands())
    assert headline(running) == "Hands off · body Z up"


def test_nothing_is_promised_while_somebody_is_lost(running):
    live = running.page("Run").live
    running.app_state.run.virtual_time = False
    says(running)
    headline(running)
    assert live.time_left.until.text().startswith("Done at")
    says(running, faulty=("dut",))
    headline(running)
    assert live.time_left.until.text() == ""


def test_one_supply_that_is_lost_is_named_alone_while_the_others_are_on_their_way_to_zero(running, later):
    says(running, (0.35, 0.02, None))
    running.app_state.off.order()
    assert running.app_state.by_hand() == ("supply_z",)
    later(ANSWERS_S + 1.0)
    assert running.fault.by_hand.text() == "Switch off by hand: supply_z"
    assert "common line" not in running.side.legend.text() + running.fault.coils.text()
    later(LOST_FIRST_S)
    assert running.app_state.by_hand() == ("supply_x", "supply_y", "supply_z")  # they have not answered at all


def test_what_a_run_read_back_at_zero_before_it_ended_is_not_to_be_switched_off_by_hand(running, later):
    says(running, (0.0, 0.0, None))
    running.app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", LOST))
    assert "supply_x" not in running.page("Run").live.fault.coils.text()
    later(ANSWERS_S + 1.0 + LOST_FIRST_S)
    assert running.fault.by_hand.text() == "COILS OFF (F12), then switch off by hand: supply_z"


def test_but_what_a_run_that_broke_off_read_may_be_on_since(running, later):
    says(running, (0.0, 0.0, None))
    later(0.1)
    running.app_state.bench_worker.asked[-1].failed(Fault("crash", "It broke."))
    later(ANSWERS_S + 1.0 + LOST_FIRST_S)
    assert running.fault.by_hand.text() == "COILS OFF (F12), then switch off by hand: supply_x, supply_y, supply_z"


def test_a_doubt_that_names_its_supply_sends_nobody_to_the_others(still):
    still.app_state.off.order()
    still.app_state.off_worker.answer(SwitchOff, SwitchedOff(zeros(), "it sees 20 000 nT, 0 nT expected", ADVICE))
    assert still.fault.by_hand.text() == "Switch off by hand: supply_z"


def test_a_run_that_has_its_coils_at_zero_is_left_to_stop_the_platform_and_to_ask_the_reference(running):
    worker = running.app_state.bench_worker
    says(running, (0.0, 0.0, 1.0), platform=stands(moving=True))
    running.app_state.off.order()
    running.app_state.off.force_timer.timeout.emit()
    assert worker.killed == 1  # it did not get there
    worker.killed = 0
    says(running, platform=stands(moving=True))
    running.app_state.off.force_timer.timeout.emit()
    assert (worker.killed, running.app_state.off.force_timer.isActive()) == (0, True)


def switched_off_after(window, witness):
    """A run held by a reference that agreed is ended by force; another worker has taken the coils to zero."""
    says(window, witness=witness)
    window.app_state.bench_worker.asked[-1].failed(Fault("ended", "The work was ended by this window."))
    window.app_state.off_worker.answer(SwitchOff, SwitchedOff(zeros()))


def zeros():
    return tuple(CoilEnd(a, 0.0, "zero, open", True, now_s()) for a in "xyz")


def read(window, field_nT):
    """Answer whoever is read in this round, one question after another: who that was."""
    facts, now, names, worker = window.app_state.facts, now_s(), [], window.app_state.watch_worker
    while asked := worker.commands(ReadLab):
        said = []
        for name in asked[0].names:
            one = facts.instruments[name]
            coil, field = one.role.startswith("coil-"), field_nT if one.role == "reference" else None
            fault = Fault("instrument", f"{name}: silent") if one.role == "reference" and field is None else None
            read = name, one.role, one.link, "it", fault, False, now, 0.0 if coil else None, coil, field
            said.append(InstrumentRead(*read))
        worker.answer(ReadLab, tuple(said))
        names += asked[0].names
    return names


@pytest.mark.parametrize(
    ("sees", "words"),
    [
        (AMBIENT, f"✓ {AT_ZERO}"),
        ((20_400.0, 1_150.0, 30_000.0), "✕ NOT at zero by the reference"),
        (None, "■ coils read back at zero by their supplies; the reference does not answer"),
    ],
)
def test_after_coils_off_in_a_run_the_reference_is_asked_again(real, running, sees, words):
    switched_off_after(running, Witness("agrees", "", AMBIENT, AMBIENT, 0.0, 2e3, now_s()))
    names = read(running, sees)
    assert {"reference", "stage", "supply_x", "supply_y", "supply_z"} <= set(names)
    assert running.side.zero_words.text().startswith(words)


def test_with_coils_on_the_ambient_field_is_what_the_reference_saw_less_the_coils(real, running):
    matrix, on = np.array(running.app_state.facts.cage.matrix), (0.0, 0.0, 1.0)
    seen = tuple((matrix @ on + AMBIENT).tolist())
    says(running, on, witness=Witness("agrees", "", seen, seen, 0.0, 7e3, now_s()))
    running.app_state.bench_worker.asked[-1].failed(Fault("ended", "The work was ended by this window."))
    running.app_state.off_worker.answer(SwitchOff, SwitchedOff(zeros()))
    read(running, AMBIENT)
    assert running.side.zero_words.text() == f"✓ {AT_ZERO}"


@pytest.mark.parametrize("why", [NO_AMBIENT, BEFORE_HANDS])
def test_the_ambient_field_of_before_a_mounting_or_of_long_ago_judges_nothing(still, why):
    kept, facts = KnownLab(), still.app_state.facts
    kept.take(lab(witness=Witness("agrees", "", AMBIENT, AMBIENT, 0.0, 2e3, 10.0)), 10.0)
    assert kept.ambient_nT(facts, 11.0) is not None
    assert kept.ambient_nT(facts, 11.0 + AMBIENT_S) is None
    kept.take(lab(witness=Witness(why=why)), 12.0)
    assert kept.ambient_nT(facts, 12.0) is None


def test_a_doubt_that_is_older_than_the_zero_of_the_supplies_has_the_reference_look_once_more(real):
    real.app_state.off.order()
    ends = (*zeros()[:2], CoilEnd("z", None, "lost", False))
    real.app_state.off_worker.answer(SwitchOff, SwitchedOff(ends, "it sees 20 000 nT, 0 nT expected", ADVICE))
    assert not real.app_state.off_worker.commands(Identify)
    real.app_state.watch.look()
    read(real, AMBIENT)
    assert len(real.app_state.off_worker.commands(Identify)) == 1


def test_under_a_card_that_says_the_coils_may_be_on_there_is_no_second_headline(running):
    says(running, (0.0, 0.0, 1.0), faulty=("dut",))
    assert headline(running).startswith("✕ HANDS OFF")
    running.app_state.off.warn(Fault("coils", "z: lost"))
    assert running.fault.isVisible()
    assert headline(running) == ""


@pytest.mark.parametrize(
    ("platform", "said", "large"),
    [
        (
            stands(moving=True, age_s=12.0),
            "✕ platform NOT confirmed at a standstill: at 40° it turned, 12 s ago: COILS OFF was pressed, ",
            True,
        ),
        (PlatformReading(fault="silent"), "✕ platform NOT confirmed at a standstill: stop it at its controller", True),
        (None, "✕ platform NOT confirmed at a standstill: stop it at its controller", True),
        (stands(), "✓ platform stands at 40°", False),
    ],
)
def test_a_red_card_after_coils_off_says_how_the_platform_is(still, platform, said, large):
    if platform is not None and platform.read_s is not None:  # those above were made when this file was read
        platform = replace(platform, read_s=now_s() - (12.0 if platform.moving else 0.0))
    still.app_state.take_lab(lab((0.0, 0.0, None), platform=platform))
    still.app_state.off.order()
    still.app_state.off_worker.answer(SwitchOff, SwitchedOff((*zeros()[:2], CoilEnd("z", None, "lost", False))))
    card = still.fault
    assert (card.turning if large else card.platform).text().startswith(said)
    assert (card.turning.isVisible(), card.platform.isVisible()) == (large, not large)


def test_so_does_the_card_of_a_run_that_coils_off_has_ended(running):
    says(running, platform=stands())
    running.app_state.off.order()
    running.app_state.bench_worker.asked[-1].failed(Fault("ended", "The work was ended by this window."))
    assert running.page("Run").live.fault.platform.text().startswith("✓ platform stands at 40°")


def test_what_ends_a_process_is_for_who_mends_labcal_alone(still):
    error = InstrumentError("supply_z does not answer.", remedy="Look at its cable.", mends="To end it: kill 11712.")
    assert "kill 11712" in str(error)  # whoever is at a terminal reads it
    fault = fault_of(error)
    still.app_state.fault.emit(fault)
    card = still.fault
    assert "kill" not in card.text.text() + card.remedy.text()
    assert card.details.toPlainText().startswith(
        "For who mends labcal; a problem report holds it:\n\nTo end it: kill 11712."
    )
    assert (card.fold.isVisible(), card.details.isVisible()) == (True, False)


def test_a_run_that_does_not_go_on_says_why_where_it_ended_though_the_coils_have_the_card(running):
    app_state, live = running.app_state, running.page("Run").live
    says(running, (0.0, 0.0, None))
    app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", LOST))
    app_state.off_worker.answer(SwitchOff, SwitchedOff((*zeros()[:2], CoilEnd("z", None, "lost", False))))
    app_state.path.resumable = frozenset({"preflight"})
    app_state.resume("r1", "preflight", "EM-07")  # as it answered, just before
    text = "supply_z (tcp://10.0.0.7:5025): the link was lost (Connection refused)."
    still_off = Fault("instrument", text, "It is tried again and again.")
    next(one for one in app_state.bench_worker.asked if isinstance(one.command, ResumeRun)).failed(still_off)
    assert running.fault.isVisible()
    assert not live.fault.isVisible()
    assert live.verdict.reason.text() == "supply_z: the link was lost."
    assert live.verdict.reason.isVisibleTo(live)
    running.fault.show_fault(None)
    app_state.grow_old()
    told(running)


@pytest.mark.parametrize("key", ["failed-z+20uT", "ready"])
def test_who_is_sent_to_a_plug_is_told_whether_hands_may_go_in(running, key):
    card = running.page("Run").live.prompt
    lost = {"no_answer": "reference", "what": "reference: the link was lost.", "remedy": "Plug it in."}
    words = "z+20uT: lost" if key != "ready" else "Still lost: reference (silent). Put that right first."
    send(running, Prompt(3.0, key, words, ("stop", "retry"), drawing=lost if key != "ready" else {}))
    says(running, platform=stands(), faulty=("reference",))
    assert card.hands.text().startswith("● Hands may go in: coils read back at zero by their supplies; ")
    assert not card.lab.isVisibleTo(card), "the same, said once"
    assert card.stands.text() == "✓ platform stands at 40°"
    says(running, (0.0, 0.0, None), platform=stands(), faulty=("supply_z",))
    assert card.hands.text() == "✕ Hands off: coils NOT confirmed at zero"
    says(running, platform=PlatformReading(fault="link lost"), faulty=("stage",))
    assert card.hands.text() == "✕ Hands off: platform NOT confirmed at a standstill"
    says(running, platform=stands(age_s=WATCHED_S + 2.0), faulty=("stage",))
    assert card.hands.text() == "✕ Hands off: platform NOT confirmed at a standstill"
    assert card.hands.isVisibleTo(card)


def test_nobody_is_sent_to_a_plug_that_is_in_again(running):
    card = running.page("Run").live.prompt
    drawing = {"no_answer": "dut", "what": "dut: the link was lost.", "remedy": "Plug it in."}
    send(running, Prompt(3.0, "failed-z+20uT", "z+20uT: lost", ("stop", "retry"), drawing=drawing))
    says(running, faulty=("dut",))
    assert "Plug it in." in card.details.text()
    says(running)
    assert (card.text.text(), card.details.text()) == (
        "Every instrument answers again.",
        "Then “Hands off: try again”.",
    )
    says(running, faulty=("dut",))
    assert "Plug it in." in card.details.text()


def test_who_answers_stop_is_not_told_that_it_goes_on(running):
    send(running, Prompt(3.0, "failed-z+20uT", "z+20uT: lost", ("stop", "retry")))
    running.app_state.run.answer("stop")
    assert running.app_state.run.message == "Stopping …"


def test_so_is_who_is_asked_for_hands_off_while_somebody_is_lost(running):
    card = running.page("Run").live.prompt
    send(running, READY)
    says(running, platform=stands())
    assert card.hands.isHidden()
    says(running, platform=stands(), faulty=("dut",))
    assert (card.hands.text()[1:17], card.hands.isVisibleTo(card)) == (" Hands may go in", True)
    says(running, platform=stands())
    assert card.hands.isHidden()


def test_in_the_midst_of_a_turn_there_is_no_next_and_the_line_keeps_its_height(running):
    running.open_page("Run")
    height = running.bottom.sizeHint().height()
    assert not running.next.isVisible()
    send(running, READY)
    assert (running.next.isVisible(), running.next.text()) == (True, "Next: Answer the question")
    assert running.bottom.sizeHint().height() == height
    running.app_state.run.answer("done")
    assert not running.next.isVisible()
    running.open_page("Start")
    assert (running.next.isVisible(), running.next.text()) == (True, "Next: See the run")


def test_in_a_small_window_whether_hands_may_go_in_is_said_whole_beside_what_to_mount(running, qtbot):
    running.open_page("Run")
    running.resize(1024, 700)
    card, at_zero = running.page("Run").live.prompt, {"platform": stands(), "witness": Witness("", BEFORE_HANDS)}
    for axis, answers in (("x", ("done",)), ("z", ("done", "redo x"))):
        send(running, replace(MOUNT, text=how_to_mount(axis), choices=answers))
        says(running, **at_zero)
        qtbot.waitUntil(lambda: card.alive and card.drawing.isVisible())
        qtbot.wait(100)  # laid out by then
        assert card.hands.text().endswith(f"{BEFORE_HANDS} · read 1 s ago")
        for words in (card.hands, card.text):
            assert words.height() >= words.heightForWidth(words.width())
