"""Seven instruments on real lines are identified at once, the guardian's supplies too."""

from __future__ import annotations

from typing import Any

import pytest
from served_lab import Served, all_gone

from labcal.bench import open_bench
from labcal.bench.guarded_identification import AskedSupply
from labcal.bench.guardian import client
from labcal.bench.loading import Loader
from labcal.errors import InstrumentError

SUPPLIES = {"supply_x", "supply_y", "supply_z"}


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
