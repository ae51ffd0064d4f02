"""A style sheet for each label, button and table of its own, with the rules for its kind alone.

Qt goes through everything below a widget that is given a sheet. A sheet for a whole page holds up every key and click
meanwhile; a label with five rules takes a fifth of a millisecond.
"""

from __future__ import annotations

import re
from functools import lru_cache
from itertools import chain

from PySide6.QtCore import QEvent
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

COMES_UP = QEvent.Type.Polish, QEvent.Type.Show  # what is polished in a page that is built is shown in the window later
GLOBAL_SELECTORS = ("*", "QToolTip")
CHILD_SELECTORS = {  # whose rules are for what stands within a widget of this kind
    QAbstractScrollArea: ("QScrollBar", "QHeaderView"),
    QComboBox: ("QAbstractItemView", "QScrollBar", "QLineEdit"),
}


def styled_widgets(widget: QWidget) -> list[QWidget]:
    """`widget`, or what it holds where it only holds."""
    if isinstance(widget, QScrollArea):
        within = widget.widget()
        return [*([] if within is None else styled_widgets(within)), widget.verticalScrollBar()]
    if _holds(widget):
        return [one for child in widget.children() if isinstance(child, QWidget) for one in styled_widgets(child)]
    styles_itself = isinstance(widget, QGraphicsView) or getattr(widget, "styles_itself", False)
    return [] if styles_itself else [widget]


def is_unstyled(widget: QWidget, window: QWidget) -> bool:
    """Whether this is to have a style sheet in `window` and has none yet."""
    holder = widget.parentWidget()
    if holder is None or widget.window() is not window or widget.styleSheet() or isinstance(widget, QScrollBar):
        return False
    return bool(_whole(widget)) or (_holds(holder) and not _holds(widget) and widget in styled_widgets(widget))


def apply_style(widget: QWidget, sheet: str) -> None:
    """Give `widget` what `sheet` says about widgets of its kind, where it is still there."""
    if isValid(widget):
        kinds = (type(widget), *_whole(widget))
        children = (names for kind in kinds for holder, names in CHILD_SELECTORS.items() if issubclass(kind, holder))
        own = (one.__name__ for kind in kinds for one in kind.__mro__)
        widget.setStyleSheet(_rules(sheet, (*GLOBAL_SELECTORS, *chain(*children), *own)))


def _holds(widget: QWidget) -> bool:
    return not _whole(widget) and (widget.layout() is not None or isinstance(widget, QSplitter))


def _whole(widget: QWidget) -> tuple[type[QWidget], ...]:
    """The kinds of widgets within `widget` that its sheet is for; none where each has its own."""
    return getattr(widget, "styled_as_whole", ())


@lru_cache(maxsize=200)
def _rules(sheet: str, names: tuple[str, ...]) -> str:
    """What `sheet` says about widgets of these names."""
    rules: list[str] = re.findall(r"[^{}]+\{[^{}]*\}", sheet)
    return "".join(rule for rule in rules if {*names} & {*re.findall(r"\*|Q\w+", rule.partition("{")[0])})
