"""What Next does on the page that stands there already: press the one button for it, or lead to where it begins."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import QT_TRANSLATE_NOOP
from PySide6.QtWidgets import QPushButton, QWidget

from labcal.gui.ipc.answers import RunLine
from labcal.gui.pages.lazy_page import LazyPage
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.path import Next
from labcal.gui.viewmodels.run_search import local_time
from labcal.gui.widgets.common import set_primary

OF_RUN = QT_TRANSLATE_NOOP("Words", "{0} · run of {1}")


def begins_at(lazy_page: LazyPage) -> list[QWidget]:
    """The one thing to do on a page, else where that begins; a click on Next shows it where the page is open."""
    buttons = lazy_page.findChildren(QPushButton, "primary")
    first = getattr(lazy_page.page, "begins_at", None)
    return [one for one in (*buttons, first) if one is not None and one.isVisible() and one.isEnabled()]


def one_is_blue(following: QPushButton, page: QWidget | None, *, calm: bool) -> None:
    """Next is the blue button, but where the page in sight has one of its own, or a red card says what comes first."""
    blue = [] if page is None else page.findChildren(QPushButton, "primary")
    set_primary(following, calm and not [one for one in blue if one.isVisible() and one.isEnabled()])


def pressed_by_next(pages: Mapping[str, LazyPage], to: Next) -> QPushButton | None:
    """The button that does what Next says, where Next may press it."""
    found = begins_at(pages[to.page]) if to.presses else []
    return next((one for one in found if isinstance(one, QPushButton)), None)


def said_here(pages: Mapping[str, LazyPage], to: Next, here: bool, unlike: RunLine | None = None) -> str:
    """Its words; on the Bench page, where it is open, those of the button that Next presses.

    `unlike`: the run that it speaks of, where the page in sight shows another one.
    """
    if unlike is not None:
        return translated(str(OF_RUN)).format(to.words, f"{local_time(unlike.started_utc):%Y-%m-%d %H:%M}")
    does = pressed_by_next(pages, to) if here and to.page == "Bench" else None
    return to.words if does is None else does.text()
