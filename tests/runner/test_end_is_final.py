"""Once the end was ordered no current is set any more, and none stays, whatever a procedure catches or undoes first."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import closing, suppress
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest

from labcal.bench import Bench, open_bench
from labcal.bench.clock import VirtualClock
from labcal.bench.steps import Procedure, energise
from labcal.errors import InstrumentError
from labcal.record.stream import Item
from labcal.runner import Control, yes_to_all
from labcal.runner.drive import Drive

FULL_A = [0.8, 0.5, 0.3]
IN_TIME_S = 2.0


@pytest.fixture
def bench(bench_file: Callable[..., Path]) -> Iterator[Bench]:
    """The simulated lab, its time as fast as it can be."""
    with closing(open_bench(bench_file(), clock=VirtualClock(datetime(2026, 11, 21, tzinfo=UTC)), seed=2)) as bench:
        yield bench


def flowing_A(bench: Bench) -> float:
    """The most that any supply states; with its output open that is nothing."""
    return float(np.abs([supply.measure_current() for supply in bench.cage.supplies.values()]).max())


def waited(bench: Bench, s: float) -> None:
    for _ in bench.stream_until(bench.clock.now() + s):
        pass


def goes_on(bench: Bench, end: Callable[[], None], seen: list[tuple[float, float]]) -> Procedure:
    """Sets its currents again and again, whatever it is told; `seen`: seconds since the order and what flowed."""
    yield from energise(bench, bench.cage.field_nT() + [20_000.0, 0.0, 0.0], confirm_signs=False)
    end()
    begun = bench.clock.now()
    while bench.clock.now() < begun + 6.0:
        with suppress(Exception):
            bench.cage.set_currents(FULL_A, confirm_signs=False)
        with suppress(Exception):
            waited(bench, 0.2)
        seen.append((bench.clock.now() - begun, flowing_A(bench)))


@pytest.mark.parametrize("order", [Control.stop, Control.abort, Control.leave])
def test_a_procedure_that_catches_the_order_and_goes_on_is_without_current(
    bench: Bench, order: Callable[[Control], None]
) -> None:
    control, seen = Control(), list[tuple[float, float]]()
    drive = Drive(bench, list[Item]().append, yes_to_all(True), control)
    ending = drive.run(goes_on(bench, lambda: order(control), seen))
    assert ending.status != "finished"
    assert len(late := [current for since_s, current in seen if since_s > IN_TIME_S]) > 10
    assert max(late) < 0.005


def test_neither_is_there_any_where_the_record_is_not_kept(bench: Bench) -> None:
    lost, seen = list[InstrumentError](), list[tuple[float, float]]()

    def kept() -> None:
        if lost:
            raise lost[0]

    drive = Drive(bench, list[Item]().append, yes_to_all(True), kept=kept)
    drive.run(goes_on(bench, lambda: lost.append(InstrumentError("the disk is full.", fault="store")), seen))
    assert max(current for since_s, current in seen if since_s > IN_TIME_S) < 0.005


def test_what_a_procedure_undoes_is_not_broken_off_and_its_coils_do_not_wait_for_it(bench: Bench) -> None:
    control, seen, undone = Control(), list[float](), list[bool]()

    def procedure() -> Procedure:
        try:
            yield from energise(bench, bench.cage.field_nT() + [20_000.0, 0.0, 0.0], confirm_signs=False)
            control.stop()
            waited(bench, 1.0)
        finally:
            waited(bench, IN_TIME_S)
            seen.append(flowing_A(bench))
            waited(bench, 3.0)
            undone.append(True)

    ending = Drive(bench, list[Item]().append, yes_to_all(True), control).run(procedure())
    assert ending.status == "stopped"
    assert undone == [True]
    assert seen[0] < 0.005
    bench.cage.set_currents([0.1, 0.0, 0.0], confirm_signs=False)  # the next run may
