"""The focus stays where a person works when what has it goes away."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QWidget


@contextmanager
def focus_kept_in(holder: QWidget, *instead: QWidget) -> Iterator[None]:
    """Where what has the focus in `holder` goes away, the first of `instead` that is there gets it.

    Qt would give it to whatever is next in the window: what is typed, or scanned, then lands in the DUT's serial.
    """
    before = QApplication.focusWidget()
    yield
    if before is not None and holder.isAncestorOf(before) and QApplication.focusWidget() is not before:
        for one in instead:
            if one.isVisibleTo(holder) and one.isEnabled():
                return one.setFocus(Qt.FocusReason.OtherFocusReason)
    return None
