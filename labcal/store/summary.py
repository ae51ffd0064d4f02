"""What a run is, in one look: its head, its segments and what each offers, its channels."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict
from typing import Any

import numpy as np
from numpy.typing import NDArray

from labcal.record import Run, RunHeader, Segment, offers, period_s
from labcal.record.stream import Item, Measurement
from labcal.store.chain import Chain
from labcal.store.run_json import stated_specification

Array = NDArray[np.float64]


def describe(
    run: Run,
    status: str,
    header: RunHeader | None = None,
    items: Iterable[Item] = (),
    origin: Chain | None = None,
) -> dict[str, Any]:
    """The run as JSON: finite numbers only. `header` and `items` are there for what was recorded here.

    `chain` is the head of its hash chain; None where its origin is not shown.
    """
    entry: dict[str, Any] = {
        "run_id": run.run_id,
        "status": status,
        "chain": None if origin is None else origin.stated(),
        "started_utc": run.started_utc,
        "simulated": run.simulated,
        "operator": run.operator,
        "dut": asdict(run.dut),
        "reference": {key: value for key, value in asdict(run.reference).items() if value is not None},
        "n_samples": len(run),
        "span_s": [float(run.t_s[0]), float(run.t_s[-1])] if len(run) else None,
        "segments": _segments(run),
        "channels": [
            {"name": c.name, "unit": c.unit, "quantity": c.quantity, "role": c.role, "range": _range(c.values)}
            for c in run.channels
        ],
    }
    if run.specification is not None:
        entry["specification"] = stated_specification(run.specification)
    if header is not None:
        entry["procedure"] = {
            "name": header.procedure,
            "parameters": header.parameters,
            "source_sha256": header.source_sha256,
            "software": header.software,
        }
        entry["instruments"] = header.instruments
        entry["measurements"] = [_measurement(item) for item in items if isinstance(item, Measurement)]
    return entry


def _segments(run: Run) -> list[dict[str, Any]]:
    """Each segment's line. What is worked out of all rows is so once: a field held for a day has 45 000 segments."""
    order = np.argsort(run.segment_index, kind="stable")
    ends = np.searchsorted(run.segment_index[order], np.arange(len(run.segments) + 1))
    mode, magnitude = run.mode, None if run.reference.kind == "none" else run.magnitude_nT
    return [
        _segment(run, segment, order[ends[index] : ends[index + 1]], mode, magnitude)
        for index, segment in enumerate(run.segments)
    ]


def _segment(
    run: Run, segment: Segment, rows: NDArray[np.intp], mode: NDArray[np.str_], magnitude: Array | None
) -> dict[str, Any]:
    t = run.t_s[rows]
    return {
        "id": segment.id,
        "kind": segment.kind,
        "offers": offers(run, segment),
        "modes": sorted({str(one) for one in np.unique(mode[rows])} - {""}),
        "n_samples": len(rows),
        "duration_s": float(t[-1] - t[0]) if len(t) else 0.0,
        "rate_Hz": _rate_Hz(t),
        "missing": int((~np.isfinite(run.reading[rows]).all(axis=1)).sum()),
        "magnitude_nT": None if magnitude is None else _range(magnitude[rows]),
        "note": segment.note,
    }


def _rate_Hz(t: Array) -> float | None:
    period = period_s(t)
    return 1 / period if np.isfinite(period) else None


def _range(values: Array) -> list[float] | None:
    there = values[np.isfinite(values)]
    return [float(there.min()), float(there.max())] if len(there) else None


def _measurement(item: Measurement) -> dict[str, Any]:
    entry = {**asdict(item), "verdict": item.verdict}
    return {key: None if isinstance(value, float) and not np.isfinite(value) else value for key, value in entry.items()}
