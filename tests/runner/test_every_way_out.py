"""However a preflight ends, at whatever step: the coils are at zero, that was read back, and the status is true."""

from __future__ import annotations

import re
from collections.abc import Callable
from contextlib import closing
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from short_preflight import SHORT

from labcal.bench import Bench, open_bench
from labcal.bench.clock import VirtualClock
from labcal.bench.coils.state import AT_ZERO, BY_WORD, NOT_BY_REFERENCE, NOT_CONFIRMED
from labcal.bench.steps import Procedure, energise, record
from labcal.errors import InstrumentError
from labcal.record.endings import BY_ABORT
from labcal.record.stream import FAULT, Event, Item, Step
from labcal.runner import Control, Outcome, find, run_procedure, yes_to_all
from labcal.runner.drive import Drive
from labcal.store import Store

BenchFile = Callable[..., Path]
STEPS = ("zero", "axes-check", "sync-check", "mount-z", "z+20uT-nominal", "closure-z", "closing")


class Lab:
    """One short preflight to which something happens when the step `at` begins."""

    def __init__(self, bench: Bench, at: str, happens: Callable[[Lab], None]) -> None:
        self.bench, self.at, self.happens, self.control = bench, at, happens, Control()

    def run(self) -> tuple[Outcome, list[Item]]:
        with Store.open() as store:
            outcome = run_procedure(
                self.bench,
                find("preflight"),
                SHORT | {"zero_s": "3"},
                store=store,
                answer=yes_to_all(True),
                control=self.control,
                on_item=self.notice,
            )
            return outcome, list(store.items(outcome.run_id))

    def notice(self, item: Item) -> None:
        if isinstance(item, Step) and item.name == self.at:
            self.happens(self)

    def true_currents_A(self) -> list[float]:
        """What flows in the twin's coils, asked of the physics and not of any instrument."""
        twin: Any = self.bench.simulated_operator._lab
        return [float(coil.at([self.bench.clock.now()])[0]) for coil in twin.coils.values()]


def stop(lab: Lab) -> None:
    lab.control.stop()


def abort(lab: Lab) -> None:
    lab.control.abort()


def ctrl_c(lab: Lab) -> None:
    """In a script of one's own, where nobody turns it into a stop."""
    raise KeyboardInterrupt


def exception(lab: Lab) -> None:
    """A fault of the procedure's own, once the coils carry current."""
    listen, clock, begun = lab.bench.stream_until, lab.bench.clock, lab.bench.clock.now()

    def faulty(t_s: float) -> Any:
        if clock.now() > begun + 2.0:
            raise ZeroDivisionError("a fault in the procedure")
        return listen(t_s)

    lab.bench.stream_until = faulty


def unplug(name: str) -> Callable[[Lab], None]:
    def pull(lab: Lab) -> None:
        link: Any = lab.bench.instruments()[name]._link

        def gone(*_: Any, **__: Any) -> Any:
            raise InstrumentError(f"{name}: the link is gone.", fault="link lost", remedy="Check its plug.")

        link.send = link.receive = link.ask = gone

    pull.__name__ = f"unplugged-{name}"
    return pull


def failing_clean_up(lab: Lab) -> None:
    """Stopped, and the procedure's own undo fails the first time."""
    lab.control.stop()
    supply, failures = lab.bench.cage.supplies["x"], iter(range(2))
    measure_current = supply.measure_current

    def failing() -> float:
        if next(failures, None) is not None:
            raise InstrumentError("coil x: no answer.", fault="silent")
        return measure_current()

    supply.measure_current = failing


UNPLUGGED = "({0}: the link is gone|{0}: no sample for|no samples came from {0})"  # whichever is noticed first
LOST = "interrupted"  # by an instrument: the record says by which
ALWAYS = ("zero", "z+20uT-nominal", "closing")  # the other steps in the slow set
EVERYWHERE = [
    (stop, "stopped", ""),
    (exception, "failed: a fault in the procedure", ""),
    (unplug("reference"), LOST, UNPLUGGED.format("reference")),
    (failing_clean_up, LOST, "coil x: no answer"),
]
ONCE = [
    (abort, "failed: aborted by the operator", ""),
    (ctrl_c, "stopped", ""),
    (unplug("dut"), LOST, UNPLUGGED.format("dut")),
    (unplug("stage"), LOST, "stage: the link is gone"),
]


@pytest.mark.parametrize(("say", "on_the_way_out"), [(Control.stop, 0.3), (Control.abort, 0.0)])
def test_an_abort_zeroes_the_coils_before_the_procedure_undoes_anything_and_a_stop_after_it(
    bench_file: BenchFile, say: Callable[[Control], None], on_the_way_out: float
) -> None:
    seen, control = list[float](), Control()

    def procedure() -> Procedure:
        try:
            yield from energise(bench, bench.cage.field_nT() + [15_000.0, 0.0, 0.0], confirm_signs=False)
            say(control)
            yield from record(bench, 5.0)
        finally:
            seen.append(float(np.abs(bench.cage.currents_A()).max()))

    with closing(open_bench(bench_file(), clock=VirtualClock(datetime(2026, 11, 21, tzinfo=UTC)), seed=2)) as bench:
        told = list[Item]()
        ending = Drive(bench, told.append, yes_to_all(True), control).run(procedure())
        assert np.abs(bench.cage.currents_A()).max() < 0.002
    assert ending.status == ("stopped" if say is Control.stop else "failed: aborted by the operator")
    last = next(one for one in reversed(told) if isinstance(one, Event) and "stopped_by" in one.data)
    assert last.data["stopped_by"] == ("operator" if say is Control.stop else BY_ABORT)
    assert seen == [pytest.approx(on_the_way_out, abs=0.01)]


@pytest.mark.parametrize("say", [Control.stop, Control.abort, Control.leave])
def test_who_wants_the_end_does_not_wait_for_the_end_of_a_ramp(
    bench_file: BenchFile, say: Callable[[Control], None]
) -> None:
    told, control = list[float](), Control()

    def procedure() -> Procedure:
        yield from energise(bench, bench.cage.field_nT() + [90_000.0, 0.0, 0.0], confirm_signs=False)

    with closing(open_bench(bench_file(), clock=VirtualClock(datetime(2026, 11, 21, tzinfo=UTC)), seed=2)) as bench:
        supply: Any = bench.cage.supplies["x"]
        set_current = supply.set_current

        def listening(current_A: float) -> None:
            told.append(current_A)
            if len(told) == 4:
                say(control)
            set_current(current_A)

        supply.set_current = listening
        drive = Drive(bench, list[Item]().append, yes_to_all(True), control)
        assert drive.run(procedure()).fault is not None
        assert np.abs(bench.cage.currents_A()).max() < 0.002
    assert max(told) == told[3] < 0.8  # of the 1.8 A that were wanted


def test_a_supply_that_cannot_be_asked_is_said_to_be_unconfirmed_and_the_other_coils_are_at_zero(
    bench_file: BenchFile,
) -> None:
    with closing(open_bench(bench_file(), clock=VirtualClock(datetime(2026, 11, 21, tzinfo=UTC)), seed=2)) as bench:
        lab = Lab(bench, "closing", unplug("supply_x"))
        outcome, items = lab.run()
        assert outcome.status == LOST
        assert "supply_x: the link is gone" in outcome.ending
        assert outcome.at_rest.startswith(NOT_CONFIRMED)
        assert max(map(abs, lab.true_currents_A()[1:])) < 1e-3
    last = items[-1]
    assert isinstance(last, Event)
    assert last.kind == "read-back"
    assert last.text.startswith(f"{NOT_CONFIRMED}; {NOT_BY_REFERENCE}: it sees")  # that coil is on, and is seen
    assert last.data["current_A"][0] is None
    assert max(map(abs, last.data["current_A"][1:])) < 0.002


@pytest.mark.parametrize(
    ("at", "happens", "status", "fault"),
    [pytest.param(at, *case, marks=() if at in ALWAYS else pytest.mark.slow) for at in STEPS for case in EVERYWHERE]
    + [("z+20uT-nominal", *case) for case in ONCE],
    ids=lambda value: value.__name__ if callable(value) else "",
)
def test_the_coils_are_at_zero_and_that_is_recorded(
    bench_file: BenchFile, at: str, happens: Callable[[Lab], None], status: str, fault: str
) -> None:
    with closing(open_bench(bench_file(), clock=VirtualClock(datetime(2026, 11, 21, tzinfo=UTC)), seed=2)) as bench:
        lab = Lab(bench, at, happens)
        outcome, items = lab.run()
        assert outcome.status == status
        assert outcome.resumable == (status == LOST)
        said = [i.text for i in items if isinstance(i, Event) and i.kind == FAULT]
        assert len(said) == bool(fault)
        assert re.match(fault, "".join(said))
        assert max(map(abs, lab.true_currents_A())) < 1e-3
    last = items[-1]
    assert isinstance(last, Event)
    no_witness = at == STEPS[0] or happens.__name__ == "unplugged-reference"
    assert last.kind == "read-back"
    assert last.text == AT_ZERO or (no_witness and last.text.startswith(BY_WORD))
    assert max(map(abs, last.data["current_A"])) < 0.002
    assert [i.name for i in items if isinstance(i, Step)][-1] == at
