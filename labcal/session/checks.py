"""What the checks of a run came to: the last result of each, the worst of them, and those that are open."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from labcal.record.delays import delays_open
from labcal.record.stream import Event, Item, Measurement, Step

WORST = ("", "PASS", "CANNOT DECIDE", "MARGINAL", "FAIL")


def results(items: Iterable[Item]) -> dict[str, Measurement]:
    """By its name the last result of each check: what was measured again counts as it was measured last."""
    return {item.name: item for item in items if isinstance(item, Measurement)}


def worst(found: Mapping[str, Measurement]) -> Measurement | None:
    """The worst result, whatever it is of; of several as bad a closure, and of these the largest."""
    return max(found.values(), key=lambda m: (WORST.index(m.verdict), "closure" in m.name, abs(m.value)), default=None)


def open_checks(found: Mapping[str, Measurement]) -> tuple[Measurement, ...]:
    """Those that have a limit and are no PASS, the worst first."""
    left = [one for one in found.values() if one.verdict not in ("", "PASS")]
    return tuple(sorted(left, key=lambda m: -WORST.index(m.verdict)))


def not_measured(items: Iterable[Item], found: Mapping[str, Measurement]) -> tuple[str, ...]:
    """Closures that a run was to have and has not, of an axis that was broken off and never closed; and its delays."""
    steps = [name for item in items if isinstance(item, Step) for name in item.names if name.startswith("closure-")]
    wanted = dict.fromkeys(name.replace("-", " ") for name in steps)
    return (*(name for name in wanted if name not in found), *delays_open(steps, found))


def left_out(items: Iterable[Item], found: Mapping[str, Measurement]) -> tuple[str, ...]:
    """Steps that were skipped, closures that were broken off and not repeated, and delays that no turns told."""
    items = list(items)
    skipped = (str(item.data.get("step", "")) for item in items if isinstance(item, Event) and item.kind == "skip")
    return tuple(dict.fromkeys((*skipped, *not_measured(items, found))))


def open_words(left: Iterable[Measurement], not_measured: Iterable[str]) -> tuple[str, ...]:
    """One sentence each, for a certificate."""
    judged = (
        f"Open in the run itself, {one.verdict}: {one.name} {one.value:+.4g} ± {2 * one.u:.2g} {one.unit} (k = 2), "
        f"limit {one.limit:g}."
        for one in left
    )
    return (*judged, *(f"Not measured in the run: {name}." for name in not_measured))
