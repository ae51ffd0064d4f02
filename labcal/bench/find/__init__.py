"""What answers on which port: every place is asked who is there, in the words of the drivers, and nothing is set."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from labcal.bench.clock import Clock
from labcal.bench.find.draft import draft
from labcal.bench.find.known_usb import no_port, silent
from labcal.bench.find.questions import Found, Recognise, asked, by_words
from labcal.bench.find.where import MDNS, PORTS, USB, VISA, places
from labcal.bench.links import open_link
from labcal.bench.links.announced import announced
from labcal.bench.links.plugged import serial_ports, usb_devices
from labcal.bench.links.visa import resources
from labcal.errors import InputError, InstrumentError

__all__ = ["Found", "draft", "find", "places", "why_silent"]

PORTS_SAID = ", ".join(map(str, PORTS))
UNASKED = "; not asked, for it may be in use: state its link to ask it"


def find(links: Sequence[str], clock: Clock, recognise: Recognise = lambda said: None) -> Iterator[Found]:
    """What answers at each of these; of a place that is silent nothing is yielded but what its numbers on USB say.

    What is elsewhere on the network, and was not stated, says who it is or is named; no connection to it is opened.
    """
    for link in links:
        if link == USB:
            yield from (box for one in usb_devices() if (box := no_port(one)) is not None)
        elif link.startswith(MDNS):
            yield from _announced(link.removeprefix(MDNS), recognise)
        elif link == VISA:
            yield from _on_visa(clock, recognise)
        else:
            found = list(asked(link, clock, recognise))
            yield from found or _on_usb(link)


def why_silent(place: str, clock: Clock) -> str:
    """Why nothing was found at a place that a person stated: what keeps its line from being opened, or nobody spoke."""
    link, *more = places([place])
    if more:
        return f"{place}: no link and no device; taken for a host, nobody answers at its usual ports ({PORTS_SAID})"
    if link in (USB, VISA) or link.startswith(MDNS):
        return f"{link}: nothing is there"
    try:
        open_link(link, clock).close()
    except InputError as error:
        return error.what
    except InstrumentError as error:
        return str(error)
    return f"{link}: it can be opened, and nobody answers; is it powered, and the line's other end?"


def _on_usb(link: str) -> Iterator[Found]:
    """A serial port that is silent, if it is a device on USB."""
    device = link.removeprefix("serial://").partition("?")[0]
    for one in serial_ports() if link.startswith("serial://") else ():
        if Path(one.port).resolve() == Path(device).resolve():
            yield silent(link, one)


def _announced(interface: str, recognise: Recognise) -> Iterator[Found]:
    for one in announced(interface):
        who = by_words(one.link, one.said, recognise)
        if one.link.startswith("http://"):  # its page, and no port that a driver speaks to
            yield Found(one.link, f"{one.said}: announces itself; `labcal bench find {one.host}` asks its usual ports")
            continue
        yield Found(one.link, f"{one.said}: announces itself{UNASKED}", who.driver, who.kind, who.settings)


def _on_visa(clock: Clock, recognise: Recognise) -> Iterator[Found]:
    for link in resources():
        if link.upper().startswith("VISA://TCPIP"):
            yield Found(link, f"answers VISA's call on the network{UNASKED}")
        else:
            yield from asked(link, clock, recognise)
