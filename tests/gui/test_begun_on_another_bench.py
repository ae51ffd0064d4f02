"""A run that broke off is gone on with on the bench it was begun on; that another one is open is said before."""

from dataclasses import replace

import pytest
from test_path import RUN

from labcal.gui.ipc.answers import Identified, InstrumentAnswer
from labcal.gui.ipc.messages import ListRuns
from labcal.gui.viewmodels.begun_on import another_bench
from labcal.gui.widgets.run_chooser import run_title
from labcal.record.bench_kind import REAL, SERVED, SIMULATED


@pytest.fixture
def broken(still):
    facts = still.app_state.facts
    still.app_state.set_identity(dut="EM-07", operator="J. Doe")
    yield replace(RUN, status="interrupted", bench=facts.name, simulated=facts.simulated)
    still.app_state.path.take_runs(())


def listed(window, *runs):
    window.open_page("Run")
    window.open_page("Start")
    window.page("Start").refresh()
    window.app_state.quick_worker.answer(ListRuns, runs)
    return window.page("Start").interrupted


def lines(card):
    return [where.text() for _, where, _ in card.listed if where.isVisible()]


def test_its_line_names_the_bench_that_it_was_begun_on(still, broken):
    card = listed(still, broken)
    [line] = lines(card)
    assert line.endswith(f"Begun on the bench {still.app_state.facts.name}.")
    assert still.next.text() == "Next: Go on with EM-07"
    assert lines(listed(still, replace(broken, bench=""))) == []  # a record that does not say it


def test_that_another_bench_is_open_is_said_before_go_on_and_next_does_not_go_on_there(still, broken):
    other = replace(broken, bench="cage of hall 2")
    card = listed(still, other)
    [line] = lines(card)
    said = (
        f"▲ Begun on the bench cage of hall 2; {still.app_state.facts.name} is open. Open cage of hall 2 first: "
        "with other instruments it does not go on."
    )
    assert line.endswith(said)
    assert card.listed[0][1].property("state") == "warning"
    assert card.go_on_buttons[0].objectName() != "primary"
    assert still.next.text() == "Next: Calibrate EM-07"
    still.open_page("Run")
    choose = still.page("Run").choose
    assert choose.which.text() == f"{run_title(other)}\n{said}"
    assert choose.which.property("state") == "warning"


def test_it_is_said_anew_when_another_bench_is_opened(still, broken):
    card = listed(still, broken)
    before, path = still.app_state.facts, still.app_state.bench
    still.app_state.bench_known(path, replace(before, name="cage of hall 3"))
    [line] = lines(card)
    still.app_state.bench_known(path, before)
    assert "; cage of hall 3 is open" in line
    assert "is open" not in lines(card)[0]


def test_an_instrument_that_says_it_is_another_is_the_reason_that_the_run_would_give(still, broken):
    card = listed(still, replace(broken, instruments=(("supply_x", "TTi PL303 0042"),)))
    heard = InstrumentAnswer("supply_x", "coil-x", "emulated://", "TTi PL303 0007")
    still.app_state.take_identified(Identified((heard,)))
    [line] = lines(card)
    assert line.endswith("supply_x was TTi PL303 0042 when run r1 began, now it is TTi PL303 0007")
    still.app_state.take_identified(Identified((replace(heard, identity="TTi PL303 0042"),)))
    assert "▲" not in lines(card)[0]


def test_a_real_bench_is_not_the_simulated_one_of_the_same_name(still, broken):
    facts = replace(still.app_state.facts, name="cage", simulated=True)
    said = another_bench(replace(broken, bench="cage", simulated=False), facts, {})
    assert said.startswith("▲ Begun on the bench cage (not simulated); cage (simulated) is open.")


@pytest.mark.parametrize(
    ("then", "now", "said"),
    [
        (SERVED, SIMULATED, "▲ Begun on the bench cage (served); cage (simulated) is open."),
        (SIMULATED, SERVED, "▲ Begun on the bench cage (simulated); cage (served) is open."),
        (SERVED, REAL, "▲ Begun on the bench cage (served); cage (not simulated) is open."),
        (SERVED, SERVED, ""),
        (SIMULATED, SIMULATED, ""),
    ],
)
def test_served_and_simulated_are_two_benches_though_they_have_one_name(still, broken, then, now, said):
    facts = replace(still.app_state.facts, name="cage", simulated=now != REAL, virtual_time=now == SIMULATED)
    run = replace(broken, bench="cage", simulated=then != REAL, bench_kind=then)
    found = another_bench(run, facts, {})
    assert found.startswith(said)
    assert bool(found) is bool(said)


def test_the_run_that_has_just_ended_says_it_as_well(still, broken):
    run, path = still.app_state.run, still.app_state.path
    listed(still, replace(broken, bench="cage of hall 2"))
    assert "cage of hall 2" in path.begun_elsewhere("r1")
    assert path.begun_elsewhere("r2") == ""
    from labcal.gui.viewmodels.run_verdict import run_verdict

    run.status = "interrupted"
    assert run_verdict(run, elsewhere=path.begun_elsewhere("r1")).rule.startswith("▲ Begun on the bench")
