"""The letters of the window: the system's own, or where nobody chose any, the best of those that are there."""

from __future__ import annotations

from collections.abc import Collection

from PySide6.QtGui import QFont

NOBODY_CHOSE = ("", "Sans", "Sans Serif", "sans-serif")  # what Qt says on a system without a choice
PREFERRED = ("Inter", "Inter Variable")  # lines of others (Noto Sans) are higher: less is in sight


def with_tabular_figures(font: QFont) -> QFont:
    """`font` with figures of one width, where it has such: nothing jumps when a digit changes."""
    tabular = QFont(font)
    tabular.setFeature(QFont.Tag("tnum"), 1)
    return tabular


def interface_font(system: QFont, there: Collection[str]) -> QFont:
    """The `system`'s font, or the first of `PREFERRED` that is `there`; with figures of one width."""
    font = with_tabular_figures(system)
    if system.family() in NOBODY_CHOSE and (best := next((name for name in PREFERRED if name in there), "")):
        font.setFamily(best)
    return font
