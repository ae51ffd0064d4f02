"""What wears a style sheet: each label, button and table its own, of the rules for its kind alone.

Qt goes through everything below a widget that is given a sheet. A sheet for a whole page holds up every key and click
meanwhile; a label with five rules takes a fifth of a millisecond.
"""

from __future__ import annotations

import re
from functools import lru_cache

from PySide6.QtCore import QEvent, QObject
from PySide6.QtWidgets import (
    QAbstractScrollArea,
    QComboBox,
    QGraphicsView,
    QScrollArea,
    QScrollBar,
    QSplitter,
    QSplitterHandle,
    QWidget,
)
from shiboken6 import isValid

from labcal.gui.widgets import Words

ALWAYS = ("*", "QToolTip")
WITHIN = {  # whose rules are for what stands within a widget of this kind
    QAbstractScrollArea: ("QScrollBar", "QHeaderView"),
    QComboBox: ("QAbstractItemView", "QScrollBar", "QLineEdit"),
    QSplitterHandle: ("QSplitter",),
}


def wearers(widget: QWidget) -> list[QWidget]:
    """`widget`, or what it holds where it only holds."""
    if isinstance(widget, QScrollArea):
        within = widget.widget()
        return [] if within is None else [*wearers(within), widget.verticalScrollBar()]
    if _holds(widget):
        return [one for child in widget.children() if isinstance(child, QWidget) for one in wearers(child)]
    return [] if isinstance(widget, (QGraphicsView, Words)) else [widget]  # these know fonts and colours themselves


def comes_up_bare(watched: QObject, event: QEvent) -> bool:
    """Whether this is the moment before a wearer is first seen, and nobody has dressed it."""
    if event.type() != QEvent.Type.Polish or not isinstance(watched, QWidget) or watched.styleSheet():
        return False
    holder = watched.parentWidget()
    return holder is not None and _holds(holder) and not isinstance(watched, QScrollBar) and watched in wearers(watched)


def dress(widget: QWidget, sheet: str) -> None:
    """Put on what `sheet` says about widgets of its kind, where it is still there."""
    if isValid(widget):
        within = (name for holder, names in WITHIN.items() if isinstance(widget, holder) for name in names)
        names = (*ALWAYS, *within, *(one.__name__ for one in type(widget).__mro__))
        widget.setStyleSheet(sheet if _whole(widget) else _rules(sheet, names))


def _holds(widget: QWidget) -> bool:
    return not _whole(widget) and (widget.layout() is not None or isinstance(widget, QSplitter))


def _whole(widget: QWidget) -> bool:
    return getattr(widget, "dressed_whole", False)


@lru_cache(maxsize=200)
def _rules(sheet: str, names: tuple[str, ...]) -> str:
    """What `sheet` says about widgets of these names."""
    rules: list[str] = re.findall(r"[^{}]+\{[^{}]*\}", sheet)
    return "".join(rule for rule in rules if {*names} & {*re.findall(r"\*|Q\w+", rule.partition("{")[0])})
