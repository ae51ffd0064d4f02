"""What of a window cannot be read, found by geometry: texts that are cut, and parts that lie over each other."""

from __future__ import annotations

import time
from itertools import combinations

import pyqtgraph as pg
from PySide6.QtCore import QPoint, QRect, QRectF, Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractScrollArea,
    QApplication,
    QComboBox,
    QGraphicsTextItem,
    QLabel,
    QLineEdit,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from labcal.gui.widgets.common import AutoSizeLabel, Card, plain
from labcal.gui.widgets.deferred_repaint import Ground
from labcal.gui.widgets.mounting_view import Mounting
from labcal.gui.widgets.over_page import OVER

SLACK_PX = 1
KINDS = (QLabel, QAbstractButton, QLineEdit, QComboBox)
WRAP = int(Qt.TextFlag.TextWordWrap)


def faults(window: QWidget) -> list[str]:
    """Every text of `window` in sight that is cut, and every two that overlap, in words."""
    _come_to_rest(window)
    parts = [one for one in window.findChildren(QWidget) if isinstance(one, KINDS) and _in_sight(one)]
    found = [f"{_named(one)} {what}" for one in parts if (what := _cut(one))]
    places = [(one, _place(one, window)) for one in parts]
    for (one, place), (other, its) in combinations(places, 2):
        lies = place.intersected(its).adjusted(SLACK_PX, SLACK_PX, -SLACK_PX, -SLACK_PX)
        if (
            lies.isValid()
            and _over_page(one) is _over_page(other)
            and not one.isAncestorOf(other)
            and not other.isAncestorOf(one)
        ):
            found.append(f"{_named(one)} and {_named(other)} lie over each other by {lies.width()} x {lies.height()}")
    return found + [fault for kind, look in PAINTED.items() for one in _seen(window, kind) for fault in look(one)]


def _come_to_rest(window: QWidget) -> None:
    """Plots that are to be drawn anew are blank until then: nothing in them would be found."""
    until_s = time.monotonic() + 2.0
    while any(ground.isVisible() for ground in window.findChildren(Ground)) and time.monotonic() < until_s:
        QApplication.processEvents()
        time.sleep(0.002)


def _over_page(part: QWidget | None) -> bool:
    """Whether it is on a card that covers a part of the page."""
    while part is not None and not part.property(OVER):
        part = part.parentWidget()
    return part is not None


def _seen(window: QWidget, kind: type[QWidget]) -> list[QWidget]:
    """Those in sight; what scrolls is covered by the port that it is seen through."""
    ports = [
        (one, one.viewport() if isinstance(one, QAbstractScrollArea) else one) for one in window.findChildren(kind)
    ]
    return [one for one, port in ports if port.isVisible() and not port.visibleRegion().isEmpty()]


def _of_plot(plot: pg.PlotWidget) -> list[str]:
    """Names of axes, and the legend above, that reach out of their plot: no widget holds these, they are painted."""
    item = plot.getPlotItem()
    names = [axis["item"].label for axis in item.axes.values() if axis["item"].isVisible()]
    texts = [one for one in (*names, item.titleLabel.item) if one.isVisible() and one.toPlainText().strip()]
    room = QRectF(plot.rect().adjusted(-SLACK_PX, -SLACK_PX, SLACK_PX, SLACK_PX))
    return [
        f"{one.toPlainText()!r} reaches out of its plot: {_inner(plot, one)} of {plot.rect()}"
        for one in texts
        if not room.contains(_inner(plot, one))
    ]


def _inner(plot: pg.PlotWidget, text: QGraphicsTextItem) -> QRectF:
    margin = text.document().documentMargin()
    letters = text.boundingRect().adjusted(margin, margin, -margin, -margin)
    return QRectF(plot.mapFromScene(text.mapToScene(letters)).boundingRect())


def _of_mounting(drawing: Mounting) -> list[str]:
    """Names of axes that lie over each other in the drawing."""
    pairs = combinations(drawing.names.items(), 2)
    return [f"{a!r} and {b!r} lie over each other" for (a, place), (b, other) in pairs if place.intersects(other)]


def _of_table(table: QTableWidget) -> list[str]:
    """Cells that are cut: one without its whole in a tip, or, where words are wrapped, at all."""
    cells = (table.item(row, column) for row in range(table.rowCount()) for column in range(table.columnCount()))
    return [f"cell {cell.text()!r} is cut" for cell in cells if cell is not None and _cell_is_cut(table, cell)]


def _cell_is_cut(table: QTableWidget, cell: QTableWidgetItem) -> bool:
    if not cell.text() or (not table.wordWrap() and cell.text() in cell.toolTip()):
        return False
    hint, metrics = table.sizeHintForIndex(table.indexFromItem(cell)), table.fontMetrics()
    around, width = hint.width() - metrics.horizontalAdvance(cell.text()), table.columnWidth(cell.column())
    if hint.width() <= width + SLACK_PX or not table.wordWrap():
        return hint.width() > width + SLACK_PX
    lines = metrics.boundingRect(QRect(0, 0, max(1, width - around), 0), WRAP, cell.text())
    return lines.height() > table.rowHeight(cell.row()) + SLACK_PX


PAINTED = {pg.PlotWidget: _of_plot, Mounting: _of_mounting, QTableWidget: _of_table}


def _in_sight(one: QWidget) -> bool:
    text = _text(one)
    own = isinstance(one, QLineEdit) and isinstance(one.parent(), QComboBox)  # its chooser says it
    return bool(text) and one.isVisible() and not own and not one.visibleRegion().isEmpty()


def _cut(one: QWidget) -> str:
    """How a text is cut; "" where it is whole, or rolls into sight, or its whole is in its tip.

    What is read from the cage has to be whole: nobody there opens a tip.
    """
    if one.visibleRegion().boundingRect() != one.rect() and not _rolls(one):
        return f"is cut by what holds it: {_size(one.visibleRegion().boundingRect())} of {_size(one.rect())} are seen"
    room, needed = _room(one), _needed(one)
    if needed.width() <= room.width() + SLACK_PX and needed.height() <= room.height() + SLACK_PX:
        return ""
    if (not isinstance(one, AutoSizeLabel) and _text(one) in one.toolTip()) or plain(_text(one)) in one.toolTip():
        return ""
    return f"needs {_size(needed)} and has {_size(room)}"


def _room(one: QWidget) -> QRect:
    return one.contentsRect() if isinstance(one, QLabel) else one.rect()


def _needed(one: QWidget) -> QRect:
    """The place that its text needs, of a wrapped one at its width."""
    if isinstance(one, QLabel):
        if one.textFormat() != Qt.TextFormat.PlainText:
            return QRect(QPoint(), one.minimumSizeHint())
        width = one.contentsRect().width() if one.wordWrap() else 100_000
        lines = one.fontMetrics().boundingRect(
            QRect(0, 0, width, 100_000), WRAP if one.wordWrap() else 0, QLabel.text(one)
        )
        return QRect(0, 0, lines.width(), lines.height() - one.fontMetrics().leading())
    if isinstance(one, QLineEdit):
        frame = one.sizeHint().height() - one.fontMetrics().height()
        return QRect(0, 0, one.fontMetrics().horizontalAdvance(_text(one)) + frame, one.minimumSizeHint().height())
    if isinstance(one, QComboBox):
        return QRect(0, 0, 0, one.minimumSizeHint().height())  # its list says the whole
    return QRect(QPoint(), one.sizeHint())


def run_over(page: QWidget) -> list[QWidget]:
    """Whatever in a card reaches out of it: lists, tables and pictures too, which have no one text to be measured."""
    cards = [card for card in page.findChildren(Card) if card.isVisible()]
    parts = ((card, one) for card in cards for one in card.children() if isinstance(one, QWidget) and one.isVisible())
    return [one for card, one in parts if not card.rect().contains(one.geometry())]


def _rolls(one: QWidget) -> bool:
    """Whether it stands in what can be scrolled."""
    holder = one.parentWidget()
    while holder is not None and not isinstance(holder, QAbstractScrollArea):
        holder = holder.parentWidget()
    return holder is not None


def _place(one: QWidget, window: QWidget) -> QRect:
    seen = one.visibleRegion().boundingRect()
    return QRect(one.mapTo(window, seen.topLeft()), seen.size())


def _text(one: QWidget) -> str:
    """What stands there, or what says what is wanted there."""
    if isinstance(one, QComboBox):
        return one.currentText()
    return one.text() or (one.placeholderText() if isinstance(one, QLineEdit) else "")


def _named(one: QWidget) -> str:
    return f"{type(one).__name__} {_text(one)[:50]!r}"


def _size(rect: QRect) -> str:
    return f"{rect.width()} x {rect.height()}"
