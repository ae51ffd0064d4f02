"""What a run's record tells beside its rows: each interruption with what was measured again, and what people noted."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from datetime import datetime
from itertools import pairwise

from labcal.record.stream import BY, OTHER_SERIAL, PROCEDURE, RESUMED, Event, Item, Step
from labcal.record.told import Interruption, Told
from labcal.session.checks import not_measured, open_checks, results
from labcal.store import Store

UNMARKED = "offsets so far"  # how a preflight's own remarks began before they were marked as such


def told(run_id: str) -> Told:
    """Of a run in the local store; nothing of an imported one. Raises InputError where there is no such run."""
    with Store.open() as store:
        items, statuses = list(store.items(run_id, but="block", raw=False)), store.statuses(run_id)
        found = interruptions(items, statuses)
        simulated = bool(found) and store.header(run_id).simulated
    if simulated:  # stamped by its own clock, which runs ahead of the wall's and stands between two stretches
        found = [replace(one, gone_s=None, timed=False) for one in found]
    notes, remarks = notes_of(items)
    last = results(items)
    return Told(tuple(found), notes, remarks, open_checks(last), not_measured(items, last), others(items))


def interruptions(items: Iterable[Item], statuses: Sequence[tuple[str, str]]) -> list[Interruption]:
    """One for each time that the run was gone on with, by its steps; how long each lasted, by its `statuses`.

    A step that broke off again was not measured again by that.
    One that it has not been gone on with since is counted after others, without a length; alone its status says it.
    """
    stretches: list[list[str]] = [[]]
    for item in items:
        if isinstance(item, Event) and item.kind == RESUMED:
            stretches.append([])
        elif isinstance(item, Step):
            stretches[-1].append(item.name)
    gone, found, before = _gone_s(statuses), list[Interruption](), set[str]()
    whole = not statuses or statuses[-1][0] == "finished"
    for number, (broken, after) in enumerate(pairwise(stretches)):
        before |= set(broken)
        measured = after if whole and number == len(stretches) - 2 else after[:-1]
        again = tuple(dict.fromkeys(name for name in measured if name in before))
        found.append(Interruption(broken[-1] if broken else "", gone[number] if number < len(gone) else None, again))
    if found and statuses and statuses[-1][0] == "interrupted":
        found.append(Interruption(stretches[-1][-1] if stretches[-1] else "", None, (), timed=False))
    return found


def _gone_s(statuses: Sequence[tuple[str, str]]) -> list[float | None]:
    """From each status before a "running" that is not the first to that one; None after one that was killed."""
    found: list[float | None] = []
    for (before, ended), (now, again) in pairwise(statuses):
        if now == "running":
            apart = (datetime.fromisoformat(again) - datetime.fromisoformat(ended)).total_seconds()
            found.append(None if before == "running" else max(0.0, apart))
    return found


def notes_of(items: Iterable[Item]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """What people noted, and what the procedure did."""
    notes = [item for item in items if isinstance(item, Event) and item.kind == "note"]
    own = tuple(item.text for item in notes if not _of_the_procedure(item))
    return own, tuple(item.text for item in notes if _of_the_procedure(item))


def others(items: Iterable[Item]) -> tuple[str, ...]:
    """Who named another serial than was stated, once each: a run that was gone on with has asked again."""
    return tuple(dict.fromkeys(one.text for one in items if isinstance(one, Event) and one.kind == OTHER_SERIAL))


def _of_the_procedure(note: Event) -> bool:
    return note.data.get(BY) == PROCEDURE or note.text.startswith(UNMARKED)
