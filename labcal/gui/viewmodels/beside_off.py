"""Who is read while COILS OFF waits for supplies that are silent: the reference alone, which sees what nobody says."""

from __future__ import annotations

from labcal.gui.ipc.bench_facts import Bench
from labcal.gui.ipc.lab_messages import ReadLab
from labcal.gui.viewmodels.in_common import place_of
from labcal.gui.viewmodels.known_lab import ANSWERS_S


def read_beside_off(bench: str, facts: Bench | None, ordered_s: float | None, now_s: float) -> ReadLab | None:
    """Once the supplies are late, where its line is needed by nobody who is on the way to zero; None else.

    Of a simulated bench nobody is: each reading of one is of another lab.
    """
    if facts is None or facts.virtual_time or ordered_s is None or now_s - ordered_s <= ANSWERS_S:
        return None
    places = [place_of(one.link) for one in facts.instruments.values()]
    there = facts.instruments.items()
    names = tuple(n for n, one in there if one.role == "reference" and places.count(place_of(one.link)) == 1)
    return ReadLab(bench, names) if names else None
