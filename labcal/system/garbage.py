"""Garbage is collected by the thread that asks for it, not by whichever thread happens to make the next object.

A Qt object that is part of a cycle ends where the cycle is collected; in a thread that it does not belong to that may
be a segmentation fault. A process that has such objects turns the collector off, and its main thread calls this.
"""

from __future__ import annotations

import gc


def collect_if_due() -> None:
    """Collect the oldest generation that has as many new objects as Python's own thresholds allow, if one has."""
    for generation in (2, 1, 0):
        if gc.get_count()[generation] > gc.get_threshold()[generation]:
            gc.collect(generation)
            return
