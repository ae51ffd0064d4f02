"""The few building blocks that every page uses: cards, captions, buttons, a column of aligned numbers."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from html import escape
from typing import TypeVar

from PySide6.QtCore import QRect, QRectF, QSize, Qt
from PySide6.QtGui import QFont, QFontMetrics, QPainter, QPaintEvent, QPalette, QPen, QResizeEvent
from PySide6.QtWidgets import (
    QComboBox,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSizePolicy,
    QStackedWidget,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionComboBox,
    QStylePainter,
    QVBoxLayout,
    QWidget,
)

from labcal.gui.theming.font import with_tabular_figures
from labcal.gui.theming.theme import GRID
from labcal.gui.translations.translate import translated
from labcal.gui.widgets.steady_button import SteadyButton

W = TypeVar("W", bound=QWidget)
ROUND_PX = 6
SIDES = (Qt.Edge.LeftEdge, Qt.Edge.TopEdge, Qt.Edge.RightEdge, Qt.Edge.BottomEdge)
LARGEST_PT, SMALLEST_PT = 54, 13  # words that are as large as their place allows, to be read from the cage


def named(widget: W, name: str) -> W:
    """`widget` with the name that the style sheet knows it by."""
    widget.setObjectName(name)
    return widget


def label(text: str = "", name: str = "", *, wrap: bool = False) -> QLabel:
    """A text; `name` is its style: title, caption, large, simulated."""
    widget = QLabel()
    widget.setTextFormat(Qt.TextFormat.PlainText)  # nothing that was typed is ever markup
    widget.setText(text)
    widget.setObjectName(name)
    widget.setWordWrap(wrap)
    widget.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    widget.setFocusPolicy(Qt.FocusPolicy.NoFocus)
    return widget


def plain(text: str) -> str:
    """`text` for a tool tip, which Qt would read as markup where it looks like that."""
    return f"<qt>{escape(text).replace(chr(10), '<br>')}</qt>" if "<" in text else text


def shrinkable(widget: W) -> W:
    """`widget` with its text cut off where there is no room: a long sentence widens no window."""
    widget.setMinimumWidth(1)
    return widget


class Chooser(QComboBox):
    """A list to choose from; what there is no room for ends in dots."""

    def paintEvent(self, event: QPaintEvent) -> None:
        """As Qt does, with the text as long as its place."""
        option = QStyleOptionComboBox()
        self.initStyleOption(option)
        if self.currentIndex() < 0 and self.placeholderText():
            option.palette.setBrush(QPalette.ColorRole.ButtonText, option.palette.placeholderText())
            option.currentText = self.placeholderText()
        kind, part = QStyle.ComplexControl.CC_ComboBox, QStyle.SubControl.SC_ComboBoxEditField
        width = self.style().subControlRect(kind, option, part, self).width() - 2
        option.currentText = self.fontMetrics().elidedText(option.currentText, Qt.TextElideMode.ElideRight, width)
        painter = QStylePainter(self)
        painter.drawComplexControl(kind, option)
        painter.drawControl(QStyle.ControlElement.CE_ComboBoxLabel, option)
        painter.end()


def combo_box(tip: str, name: str = "", *, letters: int = 12) -> QComboBox:
    """A list to choose from, as wide as it may be and no wider than `letters` where there is no room."""
    widget = Chooser()
    widget.setToolTip(tip)
    widget.setAccessibleName(name or tip)
    widget.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
    widget.setMinimumContentsLength(letters)
    widget.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
    widget.setItemDelegate(QStyledItemDelegate(widget))  # Qt's own knows nothing of the style sheet
    return widget


def offer(chooser: QComboBox, names: Sequence[str], words: Callable[[str], str] = translated) -> None:
    """Have these to choose from, each shown by its `words` in the window's language, its name as data."""
    if [chooser.itemData(n) for n in range(chooser.count())] != list(names):
        chooser.clear()
        for name in names:
            chooser.addItem(words(name), name)


def say_wanted(chooser: QComboBox, wanted: str) -> None:
    """Say in an editable chooser what belongs there."""
    if (line := chooser.lineEdit()) is not None:
        line.setPlaceholderText(wanted)


def button(text: str, tip: str, *, primary: bool = False) -> QPushButton:
    """A push button; `primary` is the one thing to do on a page."""
    widget = SteadyButton(text)
    widget.setToolTip(tip)
    widget.setObjectName("primary" if primary else "")
    widget.setAutoDefault(False)
    return widget


def set_primary(widget: QPushButton, primary: bool) -> None:
    """Make a button the one thing to do, or one of several."""
    rename(widget, "primary" if primary else "")


def rename(widget: QWidget, name: str) -> None:
    """Give a widget that is shown already another style by its name."""
    if name != widget.objectName():
        widget.setObjectName(name)
        widget.style().unpolish(widget)
        widget.style().polish(widget)


def set_state(widget: QWidget, state: str) -> None:
    """Colour a label by state: good, warning, bad, old (grey) or ""."""
    if (widget.property("state") or "") != state:
        widget.setProperty("state", state)
        widget.style().unpolish(widget)
        widget.style().polish(widget)


def flat(widget: W) -> W:
    """`widget` no taller than what is in it."""
    widget.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Maximum)
    return widget


@contextmanager
def deferred_layout(*holders: QWidget) -> Iterator[None]:
    """Show and hide what these hold; their places are found once, in an event of its own, not anew after each.

    What never had a place has no size until then: Qt's own 640 by 480 would be painted over all else.
    """
    layouts = [layout for one in holders if (layout := one.layout()) is not None]
    for layout in layouts:
        layout.setEnabled(False)
    for child in (child for one in holders for child in one.children() if isinstance(child, QWidget)):
        if not child.testAttribute(Qt.WidgetAttribute.WA_Resized):
            child.resize(0, 0)
    try:
        yield
    finally:
        for layout in layouts:
            layout.setEnabled(True)


class Surface(QWidget):
    """What cards and bars stand on: the palette's base, with an edge all around, or at `side` alone.

    It is painted, not styled: Qt goes through whatever has a style sheet with all that stands on it.
    """

    edge, width_px = QPalette.ColorRole.Mid, 1

    def __init__(self, side: Qt.Edge | None = None) -> None:
        super().__init__()
        self._side = side
        if side is not None:
            self.setContentsMargins(*(int(side == one) for one in SIDES))

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint."""
        within, palette, inset = QRectF(self.contentsRect()), self.palette(), self.width_px / 2
        with QPainter(self) as painter:
            if self._side is not None:
                painter.fillRect(self.rect(), palette.color(self.edge))
                painter.fillRect(within, palette.base())
                return
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setBrush(palette.base())
            painter.setPen(QPen(palette.color(self.edge), self.width_px))
            painter.drawRoundedRect(within.adjusted(inset, inset, -inset, -inset), ROUND_PX, ROUND_PX)


class Card(Surface):
    """A titled surface; add to `body`."""

    def __init__(self, title: str = "", unit: str = "") -> None:
        super().__init__()
        outer = QVBoxLayout(self)
        outer.setContentsMargins(2 * GRID, 2 * GRID, 2 * GRID, 2 * GRID)
        outer.setSpacing(GRID)
        self.heading = named(OneLine(), "title")
        self.heading.setText(title)
        self.unit = label(unit, "caption")
        self.head = QHBoxLayout()
        self.head.addWidget(self.heading, 1)
        self.head.addWidget(self.unit)
        if title or unit:
            outer.addLayout(self.head)
        self.body = QVBoxLayout()
        self.body.setSpacing(GRID)
        outer.addLayout(self.body, 1)


def tabular_font() -> QFont:
    """The interface's font with figures of one width."""
    return with_tabular_figures(QFont())


class ReadoutGrid(QWidget):
    """Rows of name and value, right-aligned in tabular figures."""

    def __init__(self, names: tuple[str, ...]) -> None:
        super().__init__()
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(GRID)
        grid.setVerticalSpacing(GRID // 2)
        self.values = [label("–") for _ in names]
        self._names = [label(translated(name), "caption") for name in names]
        for row, name in enumerate(self._names):
            grid.addWidget(name, row, 0)
            grid.addWidget(self.values[row], row, 1)
            self.values[row].setAlignment(Qt.AlignmentFlag.AlignRight)
            self.values[row].setFont(tabular_font())
        grid.setColumnStretch(1, 1)

    def show_row(self, row: int, value: str, state: str = "") -> None:
        """Write one row; "–" stands for what is not known. `state` colours it: "old" is grey."""
        self.values[row].setText(value)
        set_state(self.values[row], state)

    def blank(self) -> None:
        """No row says anything."""
        for row in range(len(self.values)):
            self.show_row(row, "–")

    def keep_row(self, row: int, *, shown: bool) -> None:
        """Whether this row is there at all."""
        for part in (self._names[row], self.values[row]):
            part.setVisible(shown)


class FaceStack(QStackedWidget):
    """As small as the face in sight can be: what another one once showed makes no page wider than its place."""

    def __init__(self) -> None:
        super().__init__()
        self.currentChanged.connect(lambda: self.updateGeometry())

    def minimumSizeHint(self) -> QSize:
        """Of the face in sight."""
        face = self.currentWidget()
        return QSize() if face is None else face.minimumSizeHint().expandedTo(face.minimumSize())

    def hasHeightForWidth(self) -> bool:
        """Qt would ask for the height of the highest face, and cut what stands beside this for one out of sight."""
        return False


class WholeWords(QLabel):
    """In short beside what says the rest; `text()`, and what is read aloud, is always the whole."""

    def __init__(self) -> None:
        super().__init__()
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setWordWrap(True)
        self.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._whole = ""

    def say(self, whole: str, shown: str) -> None:
        """Write `shown` for `whole`."""
        self._whole = whole
        self.setAccessibleName(whole)
        if shown != super().text():
            self.setText(shown)

    def text(self) -> str:
        """The whole."""
        return self._whole


class OneLine(QLabel):
    """A sentence that ends in dots where there is no room for it; `text()` is always the whole."""

    def __init__(self) -> None:
        super().__init__()
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setMinimumWidth(1)

    def is_cut(self) -> bool:
        """Whether there is no room for all of it."""
        return self.fontMetrics().horizontalAdvance(self.text()) > self.contentsRect().width()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint, and over the end of what is cut the dots."""
        super().paintEvent(event)
        if self.is_cut():
            dots = self.contentsRect()
            dots.setLeft(dots.right() - self.fontMetrics().horizontalAdvance("…"))
            with QPainter(self) as painter:
                painter.fillRect(dots, self.window().palette().base())
                painter.drawText(dots, Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignRight, "…")


class AutoSizeLabel(QLabel):
    """A text as large as its place allows, which has nothing to say about how large that is."""

    styles_itself = True  # its font is its own: no style sheet is put on it

    def __init__(self, largest_pt: int = LARGEST_PT) -> None:
        super().__init__()
        self._largest_pt = largest_pt
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setWordWrap(True)
        self.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Ignored)
        self._pt = 0

    def set_text(self, text: str) -> None:
        """Write `text`."""
        if text != self.text():
            self.setText(text)
            self._enlarge()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """The place is another."""
        super().resizeEvent(event)
        self._enlarge()

    def heightForWidth(self, width: int) -> int:
        """In its smallest letters: with less room it shrinks, before anything beside it is cut."""
        return self._needed(SMALLEST_PT, width).height()

    def _enlarge(self) -> None:
        sizes = range(SMALLEST_PT + 1, self._largest_pt + 1)
        fitting = SMALLEST_PT + bisect_left(sizes, True, key=lambda pt: not self._fits(pt))
        if fitting != self._pt:
            self._pt = fitting
            self.setFont(self._font(fitting))

    def _font(self, pt: int) -> QFont:
        font = QFont(self.font())
        font.setPointSize(pt)
        font.setWeight(QFont.Weight.DemiBold)
        return font

    def _fits(self, pt: int) -> bool:
        place = self.contentsRect()
        needed = self._needed(pt, place.width())
        return needed.height() <= place.height() and needed.width() <= place.width()

    def _needed(self, pt: int, width: int) -> QRect:
        room = QRect(0, 0, width, 10_000)
        return QFontMetrics(self._font(pt)).boundingRect(room, int(Qt.TextFlag.TextWordWrap), self.text())
