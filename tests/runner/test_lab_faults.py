"""Every named fault, provoked in the simulated lab while a field is held by feedback: what is said, and zero."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from left import left_as

from labcal.bench import Bench, open_bench
from labcal.bench.clock import VirtualClock
from labcal.bench.coils.state import AT_ZERO, BY_WORD, NOT_BY_REFERENCE, NOT_CONFIRMED
from labcal.errors import InstrumentError
from labcal.record.stream import Event, Item, Step
from labcal.runner import Outcome, find, run_procedure, yes_to_all
from labcal.store import Store

BenchFile = Callable[..., Path]
Break = Callable[[Bench, Any, pytest.MonkeyPatch], None]
HOLD = {"duration_s": "60"}
NO_WITNESS = ("silent", "overloaded", "stuck")  # a reference that fails confirms no zero


def silent(bench: Bench, lab: Any, patch: pytest.MonkeyPatch) -> None:
    emulator: Any = bench._links["reference"]._emulator
    patch.setattr(emulator, "emit", lambda until_s: [])


def overloaded(bench: Bench, lab: Any, patch: pytest.MonkeyPatch) -> None:
    patch.setattr(lab, "ambient", replace(lab.ambient, earth_nT=np.array([0.0, 0.0, 300_000.0])))


def stuck(bench: Bench, lab: Any, patch: pytest.MonkeyPatch) -> None:
    patch.setattr(lab, "reference_nT", lambda t_s: np.full((len(t_s), 3), [100, 20, 4400]))


def cannot_drive(bench: Bench, lab: Any, patch: pytest.MonkeyPatch) -> None:
    coil = lab.coils["z"]
    coil.current.set(bench.clock.now(), 0.8 * coil.current.now(bench.clock.now()))


def tripped(bench: Bench, lab: Any, patch: pytest.MonkeyPatch) -> None:
    lab.coils["z"].current.set(bench.clock.now(), 0.0)


def welded(bench: Bench, lab: Any, patch: pytest.MonkeyPatch) -> None:
    patch.setattr(lab.coils["x"], "reverse", lambda t_s, sign: None)


def too_warm(bench: Bench, lab: Any, patch: pytest.MonkeyPatch) -> None:
    reading = lab.dut_reading

    def warm(t_s: np.ndarray) -> Any:
        seen, channels = reading(t_s)
        return seen, channels | {"temp_dut": np.full_like(t_s, 61.0)}

    patch.setattr(lab, "dut_reading", warm)


def unplugged(bench: Bench, lab: Any, patch: pytest.MonkeyPatch) -> None:
    def lost(*_: object) -> None:
        raise InstrumentError("supply_z: the link was lost.", fault="link lost", remedy="Plug it in.")

    patch.setattr(bench._links["supply_z"], "send", lost)


def held_until(
    bench_file: BenchFile, patch: pytest.MonkeyPatch, broken: Break, step: str, **settings: str
) -> tuple[Outcome, Any, float]:
    """A field is held, and something breaks when `step` begins. The outcome, the true lab, and when it ended."""
    clock = VirtualClock(datetime(2026, 11, 21, tzinfo=UTC))
    with closing(open_bench(bench_file(), clock=clock, seed=2)) as bench, Store.open() as store:
        lab: Any = bench.simulated_operator._lab

        def tell(item: Item) -> None:
            if isinstance(item, Step) and item.name == step:
                broken(bench, lab, patch)

        found, answer = find("field-hold"), yes_to_all(True)
        outcome = run_procedure(bench, found, HOLD | settings, store=store, answer=answer, on_item=tell, run_id="R")
        return outcome, lab, clock.now()


@pytest.mark.parametrize(
    ("broken", "step", "fault", "says"),
    [
        (silent, "held", "silent", "no samples came from reference"),
        (overloaded, "held", "overloaded", "reference: a reading at full scale"),
        (stuck, "held", "stuck", "reference: the coils have moved the field by"),
        (cannot_drive, "held", "wrong mode", "coil z: .* A was set and .* A flows"),
        (tripped, "held", "tripped", "coil z: .* A was set and nothing flows"),
        (welded, "open loop", "polarity not confirmed", "coil x: after its contacts were set"),
        (too_warm, "held", "limit reached", "temp_dut is 61 degC, its limit is 60 degC"),
    ],
)
def test_a_fault_has_its_name_and_its_remedy_and_the_coils_are_at_zero(
    bench_file: BenchFile, monkeypatch: pytest.MonkeyPatch, broken: Break, step: str, fault: str, says: str
) -> None:
    outcome, lab, now = held_until(bench_file, monkeypatch, broken, step)
    assert isinstance(outcome.fault, InstrumentError), outcome.status
    assert outcome.fault.fault == fault
    with pytest.raises(InstrumentError, match=says):
        raise outcome.fault
    assert outcome.fault.remedy
    assert left_as(outcome).startswith(BY_WORD if fault in NO_WITNESS else AT_ZERO)
    assert max(abs(coil.at(np.array([now]))[0]) for coil in lab.coils.values()) < 0.005


def test_a_coil_that_comes_to_zero_without_its_ramp_is_an_event_in_the_record(
    bench_file: BenchFile, monkeypatch: pytest.MonkeyPatch
) -> None:
    def hiccup(bench: Bench, lab: Any, patch: pytest.MonkeyPatch) -> None:
        silent(bench, lab, patch)
        supply: Any = bench.cage.supplies["z"]
        write_current, once = supply.write_current, iter([InstrumentError("supply_z: no reply.", fault="silent")])

        def fails_once(current_A: float) -> None:
            if (fault := next(once, None)) is not None:
                raise fault
            write_current(current_A)

        patch.setattr(supply, "write_current", fails_once)

    held_until(bench_file, monkeypatch, hiccup, "held")
    with Store.open() as store:
        abrupt = [item for item in store.items("R") if isinstance(item, Event) and item.kind == "abrupt-zero"]
    assert [event.data["axis"] for event in abrupt] == ["z"]


def test_a_supply_whose_link_is_lost_is_named_and_its_coil_is_not_called_safe(
    bench_file: BenchFile, monkeypatch: pytest.MonkeyPatch
) -> None:
    outcome, lab, now = held_until(bench_file, monkeypatch, unplugged, "held")
    assert isinstance(outcome.fault, InstrumentError)
    assert outcome.fault.fault == "link lost"
    assert left_as(outcome).startswith(f"{NOT_CONFIRMED}; {NOT_BY_REFERENCE}")
    currents = {axis: abs(coil.at(np.array([now]))[0]) for axis, coil in lab.coils.items()}
    assert currents["z"] > 0.1
    assert max(currents["x"], currents["y"]) < 0.005
