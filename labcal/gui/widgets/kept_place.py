"""A page stays where it is rolled while what has the focus is hidden: Qt would roll to what comes next."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from PySide6.QtWidgets import QScrollArea, QWidget


@contextmanager
def place_kept(within: QWidget) -> Iterator[None]:
    """How far the area that `within` stands in is rolled."""
    holder = within.parentWidget()
    while holder is not None and not isinstance(holder, QScrollArea):
        holder = holder.parentWidget()
    at = 0 if holder is None else holder.verticalScrollBar().value()
    try:
        yield
    finally:
        if holder is not None:
            holder.verticalScrollBar().setValue(at)
