"""The lab after its coils were switched off by a process that is no run, and read back."""

from __future__ import annotations

import time
from collections.abc import Iterable
from dataclasses import replace

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.bench.coils import state
from labcal.bench.essentials import AXES
from labcal.bench.stage_off import NOT_YET
from labcal.gui.ipc.answers import Bench, CoilEnd, SwitchedOff
from labcal.gui.translations.punctuation import listed_apart, with_head
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated

OUTPUTS = {
    "zero, open": QT_TRANSLATE_NOOP("Words", "zero, output open"),
    "zero, not open": QT_TRANSLATE_NOOP("Words", "zero, output not open"),
}


def _how_it_ended(words: str) -> str:
    """What is said of a coil that was switched off, in the window's language; what is open is its output."""
    ended = OUTPUTS.get(words)
    return in_words(words) if ended is None else translated(str(ended))


def coils_ended(ends: Iterable[tuple[str, str]]) -> str:
    """Of all coils, each by its axis and how it ended; those that ended alike are named together."""
    axes: dict[str, list[str]] = {}
    for axis, words in ends:
        axes.setdefault(_how_it_ended(words), []).append(axis)
    return listed_apart([with_head(", ".join(alike), words) for words, alike in axes.items()])


def coil_read(said: CoilEnd) -> state.CoilReading:
    """One axis as it was read back when it was switched off."""
    known, read_s = said.current_A is not None, said.read_s or time.monotonic()
    fault = "" if said.ok else said.words
    return state.CoilReading(said.axis, None, said.current_A, known, known, read_s if known else None, fault)


def switched_off(
    before: state.LabState, said: SwitchedOff, facts: Bench | None, *, stood: bool = False
) -> state.LabState:
    """The lab after its coils were switched off and read back, with the doubt that stands about their zero.

    `stood`: the platform did when it was told to stop, and nothing has turned it since.
    """
    rested = bool(before.coils) and all(coil.zero for coil in before.coils)  # it agreed with a zero, which stands
    witness = before.reference if rested and before.reference.verdict == "agrees" else state.Witness()
    if said.doubt:
        witness = state.Witness("disagrees", said.doubt, advice=said.advice or state.OPEN_THEM)
    ends = {one.axis: one for one in said.coils}
    coils = tuple(coil_read(ends[axis]) for axis in AXES if axis in ends)  # by name: what has another is no coil here
    heard = heard_from(before.instruments, said.coils, facts)
    if said.platform is not None and said.platform.read_s is not None:  # who was seen to stand was heard
        heard = _heard_at(heard, "platform", said.platform.read_s, facts)
    platform = _stopped(before.platform, said.platform, stood=stood)
    return replace(before, coils=coils, reference=witness, guardian=None, instruments=heard, platform=platform)


def _stopped(
    before: state.PlatformReading | None, said: state.PlatformReading | None, *, stood: bool
) -> state.PlatformReading | None:
    """The platform after it was told to stop: where nobody saw it stand, where it turned when it was read last.

    One that `stood` before, and was not looked at in time, is as it was read then, and as old.
    """
    if stood and said is not None and said.fault == NOT_YET:
        return before
    if said is not None and said.moving is None and before is not None and before.moving:
        return replace(before, fault=said.fault)
    return said or before


def _heard_at(heard: tuple[state.Heard, ...], role: str, at_s: float, facts: Bench | None) -> tuple[state.Heard, ...]:
    names = [name for name, one in facts.instruments.items() if one.role == role] if facts is not None else []
    return (*(one for one in heard if one.name not in names), *(state.Heard(name, at_s) for name in names))


def heard_from(
    before: tuple[state.Heard, ...], said: tuple[CoilEnd, ...], facts: Bench | None
) -> tuple[state.Heard, ...]:
    """Supplies that were read back answer, whatever was wrong with them before."""
    roles = {} if facts is None else {one.role: name for name, one in facts.instruments.items()}
    heard = {one.name: one for one in before}
    for one in said:
        if one.ok and one.read_s is not None and (name := roles.get(f"coil-{one.axis}")):
            heard[name] = state.Heard(name, one.read_s)
    return tuple(heard.values())
