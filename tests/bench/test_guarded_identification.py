"""Seven instruments on real lines are identified at once, the guardian's supplies too."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from served_lab import Served, all_gone

from labcal.bench import bench as bench_module
from labcal.bench import guarded_identification, open_bench
from labcal.bench.bench import Bench
from labcal.bench.guarded_identification import AskedSupply
from labcal.bench.guardian import client
from labcal.bench.identification import HOLDS_S
from labcal.bench.loading import Loader
from labcal.errors import InstrumentError

LONG_S = 60.0  # longer than a busy machine needs
SUPPLIES = {"supply_x", "supply_y", "supply_z"}
ASKED = dict.fromkeys(SUPPLIES, b"*IDN?") | {"stage": b"get deviceid", "reversers": b"\1\3\x80\0"}


def answer_only_together(lab: Served, patch: pytest.MonkeyPatch) -> set[str]:
    """From now on a supply says who it is once all three have been asked; those that have been."""
    asked = set[str]()

    def held(name: str, emulator: Any) -> None:
        take, emit = emulator.take, emulator.emit

        def heard(t_s: float, data: bytes) -> None:
            if b"*IDN?" in data:
                asked.add(name)
            take(t_s, data)

        patch.setattr(emulator, "take", heard)
        patch.setattr(emulator, "emit", lambda until_s: [] if name in asked < SUPPLIES else emit(until_s))

    for name in SUPPLIES:
        held(name, lab.emulator(name))
    return asked


def test_no_supply_waits_for_another_to_say_who_it_is(lab: Served, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(guarded_identification, "HOLDS_S", 0.0)
    try:
        with open_bench(lab.file, identify=False) as bench:
            asked = answer_only_together(lab, monkeypatch)
            assert len(bench.identities()) == 7
            assert asked == SUPPLIES
    finally:
        all_gone(lab.file)


def test_the_sessions_own_are_asked_once_while_the_guardian_begins(
    lab: Served, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked, stage, found = list[bytes](), lab.emulator("stage"), client.found
    take = stage.take

    def heard(t_s: float, data: bytes) -> None:
        asked.append(data)
        take(t_s, data)

    monkeypatch.setattr(stage, "take", heard)
    monkeypatch.setattr(client, "found", lambda urls: found(urls) if asked else None)  # it is not there before
    try:
        with open_bench(lab.file) as bench:
            assert bench.platform.name == "stage"
        assert sum(b"get deviceid" in data for data in asked) == 1
    finally:
        all_gone(lab.file)


def heard_of(lab: Served, patch: pytest.MonkeyPatch) -> dict[str, int]:
    """How often each instrument is asked who it is from now on."""
    times = dict.fromkeys(ASKED, 0)

    def listened(name: str, emulator: Any, question: bytes) -> None:
        take = emulator.take

        def heard(t_s: float, data: bytes) -> None:
            times[name] += data.count(question)
            take(t_s, data)

        patch.setattr(emulator, "take", heard)

    for name, question in ASKED.items():
        listened(name, lab.emulator(name), question)
    return times


def test_who_said_on_its_way_to_zero_who_it_is_is_not_asked_again_by_the_session_or_a_run(
    lab: Served, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(bench_module, "HOLDS_S", LONG_S)
    monkeypatch.setattr(guarded_identification, "HOLDS_S", LONG_S)
    times = heard_of(lab, monkeypatch)
    try:
        with open_bench(lab.file) as bench:
            assert times == dict.fromkeys(ASKED, 1)
            who = bench.identities()
            assert times == dict.fromkeys(ASKED, 1)
            assert bench.reconnect("stage") == who["stage"]
            assert bench.identities() == who
            assert times == dict.fromkeys(ASKED, 1) | {"stage": 3}
    finally:
        all_gone(lab.file)


def test_the_relay_board_is_asked_beside_the_way_to_zero(lab: Served, monkeypatch: pytest.MonkeyPatch) -> None:
    times = heard_of(lab, monkeypatch)
    try:
        with open_bench(lab.file, identify=False) as bench:
            wait_until(lambda: times["reversers"] == 1, bench)
    finally:
        all_gone(lab.file)


def wait_until(true: Callable[[], bool], bench: Bench) -> None:
    ends_s = bench.clock.now() + LONG_S
    while not true():
        assert bench.clock.now() < ends_s
        bench.clock.wait_until(bench.clock.now() + 0.02)


def test_an_answer_that_is_too_old_for_a_record_is_asked_for_again(
    lab: Served, monkeypatch: pytest.MonkeyPatch
) -> None:
    times = heard_of(lab, monkeypatch)
    try:
        with open_bench(lab.file) as bench:
            bench.clock.wait_until(bench.clock.now() + HOLDS_S)
            bench.identities()
            assert times == dict.fromkeys(ASKED, 2)
    finally:
        all_gone(lab.file)


def test_a_line_of_its_own_that_does_not_open_is_named_and_the_guardian_is_let_go(
    lab: Served, monkeypatch: pytest.MonkeyPatch
) -> None:
    instrument = Loader.instrument

    def opened(loader: Loader, name: str) -> Any:
        if name == "stage":
            raise InstrumentError("stage: there is no such port", fault="link lost")
        return instrument(loader, name)

    monkeypatch.setattr(Loader, "instrument", opened)
    with pytest.raises(InstrumentError, match="stage: there is no such port"):
        open_bench(lab.file)
    all_gone(lab.file)


def test_a_guardian_that_is_gone_meanwhile_is_named() -> None:
    class Gone:
        def order(self, order: str, **what: Any) -> int:
            raise BrokenPipeError("broken pipe")

    gone: Any = Gone()
    with pytest.raises(InstrumentError, match="supply_x: the guardian is gone") as caught:
        AskedSupply("supply_x", gone).identify()
    assert caught.value.fault == "guardian lost"
