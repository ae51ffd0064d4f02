"""Runs of one DUT taken together: one after another on one clock, every segment its own."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from datetime import datetime
from functools import reduce
from typing import Any

import numpy as np
from numpy.typing import NDArray

from labcal.record.run import Channel, Run, Segment

Array = NDArray[np.float64]
GAP_S = 60.0  # between two runs, at least


def joined(runs: Sequence[Run], run_id: str) -> Run:
    """All rows of `runs` in their order, as the run `run_id`.

    A later run's clock goes on after the one before, by their starting times where those leave a gap. It was mounted
    anew: its segments and mountings get names of their own. Raises ValueError where DUT or reference are others.
    """
    return replace(reduce(_two, runs), run_id=run_id)


def _two(first: Run, second: Run) -> Run:
    _refuse_another(first, second)
    number = 2 + max((int(s.id.rpartition("#")[2]) - 1 for s in first.segments if "#" in s.id), default=0)
    segments = (*first.segments, *(_renamed(s, number) for s in second.segments))
    later: Array = second.t_s - second.t_s[0] + first.t_s[-1] + _gap_s(first, second)
    return replace(
        first,
        simulated=first.simulated or second.simulated,
        segments=segments,
        t_s=np.concatenate([first.t_s, later]),
        segment_index=np.concatenate([first.segment_index, second.segment_index + len(first.segments)]),
        reading=np.concatenate([first.reading, second.reading]),
        row_mode=np.concatenate([first.mode, second.mode]),
        channels=_channels(first, second),
        **{name: _both(first, second, name) for name in ("reference_vector", "reference_magnitude", "angle_deg")},
    )


def _refuse_another(first: Run, second: Run) -> None:
    if (first.dut.serial, first.dut.unit) != (second.dut.serial, second.dut.unit):
        raise ValueError(f"{second.run_id} is a run of {second.dut.serial}, {first.run_id} one of {first.dut.serial}")
    if first.reference.kind != second.reference.kind:
        raise ValueError(f"the reference of {second.run_id} is a {second.reference.kind}, not a {first.reference.kind}")


def _renamed(segment: Segment, number: int) -> Segment:
    mounting = segment.mounting and f"{segment.mounting}#{number}"
    return replace(segment, id=f"{segment.id}#{number}", mounting=mounting)


def _gap_s(first: Run, second: Run) -> float:
    try:
        starts = [datetime.fromisoformat(run.started_utc) for run in (first, second)]
        apart = (starts[1] - starts[0]).total_seconds()
    except (ValueError, TypeError):
        return GAP_S
    return max(apart - float(np.ptp(first.t_s)), GAP_S)


def _both(first: Run, second: Run, name: str) -> Any:
    """The rows of both; NaN where one of them has none, None where neither has."""
    parts = [getattr(run, name) for run in (first, second)]
    like = next((p for p in parts if p is not None), None)
    if like is None:
        return None
    filled = [np.full((len(r), *like.shape[1:]), np.nan) if p is None else p
              for r, p in zip((first, second), parts, strict=True)]  # fmt: skip
    return np.concatenate(filled)


def _channels(first: Run, second: Run) -> tuple[Channel, ...]:
    """Channels of either run, empty where one lacks them."""
    names = dict.fromkeys([c.name for run in (first, second) for c in run.channels])
    return tuple(_channel(first, second, name) for name in names)


def _channel(first: Run, second: Run, name: str) -> Channel:
    found = [next((c for c in run.channels if c.name == name), None) for run in (first, second)]
    like = found[0] or found[1]
    assert like is not None
    values = [np.full(len(run), np.nan) if c is None or c.unit != like.unit else c.values
              for run, c in zip((first, second), found, strict=True)]  # fmt: skip
    return replace(like, values=np.concatenate(values))
