"""What a run says last of its coils comes from the guardian, which goes on trying what did not answer."""

from __future__ import annotations

import threading
import time
from typing import Any

import pytest
from served_lab import Served, all_gone, example, log, until

from labcal import session
from labcal.bench.coils.at_zero import AtZero
from labcal.bench.coils.state import AT_ZERO, BY_WORD, NOT_BY_REFERENCE, NOT_CONFIRMED, WAS_ZERO, CoilReading, LabState
from labcal.bench.guardian.client import GuardianClient
from labcal.cli.run import told_once
from labcal.errors import InstrumentError
from labcal.record.stream import Event, Item
from labcal.runner import Control
from labcal.runner.prompts import first_choice

NOT_READ = "NOT confirmed at zero: coil y"
SILENT = InstrumentError("supply_y: no reply in 1.5 s, nothing came.", fault="silent")


@pytest.fixture
def bench_text() -> str:
    return example(timeout_s=1.5)


class Mute:
    """Ends the run as soon as a field is held, from when on supply_y hears and says nothing, as long as it is to."""

    def __init__(self, lab: Served, *, for_ever: bool) -> None:
        self.control, self.said = Control(), list[str]()
        self._supply: Any = lab.emulator("supply_y")
        self._for_ever = for_ever

    def on_item(self, item: Item) -> None:
        if isinstance(item, Event):
            self.said.append(item.text)
            if item.kind == "set-point" and "emit" not in vars(self._supply) and not self.control.stopping():
                self._supply.emit = lambda until_s: []
                self.control.stop()
                threading.Thread(target=self._speak_again, daemon=True).start()

    def _speak_again(self) -> None:
        until(lambda: log().count(NOT_READ) >= 3)  # the procedure's own undo, the run's end, and its second try
        time.sleep(2.0)  # by then a session that asks no more has said its word
        if not self._for_ever:
            self.speak()

    def speak(self) -> None:
        vars(self._supply).pop("emit", None)


def held(lab: Served, mute: Mute) -> session.Outcome:
    return session.run(
        "field-hold", lab.file, {"duration_s": "30"}, answer=first_choice, operator="x", control=mute.control,
        on_item=mute.on_item,
    )  # fmt: skip


def test_a_coil_that_its_guardian_reads_at_last_is_said_to_be_at_zero(lab: Served) -> None:
    mute = Mute(lab, for_ever=False)
    outcome = held(lab, mute)
    assert NOT_READ in log(), f"{mute.said}\n{outcome}\n{log()}"
    assert outcome.at_rest.startswith((AT_ZERO, BY_WORD, WAS_ZERO)), f"{outcome.at_rest}\n{log()}"
    assert NOT_CONFIRMED not in outcome.ending
    assert not [text for text in mute.said if NOT_CONFIRMED in text]


@pytest.mark.slow
def test_what_its_guardian_alone_could_read_is_not_said_to_be_unknown(
    lab: Served, monkeypatch: pytest.MonkeyPatch
) -> None:
    mute, ask = Mute(lab, for_ever=False), GuardianClient.ask

    def ask_in_vain(guardian: GuardianClient, order: str, **what: Any) -> Any:
        if order == "measure_current" and what["axis"] == "y" and mute.control.stopping():
            raise SILENT
        return ask(guardian, order, **what)

    monkeypatch.setattr(GuardianClient, "ask", ask_in_vain)
    outcome = held(lab, mute)
    assert NOT_READ in log(), f"{mute.said}\n{outcome}\n{log()}"
    assert outcome.at_rest.startswith((AT_ZERO, BY_WORD, WAS_ZERO)), f"{outcome.at_rest}\n{log()}"
    assert NOT_CONFIRMED not in outcome.ending
    assert not [text for text in mute.said if NOT_CONFIRMED in text]


@pytest.mark.slow
def test_one_that_never_answers_is_not_confirmed_and_waited_for_once(lab: Served) -> None:
    mute = Mute(lab, for_ever=True)
    begun = time.monotonic()
    try:
        outcome = held(lab, mute)
        assert outcome.at_rest.startswith(NOT_CONFIRMED), f"{outcome.at_rest}\n{log()}"
        assert NOT_CONFIRMED in outcome.ending
        assert time.monotonic() - begun < 60.0
    finally:
        mute.speak()
        all_gone(lab.file)


@pytest.mark.parametrize(
    ("ended", "at_s", "says"),
    [
        (AtZero("y", 0.0, True, None, 11.0), 11.5, BY_WORD),
        (
            AtZero("y", 0.0, True, None, 11.0),
            15.0,
            "coils read back at zero by the supply's word 5 s ago; not watched since",
        ),
        (AtZero("y", None, False, SILENT), 11.5, NOT_CONFIRMED),
    ],
    ids=["just now", "a while ago", "never"],
)
def test_the_last_word_of_a_coil_is_its_guardians_with_its_age(ended: AtZero, at_s: float, says: str) -> None:
    lab = LabState((CoilReading("x", 0.0, 0.0, True, True, 10.0), CoilReading("y", fault="silent")))
    assert lab.sentence(at_s) == NOT_CONFIRMED
    assert lab.with_ends([ended]).sentence(at_s).startswith(says)


def test_a_reading_of_ones_own_that_is_newer_stands() -> None:
    lab = LabState((CoilReading("y", 0.0, 0.001, True, True, 12.0),))
    assert lab.with_ends([AtZero("y", 0.0, True, None, 11.0)]) == lab
    assert lab.with_ends([AtZero("y", None, False, SILENT)]).sentence(12.5) == NOT_CONFIRMED


def test_what_was_not_confirmed_and_was_read_since_is_said_as_that() -> None:
    ending = f"failed: {NOT_CONFIRMED}: it is silent"
    assert told_once(ending, f"{BY_WORD}: no reference") == f"{ending}; since then: {BY_WORD}: no reference"
    assert told_once(ending, NOT_CONFIRMED) == ending


def test_of_two_looks_at_the_reference_the_last_is_said_with_what_can_be_done() -> None:
    ending, lab = f"interrupted: {NOT_BY_REFERENCE}: it sees 1 2 3 nT", f"{NOT_BY_REFERENCE}: it sees 1 2 4 nT. Open it"
    assert told_once(ending, lab) == f"interrupted: {lab}"
    assert told_once(f"failed: {NOT_CONFIRMED}: silent; {ending[13:]}", f"{NOT_CONFIRMED}; {lab}").count("it sees") == 1
