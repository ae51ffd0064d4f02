"""What wears a style sheet: each label, button and table its own, of the rules for its kind alone.

Qt goes through everything below a widget that is given a sheet. A sheet for a whole page holds up every key and click
meanwhile; a label with five rules takes a fifth of a millisecond.
"""

from __future__ import annotations

import re
from functools import lru_cache

from PySide6.QtWidgets import (
    QAbstractScrollArea,
    QComboBox,
    QGraphicsView,
    QScrollArea,
    QScrollBar,
    QSplitter,
    QWidget,
)
from shiboken6 import isValid

from labcal.gui.widgets.common import Words

ALWAYS = ("*", "QToolTip")
WITHIN = {  # whose rules are for what stands within a widget of this kind
    QAbstractScrollArea: ("QScrollBar", "QHeaderView"),
    QComboBox: ("QAbstractItemView", "QScrollBar", "QLineEdit"),
}


def wearers(widget: QWidget) -> list[QWidget]:
    """`widget`, or what it holds where it only holds."""
    if isinstance(widget, QScrollArea):
        within = widget.widget()
        return [] if within is None else [*wearers(within), widget.verticalScrollBar()]
    if _holds(widget):
        return [one for child in widget.children() if isinstance(child, QWidget) for one in wearers(child)]
    return [] if isinstance(widget, (QGraphicsView, Words)) else [widget]  # these know fonts and colours themselves


def bare(widget: QWidget, window: QWidget) -> bool:
    """Whether this is a wearer in `window` that nobody has dressed yet."""
    holder = widget.parentWidget()
    if holder is None or widget.window() is not window or widget.styleSheet() or isinstance(widget, QScrollBar):
        return False
    return bool(_whole(widget)) or (_holds(holder) and widget in wearers(widget))


def dress(widget: QWidget, sheet: str) -> None:
    """Put on what `sheet` says about widgets of its kind, where it is still there."""
    if isValid(widget):
        kinds = (type(widget), *_whole(widget))
        within = (
            name for kind in kinds for holder, names in WITHIN.items() if issubclass(kind, holder) for name in names
        )
        widget.setStyleSheet(
            _rules(sheet, (*ALWAYS, *within, *(one.__name__ for kind in kinds for one in kind.__mro__)))
        )


def _holds(widget: QWidget) -> bool:
    return not _whole(widget) and (widget.layout() is not None or isinstance(widget, QSplitter))


def _whole(widget: QWidget) -> tuple[type[QWidget], ...]:
    """What kinds of widgets wear what `widget` wears; none where each has its own."""
    return getattr(widget, "dressed_whole", ())


@lru_cache(maxsize=200)
def _rules(sheet: str, names: tuple[str, ...]) -> str:
    """What `sheet` says about widgets of these names."""
    rules: list[str] = re.findall(r"[^{}]+\{[^{}]*\}", sheet)
    return "".join(rule for rule in rules if {*names} & {*re.findall(r"\*|Q\w+", rule.partition("{")[0])})
