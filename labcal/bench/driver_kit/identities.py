"""Who answers, compared: another instrument than before, or the same one at the ends of two links."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import fields

from labcal.bench.driver_kit.roles import Identity
from labcal.bench.links.ports import port_of
from labcal.bench.links.quoting import abridged, quoted
from labcal.errors import InstrumentError

ASKED = 3  # times at most, where the answers differ


def the_same(name: str, identify: Callable[[], Identity], before: Identity | None) -> Identity:
    """Who answers `identify` as `name`; where it was another `before`, it is asked again: a line may damage an answer.

    Raises InstrumentError: another instrument, where the same other name came twice in a row; wrong reply, where no
    two names were the same.
    """
    said = [identify()]
    if before is None:
        return said[0]
    while said[-1] != before:
        if said[-1] in said[-2:-1]:
            refuse_other(name, said[-1], before)
        if len(said) == ASKED:
            names = ", then ".join(map(_words, said))
            raise InstrumentError(f"{name}: its name came damaged ({names}).", fault="wrong reply")
        said.append(identify())
    return before


def refuse_other(name: str, who: Identity, before: Identity) -> None:
    """Raise InstrumentError (another instrument) where `who` answers as `name`, and before it was another."""
    if who == before:
        return
    is_now, was = _words(who), _words(before)
    if is_now == was:
        differ = [f.name for f in fields(Identity) if getattr(who, f.name) != getattr(before, f.name)]
        is_now = f"{is_now} with {_named(who, differ)}"
        was = f"one with {_named(before, differ)}"
    raise InstrumentError(
        f"{name}: {is_now} answers, before it was {was}.",
        fault="another instrument",
        remedy="Plug the instruments in as bench.toml says, and begin again.",
    )


def one_at_two_links(who: Mapping[str, Identity], links: Mapping[str, str]) -> dict[str, InstrumentError]:
    """Faults by name: another, whose link is to another port, says the same maker, model and serial number.

    One without a serial number, or whose number is 0, is never taken for another.
    """
    ports, faults = {name: port_of(links[name]) for name in who}, dict[str, InstrumentError]()
    for name, one in who.items():
        twins = [other for other, its in who.items() if _serial(its) == _serial(one) and ports[other] != ports[name]]
        if twins and one.serial.strip(" 0"):
            faults[name] = InstrumentError(
                f"{name}: {_words(one)} answers here and as {twins[0]}: the same instrument answers on both links.",
                fault="another instrument",
                remedy="Correct the links in bench.toml, then begin again.",
            )
    return faults


def refuse_one_at_two_links(who: Mapping[str, Identity], links: Mapping[str, str]) -> None:
    """Raise the first of these faults."""
    for fault in one_at_two_links(who, links).values():
        raise fault


def _serial(who: Identity) -> tuple[str, str, str]:
    return who.manufacturer, who.model, who.serial


def _words(who: Identity) -> str:
    return f"{abridged(who.model)} {abridged(who.serial)}"


def _named(who: Identity, names: list[str]) -> str:
    return " and ".join(f"{name} {quoted(getattr(who, name))}" for name in names)
