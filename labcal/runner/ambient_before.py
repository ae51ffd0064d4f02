"""The ambient field that a run had measured before it was interrupted: a witness of its zero at Go on."""

from __future__ import annotations

from collections.abc import Iterable
from datetime import datetime

import numpy as np

from labcal.bench.bench import Bench
from labcal.bench.coils.before_hands import BeforeHands
from labcal.record import RunHeader
from labcal.record.stream import Item, Measurement

ZERO = tuple(f"zero: ref_{axis}" for axis in "xyz")  # as `measure_ambient` writes it down


def remember_ambient(bench: Bench, header: RunHeader, before: Iterable[Item]) -> None:
    """Give the bench what the reference saw at the last zero of a run's record, with its age.

    Who has had hands at the DUT meanwhile nobody knows: it judges a zero by the rule of a mounting, and no current.
    The record's time stands still while a run is interrupted: the age is never taken for less than it is.
    """
    if (found := last_zero(before)) is None:
        return
    field_nT, t_s = found
    since_s = (bench.clock.utc() - datetime.fromisoformat(header.started_utc)).total_seconds()
    bench.cage.check.remember(BeforeHands(field_nT, bench.clock.now() - max(0.0, since_s - t_s)))


def last_zero(items: Iterable[Item]) -> tuple[np.ndarray, float] | None:
    """The field (3,) [nT, C] of the last whole zero of a vector reference, and when on the record's clock [s]."""
    seen, found = dict[str, float](), None
    for item in items:
        if isinstance(item, Measurement) and item.name in ZERO:
            seen = {**seen, item.name: item.value} if item.name != ZERO[0] else {item.name: item.value}
            found = (np.array(list(seen.values())), item.t_s) if tuple(seen) == ZERO else found
    return found
