"""A supply that says zero while its coil carries on: the reference beside the DUT says otherwise, and is believed."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import closing, suppress
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from labcal.bench import Bench, open_bench
from labcal.bench.clock import VirtualClock
from labcal.bench.coils.agreement import BEFORE_HANDS, CHANGED, NO_AMBIENT
from labcal.bench.coils.doubt import Doubt, StoredDoubt
from labcal.bench.coils.state import AT_ZERO, BY_WORD, NOT_BY_REFERENCE
from labcal.bench.steps import coils_off, drive, measure_ambient, mount, record
from labcal.errors import InstrumentError
from labcal.record.stream import Event, Item, Prompt
from labcal.runner import Control, find, run_procedure, yes_to_all
from labcal.store import Store

EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"
PORTS = ["tcp://192.0.2.1:9221"]


class Lying:
    """A supply that acknowledges and reads back what it was told, while its coil carries what it carried before."""

    def __init__(self, supply: Any, coil: Any, clock: VirtualClock) -> None:
        self._supply, self._told, self._keeps = supply, 0.0, float(coil.current.now(clock.now()))
        coil.drive = lambda *_: False
        coil.current.set(clock.now(), self._keeps)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._supply, name)

    def set_current(self, current_A: float) -> None:
        self._told = current_A

    def set_point(self) -> float:
        return self._told

    def measure_current(self) -> float:
        return self._told

    def output(self, on: bool) -> None:
        """Yes."""


@pytest.fixture
def bench() -> Iterator[Bench]:
    with closing(opened()) as bench:
        yield bench


def opened(path: Path = EXAMPLE) -> Bench:
    return open_bench(path, clock=VirtualClock(datetime(2026, 1, 1, tzinfo=UTC)), seed=1)


def lab_of(bench: Bench) -> Any:
    assert bench.simulated_operator is not None
    return bench.simulated_operator._lab


def lies_from_now(bench: Bench, axis: str = "x") -> None:
    lying: Any = Lying(bench.cage.supplies[axis], lab_of(bench).coils[axis], bench.clock)  # type: ignore[arg-type]
    bench.cage.supplies = {**bench.cage.supplies, axis: lying}


def flows(bench: Bench) -> float:
    """The largest true current [A]."""
    now = np.array([bench.clock.now()])
    return max(float(abs(coil.at(now)[0])) for coil in lab_of(bench).coils.values())


def with_ambient(bench: Bench) -> None:
    """Streams, the ambient field measured, and a second of it recorded."""
    bench.start()
    list(measure_ambient(bench, 2.0))
    list(record(bench, 1.0))


@pytest.mark.parametrize("current_A", [-1.98, 0.9, 0.3, 0.06])
def test_a_current_that_stays_is_never_called_zero(bench: Bench, current_A: float) -> None:
    with_ambient(bench)
    assert bench.sentence() == AT_ZERO
    bench.cage.set_currents([current_A, 0.0, 0.0])
    lies_from_now(bench)
    with pytest.raises(InstrumentError, match=NOT_BY_REFERENCE) as caught:
        bench.cage.zero()
    assert caught.value.fault == "not zero"
    seems, told = caught.value.remedy.split(" A flowed in coil x: ")
    assert float(seems.removeprefix("It is as if ")) == pytest.approx(current_A, abs=0.01)
    supply = r"supply_x \(PL303QMT-P \d+ at emulated://\)"
    assert re.fullmatch(f"open the output of {supply} at its panel, or switch it off at its mains.", told)
    assert bench.sentence().endswith(told.rstrip("."))
    assert bench.sentence().startswith(f"{NOT_BY_REFERENCE}: it sees")
    apart_uT = float(caught.value.what.split("expected: ")[1].split()[0])
    assert apart_uT == pytest.approx(abs(current_A) * 49.95, abs=0.2)
    assert flows(bench) == pytest.approx(abs(current_A), abs=0.01)


def test_no_one_is_told_to_open_an_output_that_cannot_open(tmp_path: Path) -> None:
    before, _, after = EXAMPLE.read_text().replace('"tti-pl"', '"kepco-bop"').partition("[instruments.reversers]")
    path = tmp_path / "bench.toml"
    path.write_text(before + after[after.index("\n[") + 1 :])
    with closing(opened(path)) as bench:
        model, serial = (getattr(bench.identities()["supply_z"], what) for what in ("model", "serial"))
        with_ambient(bench)
        bench.cage.set_currents([0.0, 0.0, 0.5])
        lies_from_now(bench, "z")
        with pytest.raises(InstrumentError, match=NOT_BY_REFERENCE):
            bench.cage.zero()
        said = bench.sentence()
        assert said.endswith(f"A flowed in coil z: switch off supply_z ({model} {serial} at emulated://) at its mains "
                             "(no command opens its output)"), said  # fmt: skip
        assert "coil x" not in said
        doubt = bench.cage.latch.doubt
        assert doubt is not None
        assert f"supply_z ({model}" in doubt.error().remedy


def test_a_reference_at_full_scale_is_said_to_be(bench: Bench, monkeypatch: pytest.MonkeyPatch) -> None:
    with_ambient(bench)
    bench.cage.set_currents([0.5, 0.0, 0.0])
    lab = lab_of(bench)
    earth, truck = lab.ambient, replace(lab.ambient, earth_nT=np.array([0.0, 0.0, 400_000.0]))
    monkeypatch.setattr(lab, "ambient", truck)
    bench.cage.zero()
    assert bench.sentence() == f"{BY_WORD}: the reference is at its full scale and cannot vouch for it"
    assert [heard.fault for heard in bench.state().instruments if heard.name == "reference"] == ["overloaded"]
    for wait_s in [0.2] * 20 + [1e-4]:  # in the last one nothing comes
        with suppress(InstrumentError):
            bench.stream_until(bench.clock.now() + wait_s)
    assert bench.news() == []  # neither is silent: the one sends full scale, the other sends
    monkeypatch.setattr(lab, "ambient", earth)
    list(record(bench, 1.0))
    bench.cage.zero()
    assert bench.sentence() == AT_ZERO


def test_nothing_is_energised_until_both_agree_again(bench: Bench) -> None:
    with_ambient(bench)
    bench.cage.set_currents([1.0, 0.5, 0.0])
    honest, drives = bench.cage.supplies, lab_of(bench).coils["x"].drive
    lies_from_now(bench)
    for _ in range(2):
        with pytest.raises(InstrumentError, match=NOT_BY_REFERENCE):
            bench.cage.zero()
        with pytest.raises(InstrumentError, match="Nothing was set"):
            bench.cage.set_currents([0.1, 0.0, 0.0])
    bench.cage.supplies, lab_of(bench).coils["x"].drive = honest, drives
    honest["x"].output(False)  # a person opens it
    bench.clock.wait_until(bench.clock.now() + 1.0)
    bench.cage.zero()
    assert bench.sentence() == AT_ZERO
    bench.cage.set_currents([0.1, 0.0, 0.0])
    assert flows(bench) == pytest.approx(0.1, abs=0.01)


def test_a_coil_that_comes_on_by_itself_at_zero_ends_the_recording(bench: Bench) -> None:
    with_ambient(bench)
    lab_of(bench).coils["z"].current.set(bench.clock.now(), 0.5)  # a supply that restarted with its panel's values
    with pytest.raises(InstrumentError, match=NOT_BY_REFERENCE):
        bench.stream_until(bench.clock.now() + 10.0)


def test_a_hold_that_the_reference_does_not_see_ends_it(bench: Bench) -> None:
    with_ambient(bench)
    bench.cage.set_currents([0.2, 0.0, 0.3])
    lies_from_now(bench)
    bench.cage.set_currents([0.8, 0.0, 0.3])
    with pytest.raises(InstrumentError, match="the reference does not see that") as caught:
        bench.stream_until(bench.clock.now() + 10.0)
    assert caught.value.fault == "not seen"


def test_what_passes_is_looked_at_again(bench: Bench, monkeypatch: pytest.MonkeyPatch) -> None:
    with_ambient(bench)
    lab, reading = lab_of(bench), lab_of(bench).reference_nT
    begun = bench.clock.now()

    def lift(t_s: np.ndarray) -> Any:
        return reading(t_s) + np.where((t_s > begun) & (t_s < begun + 1.5), 5_000.0, 0.0)[:, None]

    monkeypatch.setattr(lab, "reference_nT", lift)
    bench.cage.set_currents([0.0, 0.0, 0.0])
    bench.cage.zero()
    assert bench.sentence() == AT_ZERO


@pytest.mark.parametrize("place", ["remote", "computed"])
def test_without_a_reference_at_the_dut_it_is_the_supplys_word(tmp_path: Path, place: str) -> None:
    path = tmp_path / "bench.toml"
    path.write_text(EXAMPLE.read_text().replace('place = "dut"', f'place = "{place}"'))
    with closing(opened(path)) as bench:
        with_ambient(bench)
        bench.cage.zero()
        assert bench.sentence() == f"{BY_WORD}: no vector reference stands at the DUT"


def test_an_ambient_field_older_than_the_mounting_is_no_witness_of_a_current(bench: Bench) -> None:
    assert bench.cage.witness.why == NO_AMBIENT
    with_ambient(bench)
    work = mount(bench, "mount-z", np.eye(3), "Mount.")
    asked = next(item for item in work if isinstance(item, Prompt) and item.key == "mount-z")
    assert bench.sentence() == AT_ZERO
    bench.handled(asked)
    assert bench.sentence() == f"{BY_WORD}: {BEFORE_HANDS}"  # not: none yet
    bench.cage.zero()
    assert bench.cage.witness.why == BEFORE_HANDS  # of a zero it says so, with what it is worth
    bench.clock.wait_until(bench.clock.now() + 0.1)
    bench.cage.set_currents([0.5, 0.0, 0.0])  # the sign behind the contacts is seen from zero: that is its ambient
    lies_from_now(bench)
    with pytest.raises(InstrumentError, match=NOT_BY_REFERENCE):
        bench.cage.zero()


def test_while_hands_mount_the_ambient_field_of_before_says_zero_and_nothing_of_a_current_that_flows(
    bench: Bench, monkeypatch: pytest.MonkeyPatch
) -> None:
    with_ambient(bench)
    work = mount(bench, "mount-z", np.eye(3), "Mount.")
    bench.handled(next(item for item in work if isinstance(item, Prompt) and item.key == "mount-z"))
    bench.clock.wait_until(bench.clock.now() + 1.0)
    list(record(bench, 1.0))
    assert bench.sentence() == AT_ZERO
    reading = lab_of(bench).reference_nT
    monkeypatch.setattr(lab_of(bench), "reference_nT", lambda t_s: reading(t_s) + 0.3 * 49_950.0)  # of 0.3 A
    list(record(bench, 1.0))
    assert bench.sentence() == f"{BY_WORD}: {CHANGED}"


def test_a_question_of_hands_off_leaves_the_witness(bench: Bench) -> None:
    with_ambient(bench)
    bench.handled(Prompt(0.0, "ready", "Hands off?", acts=True))
    bench.handled(Prompt(0.0, "mode-full", "Switch.", acts=True, drawing={"mode": "full"}))
    bench.cage.zero()
    assert bench.sentence() == AT_ZERO


def test_the_doubt_outlives_the_session_and_is_lifted_by_name(monkeypatch: pytest.MonkeyPatch) -> None:
    StoredDoubt(PORTS).set(Doubt("2026-01-01 00:00 UTC", "it sees 99", (99.0, 0.0, 0.0), (0.0, 0.0, 0.0)))
    later = StoredDoubt(PORTS)
    assert later.doubt is not None
    with pytest.raises(InstrumentError, match=r"it sees 99.* --clear-as NAME"):
        raise later.doubt.error()
    assert StoredDoubt(["tcp://192.0.2.2:9221"]).doubt is None
    later.lift("Ada, 0.1 µT")
    assert StoredDoubt(PORTS).doubt is None
    told = StoredDoubt(PORTS).take_lifted()
    assert told is not None
    assert told.lifted == "Ada, 0.1 µT"
    assert StoredDoubt(PORTS).take_lifted() is None


def test_a_doubt_that_cannot_be_read_is_a_doubt() -> None:
    latch = StoredDoubt(PORTS)
    latch.set(Doubt("now", "it sees 99"))
    for path in latch._paths:
        path.write_text("{")
    assert StoredDoubt(PORTS).doubt is not None


def test_a_run_over_a_false_zero_fails_and_says_so(tmp_path: Path) -> None:
    with closing(opened()) as bench, Store.open(tmp_path / "s.sqlite") as store:

        def tell(item: Item) -> None:
            if isinstance(item, Event) and item.kind == "set-point" and "lies" not in said:
                said.append("lies")
                lies_from_now(bench)

        said: list[str] = []
        found, answer = find("field-hold"), yes_to_all(True)
        given = {"duration_s": "20"}
        ended = run_procedure(
            bench, found, given, store=store, answer=answer, on_item=tell, run_id="R", control=Control()
        )
        assert flows(bench) > 0.1
        last = [item for item in store.items("R") if isinstance(item, Event)][-1]
    assert ended.status.startswith("failed")
    assert ended.status.count(NOT_BY_REFERENCE) == 1  # once is enough
    assert ended.at_rest.startswith(NOT_BY_REFERENCE)
    assert last.kind == "read-back"
    assert last.text.startswith(NOT_BY_REFERENCE)
    assert last.data["state"]["reference"]["verdict"] == "disagrees"


def test_a_zero_says_what_was_read(bench: Bench) -> None:
    with_ambient(bench)
    bench.clock.wait_until(bench.clock.now() + 5.0)
    assert bench.state().sentence(bench.clock.now()).startswith("coils confirmed at zero ")
    event = next(item for item in coils_off(bench) if isinstance(item, Event))
    assert event.text == AT_ZERO
    list(drive(bench, [0.2, 0.0, 0.0]))
    assert bench.sentence() == "coils on: x +0.2000 A"
    list(record(bench, 0.5))
