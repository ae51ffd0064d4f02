"""No sentence about the coils that was not read back: each is made in one place, from a reading and its age."""

from __future__ import annotations

import ast
import itertools
import re
from collections.abc import Iterator
from datetime import datetime
from functools import cache
from pathlib import Path

import pytest

from labcal.bench.coils.state import (
    AT_ZERO,
    BY_WORD,
    FRESH_S,
    NOT_BY_REFERENCE,
    CoilReading,
    LabState,
    Witness,
    from_json,
    of_ends,
)
from labcal.bench.coils.zero import AtZero
from labcal.errors import InstrumentError

ROOT = Path(__file__).parents[1]
THE_PLACE = "labcal/bench/coils/state.py"
THE_FORMS = tuple(  # of what the place, faults and the procedures say, for other languages
    file.relative_to(ROOT).as_posix()
    for file in (ROOT / "labcal/gui/translations").glob("*.py")
    if file.name != "translate.py"
)
CLAIM = re.compile(
    r"\bcoils?\b.*\b(zero|off|on|safe|energis\w*|open\w*)\b|\b(at|to) zero\b|energised|\bsafe\b|^zero, "
    r"|\boutputs?\b.*\b(open|off|on|closed)\b|\bzero\b.*\b(word|confirmed)",
    re.IGNORECASE | re.DOTALL,
)
ORDER, HELP, ASKED, REFUSED, READ = (
    "tells a person what to do",
    "says what a button, a command or a setting does, or names one",
    "a question, or the name of what is measured",
    "says what was refused or is going on, not how the coils are",
    "is made of the read-back that it quotes, where it was read",
)
NOT_KNOWN = "stands above the words of a reading for as long as that does not say that they are at zero"
NO_CLAIM = {
    "The guardian is lost. COILS OFF (F12) works without it.": HELP,
    "The guardian is a program of its own beside labcal: it holds the lines of the supplies, and takes every coil to "
    "zero when a session ends, breaks off or no longer answers.": HELP,
    "✕ HANDS OFF: the coils may be on": NOT_KNOWN,
    "✕ HANDS OFF: a coil is still on, the field says so": READ,
    "a coil is still on by the field": READ,
    "A run goes on: the coils may be on. Hands off.": NOT_KNOWN,
    "a supply of an earlier session is not at zero: {0}": NOT_KNOWN,
    "✕ Supplies of an earlier session are not at zero: {0}": NOT_KNOWN,
    "If one of them stands somewhere still, switch it off by hand, then press COILS OFF (F12).": ORDER,
    "Switch them off by hand; where they are gone, say so in labcal's window after COILS OFF": ORDER,
    "Coils to zero, then what the reference sees; nothing is energised": HELP,
    "Checking the zero: coils to zero, then what the reference sees …": REFUSED,
    "▲ Hands off: another process drives a run of {0}; the coils may be on": NOT_KNOWN,
    "COILS OFF was pressed at {0}; nobody has confirmed it": NOT_KNOWN,
    "the reference sees {0} µT along {1} more than with the coils off": READ,
    "the field says: still on ({1}, {0} µT more than with the coils off, {2})": READ,
    "; the guardian of the last session has {0} until {1} is read back at zero": NOT_KNOWN,
    "{0}: not confirmed at zero when the window closed, {1}": NOT_KNOWN,
    "HANDS OFF: not at zero yet. The window does not close by itself.": NOT_KNOWN,
    "With the window closed the guardian keeps trying to bring every coil to zero; "
    "nobody sees whether it does.": NOT_KNOWN,
    "No guardian holds the supplies: COILS OFF is given once more on closing; "
    "nobody sees what becomes of it.": NOT_KNOWN,
    "Going to zero; the window closes after that …": ORDER,
    "Is the winding whole, does the voltage suffice? Set the coils off.": ORDER,
    "Press COILS OFF (F12): it stops the platform as well. Hands off until you see it stand.": ORDER,
    "COILS OFF does not reach it: stop it at its controller. Hands off until you see it stand.": ORDER,
    "press COILS OFF (F12) first: it stops the platform too, if it can be reached. If it keeps turning, stop it at its "
    "controller": ORDER,
    "COILS OFF was pressed, and stops it if it can be reached. If it keeps turning, stop it at its controller": ORDER,
    "COILS OFF: the run stops …": ORDER,
    "Stop the platform (COILS OFF)": ORDER,
    "The platform kept turning: COILS OFF is given anew, and stops it …": REFUSED,
    "Has its output gone off by itself, is the winding open? Set the coils off, look at its panel, and find out why "
    "before it is cleared.": ORDER,
    "Ramp it to zero first; or `labcal bench off`.": ORDER,
    "Set coils off.": ORDER,
    "open the output of {} at its panel, or switch it off at its mains": ORDER,
    "Switch the option 'power-on output' off in its menu.": ORDER,
    "COILS OFF (F12), then switch off by hand: {0}": ORDER,
    "First press COILS OFF (F12), then switch off by hand the supply that does not answer.": ORDER,
    "record at rest with the coils off, then switch what runs at that period off one by one": ORDER,
    "record at rest with the coils off: the noise that remains is the sensor's own": ORDER,
    "repeat with the coils at zero, and with the reference turned by 180°": ORDER,
    "End it, or the session that drives this bench; `labcal bench off` brings its coils to zero meanwhile.": HELP,
    "Instruments: find, check, serve emulated ones, coils off; approve a cage.": HELP,
    "COILS OFF   F12": HELP,
    "COILS OFF done {0}: {1}": READ,
    "{0} COILS OFF: {1}": READ,
    "stopped by COILS OFF": HELP,
    "■ Stopped by COILS OFF (F12)": HELP,
    "Take every coil to zero now (F12). Works in every state and asks nothing.": HELP,
    "coils off, at any moment": HELP,
    "Until somebody logs in; COILS OFF works all the same": HELP,
    "COILS OFF (F12) works all the same. A name says who is meant; signing still asks for your key.": HELP,
    "Ask every instrument who it is. Nothing is energised or moved.": HELP,
    "Asks every instrument who it is, then begins. Nothing is energised before you are asked.": HELP,
    "Wait where the next step begins, with the coils at zero": HELP,
    "End this run now, in order. The coils go to zero; what was measured is kept.": HELP,
    "Control whether the output is on.": HELP,
    "the cage as it will be used, coils off": HELP,
    "coils-off zero, first and last": HELP,
    "coils-off zero before": HELP,
    "coils off between two turns": HELP,
    "DUT less reference, coils off": ASKED,
    "Coil {} makes a gradient now, with the current of {} µT. Hands off?": ASKED,
    "COILS OFF": HELP,
    "The coils go to zero, the window closes. What was measured is kept; this procedure cannot be gone on with.": HELP,
    "The coils go to zero, the window closes. What is missing is measured later: Go on, on the Start page.": HELP,
    "its watchdog has taken it to zero": READ,
    "its output is off": READ,
    "zero, output open": READ,
    "zero, output not open": READ,
    "Try again: its output has to go on anew.": ORDER,
    "Each coil goes to ±{} µT in turn. Hands off?": ASKED,
    "Each coil goes to ±{} µT. Hands off?": ASKED,
    "The coils go up to {} µT, then the field rotates. Hands off?": ASKED,
    "While this sheet is open no key answers a question; COILS OFF (F12) works.": HELP,
    "current at zero {}": ASKED,
    "Each coil alternates from ±{} µT downwards. Hands off?": ASKED,
    "Where it lives, or another stands by, that one takes the coils to zero: guardian.log says what was read back, and "
    "`labcal bench off` sets zero and reads it back. Then start the run again.": HELP,
    "taking the coils to zero: ordered, not read back yet …": REFUSED,
    "taking to zero from here what no guardian holds: not read back yet …": REFUSED,
    "to zero: {}": REFUSED,
    "taken to zero": REFUSED,
    "{} was to be made safe": REFUSED,
    "a field of {} nT of the coils alone is beyond the limit of {} nT, Earth's {} nT taken off; nothing was set.": (
        REFUSED
    ),
    "no guardian drives this bench and no coil was touched. Correct the file and say off again, or switch the supplies "
    "off by hand": REFUSED,
    "no guardian was started for this file and no coil was touched, but a guardian drives the bench of {}: name that "
    "file, or switch the supplies off by hand": REFUSED,
    "{}: the coils may be energised again. {}": REFUSED,
    "Coils off: reading them back …": REFUSED,
    "coil {}: the guardian before is gone; it had ordered zero and reported no read-back.": REFUSED,
    "zero of coil {} is not confirmed, and tried again": REFUSED,
    "coil {}: zero has not been read back.": REFUSED,
    "NOT confirmed at zero: {}": READ,
    "it did not answer in the time that there is on the way to zero.": REFUSED,
    "{} A was not sent: this coil was ordered to zero, and {} A is the most that it may still hear.": REFUSED,
    "{}: its output was not closed: this coil was ordered to zero.": REFUSED,
    "Coils off: the run ends …": REFUSED,
    "Coils off: no bench is open, this window drives no coil.": REFUSED,
    "the pause took the field to zero, and the procedure did not bring it back before {}: nothing was measured in a "
    "wrong field. Begin the run anew, without a pause; who wrote the procedure lets each step say its field (energise, "
    "energise_again or coils_off).": REFUSED,
    "not allowed with the output on": REFUSED,
    "{}: it would switch its output on by itself when it gets power.": REFUSED,
    "It closes when every coil is read back at zero; `guardian.log` says which is not.": HELP,
    "coil {}: {} A still flows; its output is not opened under current.": READ,
    "coil {}: {} A still flows after zero was set; the contacts were not moved.": READ,
    "coil {}: {} A still flows {} s after zero was set (zero is below {} A).": READ,
    "coil {} came to zero without a ramp": READ,
    "zero, open": READ,
    "zero, not open": READ,
}


def literals(path: Path) -> Iterator[str]:
    """Every text of a file that is no docstring; what is filled in stands as {}."""
    nodes, silent = list(ast.walk(ast.parse(path.read_text(encoding="utf-8")))), set[int]()
    for node in nodes:
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            silent.add(id(node.value))
        if isinstance(node, ast.JoinedStr):
            silent |= {id(part) for part in node.values}
        if isinstance(node, ast.FormattedValue) and node.format_spec is not None:
            silent |= {id(part) for part in ast.walk(node.format_spec)}
    for node in nodes:
        if id(node) in silent:
            continue
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            yield node.value
        elif isinstance(node, ast.JoinedStr):
            yield "".join(str(part.value) if isinstance(part, ast.Constant) else "{}" for part in node.values)


@cache
def said_of_coils() -> tuple[tuple[str, str], ...]:
    """File and text of everything that might claim something."""
    files = [path for folder in ("labcal", "drivers", "procedures") for path in sorted((ROOT / folder).rglob("*.py"))]
    files = [path for path in files if ROOT / "labcal" / "testing" not in path.parents]  # tells an author of his part
    said = ((path.relative_to(ROOT).as_posix(), text) for path in files for text in literals(path))
    return tuple((path, text) for path, text in said if " " in text and CLAIM.search(text))


def test_what_is_said_of_the_coils_is_made_from_a_reading() -> None:
    strays = [
        f"{path}: {text!r}"
        for path, text in said_of_coils()
        if path not in (THE_PLACE, *THE_FORMS) and text not in NO_CLAIM
    ]
    assert not strays, "make it in labcal/bench/coils/state.py from a reading, or say here why it claims nothing:\n" + (
        "\n".join(strays)
    )


def test_the_list_of_what_claims_nothing_only_shrinks() -> None:
    assert set(NO_CLAIM) <= {text for _, text in said_of_coils()}


def test_the_net_catches_the_sentences_that_were_there_before() -> None:
    for text in ("The coils are at zero.", "Coils stay at zero; plug it in.", "Coils go to zero; look.",
                 "All coils are at zero.", "The output stays open; look at it.", "✓ all at zero"):  # fmt: skip
        assert CLAIM.search(text), text


def state(ages_s: tuple[float, float, float], zero: bool, verdict: str, seen_s: float) -> LabState:
    current = 0.001 if zero else 0.5
    coils = tuple(CoilReading(a, 0.0, current, zero, True, -age) for a, age in zip("xyz", ages_s, strict=True))
    return LabState(coils, Witness(verdict, "none", (99.0, 0, 0), (0, 0, 0), 99.0, 2.0, -seen_s))  # type: ignore[arg-type]


def test_coils_are_at_zero_only_where_all_was_read_just_now_and_the_reference_agrees() -> None:
    said = set[str]()
    ages = (0.0, FRESH_S, FRESH_S + 0.01, 60.0)
    for age, zero, verdict, seen in itertools.product(ages, (True, False), ("agrees", "disagrees", "not known"), ages):
        sentence = state((0.0, age, 0.0), zero, verdict, seen).sentence(0.0)
        fresh = age <= FRESH_S and zero
        assert (sentence == AT_ZERO) == (fresh and verdict == "agrees" and seen <= FRESH_S), sentence
        assert sentence.startswith(NOT_BY_REFERENCE) == (verdict == "disagrees")
        if not fresh and verdict != "disagrees":
            assert not sentence.startswith((AT_ZERO, BY_WORD)), sentence
        said.add(re.sub(r"\d+", "n", sentence))
    assert len(said) > 6


@pytest.mark.parametrize("unread", ["", "supply_y: silent"])
def test_an_axis_that_was_not_read_back_is_never_at_zero(unread: str) -> None:
    coils = (
        CoilReading("x", 0.0, 0.0, True, True, 0.0),
        CoilReading("y", fault=unread),
        CoilReading("z", 0.0, 0.0, True, True, 0.0),
    )
    found = LabState(coils, Witness("agrees", read_s=0.0))
    assert found.sentence(0.0) == ("coils NOT confirmed at zero" if unread else "coils not read back in this session")
    assert found.at_zero(0.0) is (False if unread else None)


def test_whoever_asks_no_reference_has_the_supplys_word_only() -> None:
    ended = [AtZero(axis, 0.0005, True, None, 100.0) for axis in "xyz"]
    assert of_ends(ended).sentence(101.0) == f"{BY_WORD}: no reference has confirmed it"
    assert of_ends(ended).sentence(110.0) == "coils read back at zero by the supply's word 10 s ago; not watched since"
    assert (
        of_ends(ended).sentence(100.0 + 61 * 60)
        == "coils read back at zero by the supply's word 61 min ago; not watched since"
    )
    assert (
        of_ends(ended).sentence(100.0 + 3 * 3600 + 1)
        == "coils read back at zero by the supply's word 3 h ago; not watched since"
    )
    lost = [*ended[:2], AtZero("z", None, False, InstrumentError("supply_z: silent."))]
    assert of_ends(lost).sentence(101.0) == "coils NOT confirmed at zero"
    assert of_ends(ended, "it saw 99").sentence(101.0).startswith(f"{NOT_BY_REFERENCE}: it saw 99. Open")


def test_a_zero_that_is_past_is_said_by_the_clock_and_by_whose_word() -> None:
    at = datetime(2026, 11, 28, 14, 3, 21)
    confirmed, by_word = state((180.0,) * 3, True, "agrees", 181.0), state((180.0,) * 3, True, "agrees", 60.0)
    since = at.timestamp() + 180.0
    assert confirmed.sentence(0.0, since) == "coils confirmed at zero at 14:03:21 (3 min ago); not watched since"
    said = "coils read back at zero by the supply's word at 14:03:21 (3 min ago); not watched since"
    assert by_word.sentence(0.0, since) == said  # the reference was looked at two minutes after that


def test_the_supplys_word_now_and_a_reference_that_agreed_before_are_told_apart() -> None:
    said = state((0.0, 0.0, 0.0), True, "agrees", 3.9).sentence(0.0)
    assert said == f"{BY_WORD}: the reference agreed when it was last looked at, 3 s ago"  # in whole seconds


def test_what_the_reference_saw_is_said_with_its_age() -> None:
    again = Witness("not known", "the reference is looked at again: it sees 1 2 3 nT", read_s=0.0)
    coils = tuple(CoilReading(axis, 0.0, 0.0, True, True, read_s=0.0) for axis in "xyz")
    for now_s, age in ((0.5, ""), (1.7, ", 1 s ago")):
        assert LabState(coils, again).sentence(now_s) == f"{BY_WORD}: {again.why}{age}"


def test_the_value_goes_to_another_process_with_its_age() -> None:
    there = state((0.5, 1.0, 1.5), True, "agrees", 0.2)
    back = from_json(there.as_json(10.0), 110.0)
    assert back == there.shifted(100.0)
    assert back.sentence(100.0) == AT_ZERO
    assert back.age_s(100.0) == 1.5
