"""The limits of DUT and windings bind whatever drives the bench: nothing is sent, switched or moved beyond them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from labcal import session
from labcal.bench import Bench, open_bench
from labcal.bench.clock import VirtualClock
from labcal.errors import InputError, InstrumentError, LimitError
from labcal.record.stream import Item, ModeChanged, Prompt
from labcal.runner import Outcome

EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"
OWN = """
from labcal.bench.steps import ModeChanged, Prompt, SegmentOpened, energise, rest, turn

def own(bench, *, what: str = ""):
    if what == "prompt":
        yield Prompt(bench.clock.now(), "m", "Boot into flight mode.", acts=True, drawing={"mode": "flight"})
    elif what == "said":
        yield ModeChanged(bench.clock.now(), "flight")
    elif what == "segment":
        yield from rest(bench, "s", 1.0, mode="flight")
    elif what == "rate":
        bench.platform.move_to(30.0, 20.5)
    elif what == "step":
        yield from turn(bench, 30.0, 20.5)
    elif what == "field":
        yield from energise(bench, (0.0, 0.0, 101_000.0))
    yield Prompt(bench.clock.now(), "too far", "This must not be asked.")
"""


def bench_file(tmp_path: Path, *changes: tuple[str, str]) -> Path:
    path, text = tmp_path / "bench.toml", EXAMPLE.read_text(encoding="utf-8")
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    path.write_text(text, encoding="utf-8")
    return path


@pytest.fixture
def bench(tmp_path: Path) -> Iterator[Bench]:
    coil = ('"temp_board"', '"temp_coil_x"'), ("field_nT = 120000.0", "field_nT = 120000.0\ntemperature_C = 70.0")
    clock = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
    with open_bench(bench_file(tmp_path, *coil), clock=clock, seed=1) as bench:
        bench.start()
        yield bench


def told(bench: Bench, monkeypatch: pytest.MonkeyPatch, **temperatures: float) -> None:
    """From now on the DUT tells these."""
    assert bench.simulated_operator is not None
    lab: Any = bench.simulated_operator._lab
    reading = lab.dut_reading

    def warmer(t_s: np.ndarray) -> Any:
        seen, channels = reading(t_s)
        return seen, channels | {name: np.full_like(t_s, value) for name, value in temperatures.items()}

    monkeypatch.setattr(lab, "dut_reading", warmer)


def ran(tmp_path: Path, what: str) -> tuple[Outcome, list[Item]]:
    procedure, items = tmp_path / "own.py", list[Item]()
    procedure.write_text(OWN)
    return session.run(str(procedure), bench_file(tmp_path), {"what": what}, seed=1, on_item=items.append), items


@pytest.mark.parametrize("what", ["prompt", "said", "segment"])
def test_no_procedure_brings_the_dut_into_a_mode_that_is_not_allowed(tmp_path: Path, what: str) -> None:
    outcome, items = ran(tmp_path, what)
    assert isinstance(outcome.fault, InputError)
    assert "'flight'" in outcome.status
    assert "nominal, full, safe" in outcome.status
    assert not [item for item in items if isinstance(item, Prompt | ModeChanged)]


@pytest.mark.parametrize(
    ("what", "both"), [("rate", r"20\.5 deg/s .* 20 deg/s"), ("step", r"20\.5 deg/s .* 20 deg/s"),
                       ("field", r"101000 nT .* the DUT, 100000 nT")],
)  # fmt: skip
def test_no_procedure_turns_faster_or_goes_higher_than_the_dut_bears(tmp_path: Path, what: str, both: str) -> None:
    outcome, items = ran(tmp_path, what)
    with pytest.raises((LimitError, InputError), match=both):
        outcome.raise_fault()
    assert not [item for item in items if isinstance(item, Prompt)]


@pytest.mark.parametrize(
    ("procedure", "given"),
    [("rotate-axis", {"mode": "flight"}), ("preflight", {"modes": "nominal,flight"})],
)
def test_a_mode_that_is_not_allowed_is_refused_before_anything_is_asked(
    tmp_path: Path, procedure: str, given: dict[str, str]
) -> None:
    with pytest.raises(InputError, match="power mode 'flight' is none of the DUT's"):
        session.run(procedure, bench_file(tmp_path), given, seed=1)
    assert session.runs() == []


@pytest.mark.parametrize(("name", "limit"), [("temp_dut", "60 degC"), ("temp_coil_x", "70 degC")])
def test_too_warm_ends_it_with_the_coils_at_zero(
    bench: Bench, monkeypatch: pytest.MonkeyPatch, name: str, limit: str
) -> None:
    told(bench, monkeypatch, temp_coil_x=69.0)
    bench.cage.set_currents([0.5, 0.0, 0.0])
    told(bench, monkeypatch, **{name: 75.5})
    with pytest.raises(InstrumentError, match=rf"{name} is 75\.5 degC, its limit is {limit}") as caught:
        bench.stream_until(bench.clock.now() + 5)
    assert caught.value.fault == "limit reached"
    with pytest.raises(InstrumentError, match="limit"):  # nor does it begin again
        bench.cage.set_currents([0.6, 0.0, 0.0])
    bench.cage.zero()
    assert abs(bench.cage.currents_A()).max() < 0.002


def test_the_windings_temperature_is_the_coils_channel(bench: Bench) -> None:
    assert {c.name: c.role for c in bench.channels}["temp_coil_x"] == "coil"


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ([('"temp_dut", "temp_board", ', "")], "dut.limits.temperature_C"),
        ([("field_nT = 120000.0", "field_nT = 120000.0\ntemperature_C = 70.0")], "cage.limits.temperature_C"),
    ],
)
def test_a_limit_that_nothing_tells_is_refused_when_the_bench_is_loaded(
    tmp_path: Path, changes: list[tuple[str, str]], says: str
) -> None:
    with pytest.raises(InputError, match=says) as caught:
        open_bench(bench_file(tmp_path, *changes))
    assert caught.value.line is not None


@pytest.mark.parametrize(
    ("stated", "says"),
    [
        ("zero_current_A = 100.0", r"at most 0\.625 A"),
        ("zero_current_A = -1.0", "zero is above 0 A"),
        ("zero_current_A = nan", "finite"),
        ("ramp_A_per_s = 0.0", "above 0 A/s"),
        ("max_current_A = inf", "finite"),
    ],
)
def test_no_supply_is_made_safe_by_words_alone(tmp_path: Path, stated: str, says: str) -> None:
    role = 'role = "coil-x"'
    path = bench_file(tmp_path, (role, f"{role}\nsettings = {{ {stated} }}"))
    x, *others = session.coils_off(path)
    assert re.search(rf"bench\.toml, line \d+: .*{says}", x.words)
    assert (x.current_A, x.opened) == (None, False)
    assert [end.words for end in others] == ["zero, open"] * 2


def test_a_field_beyond_the_limit_that_nobody_meant_is_seen_by_the_reference(
    bench: Bench, monkeypatch: pytest.MonkeyPatch
) -> None:
    bench.cage.set_currents([0.0, 0.0, 1.9])
    assert bench.simulated_operator is not None
    lab: Any = bench.simulated_operator._lab
    monkeypatch.setattr(lab, "ambient", replace(lab.ambient, earth_nT=np.array([20_400.0, 0.0, 20_000.0])))
    with pytest.raises(InstrumentError, match=r"is seen, the limit is 100000 nT") as caught:
        bench.stream_until(bench.clock.now() + 2)
    assert caught.value.fault == "limit reached"
    monkeypatch.undo()  # else the way out says, rightly, that no zero is seen
    bench.clock.wait_until(bench.clock.now() + 1.0)
