"""What silent instruments have in common: a line, a computer, or everything. No one of them is to blame then."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.translations.translate import translated

TEXTS = (
    QT_TRANSLATE_NOOP(
        "Words", "No answer from all {0} instruments at {1}: look at their common line, not at each plug."
    ),
    QT_TRANSLATE_NOOP(
        "Words", "No answer from all {0} instruments: is the rack’s power off, or the adapter or network gone?"
    ),
    QT_TRANSLATE_NOOP(
        "Words", "No answer from {0} instruments, all {1} at {2} among them: look at that common line first."
    ),
)


def in_common(silent: Collection[str], links: Mapping[str, str]) -> str:
    """What to look at first where several are silent; "" where they have nothing in common. `links` by instrument."""
    real = {name: place_of(link) for name, link in links.items() if not link.startswith(("emulated://", "manual://"))}
    if len(real) > 1 and set(real) <= set(silent):
        hosts = {_host(place) for place in real.values()}
        return _all(len(real)) if len(hosts) > 1 else _at(hosts.pop(), len(real))
    out = set(real) & set(silent)
    for where, names in (*_groups(real, host=True), *_groups(real, host=False)):
        if len(names) > 1 and names <= out:
            return _at(where, len(names)) if names == out else _among(len(out), len(names), where)
    return ""


def _at(where: str, count: int) -> str:
    return translated("No answer from all {0} instruments at {1}: look at their common line, not at each plug.").format(
        count, where
    )


def _all(count: int) -> str:
    return translated(str(TEXTS[1])).format(count)


def _among(out: int, count: int, where: str) -> str:
    """Others are out as well: how many there are is said as the list of them has it."""
    return translated(str(TEXTS[2])).format(out, count, where)


def _groups(places: Mapping[str, str], *, host: bool) -> Iterator[tuple[str, set[str]]]:
    for where in dict.fromkeys(_host(one) if host else one for one in places.values()):
        yield where, {name for name, one in places.items() if where == (_host(one) if host else one)}


def place_of(link: str) -> str:
    """The device, or host and port."""
    return link.partition("://")[2].partition("?")[0].removeprefix("socket://")


def _host(place: str) -> str:
    """Of host:port the host; a device is a place of its own."""
    return place if place.startswith("/") else place.rpartition(":")[0] or place
