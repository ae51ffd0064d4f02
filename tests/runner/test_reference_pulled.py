"""A reference that is pulled, or falls silent, while a field is held: named, and the coils at zero 2 s later."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from labcal.bench import open_bench
from labcal.bench.clock import LOOK_S, VirtualClock
from labcal.bench.streams.watch import NOTICED_S
from labcal.errors import InstrumentError
from labcal.record.stream import Item, Step
from labcal.runner import find, run_procedure, yes_to_all
from labcal.store import Store

HMR2300 = 'driver = "hmr2300"\nlink = "emulated://"\nrole = "reference"\nsettings = { rate = 20 }'
VOLTS = {"uT_per_V": "[10.0, 10.0, 10.0]"}
STATED: dict[str, dict[str, str]] = {
    "alphalab": {}, "daq-inputs": VOLTS, "hmr2300": {"rate": "20"}, "labjack-t7": VOLTS,
    "lemi-025": {}, "metrolab": {}, "rm3100": {}, "text-line": {}, "twinleaf": {},
}  # fmt: skip
ZERO_A, ZERO_S = 0.005, 2.0


class Attentive(VirtualClock):
    """Simulated time in which streams are listened to as often as in true time."""

    listen_s = LOOK_S


def held_and_then(
    happens: Callable[[Any], None], path: Path, seen: list[float], of: str = "reference"
) -> tuple[BaseException | None, dict[str, Any], float]:
    """A field is held, `happens` is done to the link of the instrument `of` and its time noted: fault, coils, end."""
    clock = Attentive(datetime(2026, 11, 21, tzinfo=UTC))
    with closing(open_bench(path, clock=clock, seed=2)) as bench, Store.open() as store:
        lab: Any = bench.simulated_operator._lab

        def tell(item: Item) -> None:
            if isinstance(item, Step) and item.name == "held" and not seen:
                seen.append(clock.now())
                happens(bench._links[of])

        outcome = run_procedure(
            bench,
            find("field-hold"),
            {"duration_s": "60"},
            store=store,
            answer=yes_to_all(True),
            on_item=tell,
            run_id="R",
        )
        return outcome.fault, dict(lab.coils), clock.now()


def at_zero_s(coils: dict[str, Any], since_s: float, until_s: float) -> float:
    """How long after `since_s` the last coil was at zero for good."""
    assert max(abs(coil.at(np.array([since_s]))[0]) for coil in coils.values()) > 0.1
    times = np.arange(since_s, until_s, 0.01)
    flows = [times[np.abs(coil.at(times)) > ZERO_A].max(initial=since_s) for coil in coils.values()]
    assert all(abs(coil.at(np.array([until_s]))[0]) < ZERO_A for coil in coils.values())
    return float(max(flows)) - since_s


def pulled(monkeypatch: pytest.MonkeyPatch) -> Callable[[Any], None]:
    """The computer says that the line is gone."""

    def lost(*_: object) -> None:
        raise InstrumentError("reference: the link was lost.", fault="link lost", remedy="Plug it in.")

    def happens(link: Any) -> None:
        for call in ("send", "receive", "reopen"):
            monkeypatch.setattr(link, call, lost)

    return happens


def silenced(monkeypatch: pytest.MonkeyPatch) -> Callable[[Any], None]:
    """The line is there, and nothing comes on it any more."""

    def happens(link: Any) -> None:
        def nothing(until_s: float) -> list[tuple[float, bytes]]:
            link._clock.wait_until(until_s)
            return []

        monkeypatch.setattr(link, "receive", nothing)

    return happens


def reference(name: str, stated: dict[str, str]) -> tuple[str, str]:
    """What stands in the example in place of its reference."""
    settings = ", ".join(f"{key} = {value}" for key, value in stated.items())
    entry = f'driver = "{name}"\nlink = "emulated://"\nrole = "reference"\nsettings = {{ {settings} }}'
    return HMR2300, entry


@pytest.mark.parametrize(
    ("name", "how"),
    [
        pytest.param(name, how, marks=pytest.mark.slow if (number + other) % 2 else ())  # each by one way always
        for number, name in enumerate(STATED)
        for other, how in enumerate((pulled, silenced))
    ],
)
def test_a_reference_that_goes_while_a_field_is_held_ends_with_the_coils_at_zero(
    bench_file: Callable[..., Path], monkeypatch: pytest.MonkeyPatch, name: str, how: Any
) -> None:
    seen: list[float] = []
    fault, coils, ended_s = held_and_then(how(monkeypatch), bench_file("", reference(name, STATED[name])), seen)
    assert isinstance(fault, InstrumentError), fault
    assert fault.fault == ("link lost" if how is pulled else "silent")
    assert fault.remedy
    assert at_zero_s(coils, seen[0], ended_s) < ZERO_S


@pytest.mark.parametrize("how", [pulled, silenced])
def test_a_dut_that_goes_ends_the_field_in_seconds_for_hands_go_to_its_plug(
    bench_file: Callable[..., Path], monkeypatch: pytest.MonkeyPatch, how: Any
) -> None:
    seen: list[float] = []
    fault, coils, ended_s = held_and_then(how(monkeypatch), bench_file(), seen, of="dut")
    assert isinstance(fault, InstrumentError), fault
    assert fault.fault == ("link lost" if how is pulled else "silent")
    assert NOTICED_S < at_zero_s(coils, seen[0], ended_s) < NOTICED_S + ZERO_S
