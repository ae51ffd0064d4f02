"""A window on the screen that there is: never larger than it."""

from __future__ import annotations

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QWidget

FRAME_PX = 40  # the title of a window and its edges take no more


def show_whole(window: QWidget) -> None:
    """Show it in its size; where the screen has no room for that and the title above it, over the whole screen.

    It is made smaller all the same: a desktop without a window manager makes nothing fill the screen.
    """
    there = window.screen().availableGeometry()
    room = there.size() - QSize(FRAME_PX, FRAME_PX)
    if window.size() == window.size().boundedTo(room):
        return window.show()
    if not window.isMaximized():
        window.resize(window.size().boundedTo(room))
        window.move(there.topLeft())
    return window.showMaximized()
