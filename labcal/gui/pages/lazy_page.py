"""A page's place in the window: built when it is wanted, a part at a time; a card where it cannot be built."""

from __future__ import annotations

import gc
import time
import traceback
from collections.abc import Callable, Iterator
from functools import partial
from importlib.metadata import EntryPoint

from PySide6.QtCore import QEvent, QSize, Qt, Signal
from PySide6.QtGui import QResizeEvent, QShowEvent
from PySide6.QtWidgets import QScrollArea, QVBoxLayout, QWidget

from labcal.errors import InputError
from labcal.gui.ipc.wire import Fault
from labcal.gui.pages.registry import Themed, build_more, build_page
from labcal.gui.theming.stylesheet import apply_style, styled_widgets
from labcal.gui.theming.theme import GRID, Theme
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.widgets.common import Card, flat, label
from labcal.gui.widgets.fault_card import FaultCard
from labcal.gui.widgets.idle_queue import TIME_SLICE_S


class Place(QWidget):
    """As large as what can be seen, and no smaller than the page in it can be.

    Put into the area itself, a page with wrapped texts would get the height that it would like to have, and would
    scroll where it needs less. One that only shows (`shows_only`) gets that height: nothing in it can give way.
    The bar of `area` stands in the margin at the right of the page: cards are as wide with it as without.
    """

    def __init__(self, area: QScrollArea) -> None:
        super().__init__()
        self._area = area
        self._page: QWidget | None = None

    def hold(self, page: QWidget) -> None:
        """Put the page here."""
        self._page = page
        policy = self.sizePolicy()
        policy.setHeightForWidth(getattr(page, "shows_only", False))
        self.setSizePolicy(policy)
        page.setParent(self)
        self._fit()
        page.show()
        self.updateGeometry()

    def minimumSizeHint(self) -> QSize:
        """Of the page."""
        return QSize() if self._page is None else self._page.minimumSizeHint()

    def heightForWidth(self, width: int) -> int:
        """What the page would like to have at this width, with the lines of its wrapped texts."""
        layout = None if self._page is None else self._page.layout()
        return self.minimumSizeHint().height() if layout is None else layout.totalHeightForWidth(self._wide(width))

    def _wide(self, width: int) -> int:
        """How wide the page is in a place of this `width`: what a bar takes is taken from its margin."""
        layout = None if self._page is None else self._page.layout()
        margin = 0 if layout is None else layout.contentsMargins().right()
        return width + max(0, min(margin, self._area.width() - width))

    def _fit(self) -> None:
        if self._page is not None:
            self._page.resize(self._wide(self.width()), self.height())

    def event(self, event: QEvent) -> bool:
        """The page needs another place."""
        if event.type() == QEvent.Type.LayoutRequest:
            self.updateGeometry()
        return super().event(event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Another size, for the page too."""
        self._fit()


class LazyPage(QWidget):
    """The page that `entry` names, built when it is first seen: the window is up before the plots are.

    Where a small window has no room for all of it, it can be scrolled: nothing of it is cut off.
    """

    wanted = Signal()  # it is in sight, and not yet built

    def __init__(
        self, entry: EntryPoint, app_state: AppState, theme: Callable[[], Theme], sheet: Callable[[], str]
    ) -> None:
        super().__init__()
        self.entry, self._app_state, self._theme, self._sheet = entry, app_state, theme, sheet
        self._parts = self._in_parts()
        self._column = QVBoxLayout(self)
        self._column.setContentsMargins(0, 0, 0, 0)
        self.page: QWidget | None = None
        self.area = QScrollArea()
        self.area.setWidgetResizable(True)
        self.area.setFocusPolicy(Qt.FocusPolicy.NoFocus)  # what has the focus comes into sight by itself
        self.area.setFrameShape(QScrollArea.Shape.NoFrame)
        self.area.viewport().setAutoFillBackground(False)
        self.place = Place(self.area)
        self.area.setWidget(self.place)
        self.place.setAutoFillBackground(False)
        self.coming = label(self.tr("This page is being made ready …"))
        self._column.addWidget(self.coming)
        self.coming.setContentsMargins(2 * GRID, 2 * GRID, 2 * GRID, 0)
        self._column.addWidget(self.area, 1)

    @property
    def ready(self) -> bool:
        """Whether it is built, and has its style sheets."""
        return self.page is not None and self.page.parent() is self.place

    def built(self) -> QWidget:
        """The page itself, at once."""
        while self.page is None or not self.ready:
            self.build()
        return self.page

    def build(self) -> None:
        """Build the page, a part at a time; at last put it into its place."""
        next(self._parts, None)
        gc.freeze()  # what is built stays: the collector need not go through it again

    def _in_parts(self) -> Iterator[None]:
        try:
            self.page = build_page(self.entry, self._app_state, self._theme())
            yield
            while build_more(self.entry, self.page):
                yield
        except InputError as error:
            if self.page is not None:
                self.page.deleteLater()
            self.page = self._card(error)
            yield
        yield from self._styled(self.page)
        self.coming.hide()
        self.place.hold(self.page)

    def _styled(self, page: QWidget) -> Iterator[None]:
        applied = ""
        while applied != (applied := self._sheet()):  # again, where another theme has come meanwhile
            until = time.monotonic() + TIME_SLICE_S
            for one in (*self._bars(), *styled_widgets(page)):
                if time.monotonic() > until:
                    yield
                    until = time.monotonic() + TIME_SLICE_S
                apply_style(one, applied)
                one.ensurePolished()  # sizes are those of the window's fonts before anything is laid out

    def _card(self, error: InputError) -> QWidget:
        """What stands in the place of a page that cannot be built: what happened, and that all else works."""
        remedy = self.tr("All other pages work. Mend the package that brings this page, or uninstall it.")
        holder, card = QWidget(), FaultCard(closable=False)
        column = QVBoxLayout(holder)
        column.setContentsMargins(2 * GRID, 2 * GRID, 2 * GRID, 2 * GRID)
        column.addWidget(flat(card))
        column.addStretch()
        card.report_requested.connect(self._app_state.report_requested)
        card.show_fault(Fault("page", str(error), remedy, "".join(traceback.format_exception(error))))
        return holder

    def styled_widgets(self) -> list[QWidget]:
        """What has a style sheet of its own, in order."""
        return [*self._bars(), *styled_widgets(self.page)] if self.page is not None and self.ready else []

    def _bars(self) -> tuple[QWidget, QWidget]:
        return self.area.verticalScrollBar(), self.area.horizontalScrollBar()

    def theme_updates(self, theme: Theme) -> Iterator[Callable[[], object]]:
        """What puts each part that draws for itself into the colours of `theme`; holders come after what they hold."""
        parts = [] if self.page is None else [*reversed(self.page.findChildren(QWidget)), self.page]
        return (partial(part.set_theme, theme) for part in parts if isinstance(part, Themed))

    def show_part(self, widget: QWidget, *, alone: bool = False) -> None:
        """Scroll to the card that `widget` stands in; what has the focus already would not come into sight.

        `alone`: no further than to `widget` itself, for a page that is just opened, whose heading tells what it is.
        """
        if not self.place.isAncestorOf(widget):
            return
        card: QWidget | None = widget
        while card is not None and card is not self.place and not isinstance(card, Card):
            card = card.parentWidget()
        if not alone:
            self.area.ensureWidgetVisible(card if isinstance(card, Card) else widget)
        margin = 0 if alone else 50  # as Qt has it
        self.area.ensureWidgetVisible(widget, margin, margin)  # of a card that is higher than the page

    def showEvent(self, event: QShowEvent) -> None:
        """Ask to be built next; a page that says so is opened at its top, however far it was rolled."""
        if getattr(self.page, "opens_at_top", False) and not event.spontaneous():
            self.area.verticalScrollBar().setValue(0)
        if not self.ready:
            self.wanted.emit()
