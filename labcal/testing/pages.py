"""A page of the window held to its protocol, with workers that answer only when they are asked to."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib.metadata import EntryPoint
from pathlib import Path
from typing import Any, NamedTuple
from unittest.mock import patch

from PySide6.QtCore import QObject, QSettings, Qt, Signal
from PySide6.QtWidgets import QAbstractButton, QAbstractItemView, QApplication, QLineEdit, QTabBar, QWidget

from labcal.errors import InputError
from labcal.gui.ipc.client import OnFault
from labcal.gui.ipc.codec import decode, encode
from labcal.gui.ipc.lines import answer_type
from labcal.gui.ipc.listeners import while_there
from labcal.gui.ipc.messages import Command, Word
from labcal.gui.pages.lazy_page import LazyPage
from labcal.gui.pages.registry import build_more, build_page, pages
from labcal.gui.theming.stylesheet import styled_widgets
from labcal.gui.theming.theme import DARK, LIGHT, Theme
from labcal.gui.viewmodels import app_state
from labcal.testing.require import require

SMALLEST = 1024, 700  # px of the smallest window
PARTS = 1000  # of a page that is built in parts, at most


class Asked(NamedTuple):
    """A command that waits for its answer."""

    command: Command[Any]
    then: Callable[[Any], object]
    failed: OnFault


class DeafWorker(QObject):
    """A worker that answers only when it is asked to."""

    items = Signal(tuple)
    states = Signal(object)
    progress = Signal(str)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__()
        self.asked, self.said = list[Asked](), list[Word]()
        self.killed, self.busy, self.pid = 0, False, 0

    def request(self, command: Command[Any], then: Callable[[Any], object], failed: OnFault) -> None:
        """Remember that it was asked for."""
        self.asked.append(Asked(command, while_there(then), while_there(failed)))

    def send(self, word: Word) -> None:
        """Remember what was said."""
        self.said.append(word)

    def kill(self) -> None:
        """Remember that it was ended."""
        self.killed += 1

    def close(self, wait_ms: int = 0) -> None:
        """Nothing to end."""

    def commands(self, kind: type = object) -> list[Command[Any]]:
        """What is asked and not answered, of one kind."""
        return [one.command for one in self.asked if isinstance(one.command, kind)]

    def answer(self, kind: type[Command[Any]], result: Any) -> None:
        """Answer every command of a kind that waits, with what its class declares."""
        decode(answer_type(kind), json.loads(json.dumps(encode(result))), kind.__name__)
        mine = [one for one in self.asked if isinstance(one.command, kind)]
        self.asked = [one for one in self.asked if one not in mine]
        for one in mine:
            one.then(result)


def check_page(page: str | Callable[..., QWidget]) -> None:
    """Hold a page (its name in the sidebar, or what makes it) to its protocol, on a window that no bench is opened in.

    It must be built without waiting for a worker, begin nothing by itself, be shown and hidden, follow the theme, fit
    into the smallest window and have buttons that keyboard and ear can find. Raises AssertionError.
    """
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    _ = QApplication.instance() or QApplication([])
    with _state() as state:
        entry, make = _named(page)
        widget = _built(entry, make, state)
        check_shown_and_hidden(entry, widget)
        check_begins_nothing(entry, state)
        check_buttons(entry, widget)
        check_size(entry, widget)
        check_theme(entry, make, state)
        widget.deleteLater()


def _named(page: str | Callable[..., QWidget]) -> tuple[EntryPoint, Callable[..., QWidget] | None]:
    if not isinstance(page, str):
        name = getattr(page, "__name__", "page")
        return EntryPoint(name, f"{getattr(page, '__module__', '?')}:{name}", "labcal.pages"), page
    what = f'Register {page!r} in [project.entry-points."labcal.pages"] and install again.'
    require(page in pages(), f"There is no page {page!r}; there are {', '.join(pages())}. {what}")
    return pages()[page], None


@contextmanager
def _state() -> Iterator[app_state.AppState]:
    with tempfile.TemporaryDirectory() as folder, patch.object(app_state, "Client", DeafWorker):
        settings = QSettings(str(Path(folder) / "window.ini"), QSettings.Format.IniFormat)
        yield app_state.AppState(settings)


@contextmanager
def _found(make: Callable[..., QWidget] | None) -> Iterator[None]:
    """An entry point of a page that is not installed loads what it was made from."""
    if make is None:
        yield
        return
    with patch.object(EntryPoint, "load", lambda entry: make):
        yield


def _built(entry: EntryPoint, make: Callable[..., QWidget] | None, state: app_state.AppState) -> QWidget:
    with _found(make):
        try:
            widget = build_page(entry, state, LIGHT)
            parts = 0
            while build_more(entry, widget):
                parts += 1
                require(parts < PARTS, f"page {entry.name!r}: build_more() says for ever that a part was missing.")
        except InputError as error:
            raise AssertionError(f"page {entry.name!r}: {error}") from error
    return widget


def check_shown_and_hidden(entry: EntryPoint, widget: QWidget) -> None:
    """It is shown, hidden and shown again."""
    for _ in range(2):
        widget.show()
        QApplication.processEvents()
        widget.hide()
    require(not widget.isVisible(), f"page {entry.name!r} stays when it is hidden.")


def check_begins_nothing(entry: EntryPoint, state: app_state.AppState) -> None:
    """Being looked at neither runs, fits nor switches anything: what a page wants to know it asks the quick worker."""
    workers: dict[str, Any] = {"bench": state.bench_worker, "fit": state.fit_worker, "off": state.off_worker}
    for name, worker in workers.items():
        begun = [type(one).__name__ for one in (*worker.commands(), *worker.said)]
        what = f"page {entry.name!r} asks the {name} worker for {', '.join(begun)} as it is shown"
        require(not begun, f"{what}: a person's click begins such work; to know something, use app_state.request.")


def check_buttons(entry: EntryPoint, widget: QWidget) -> None:
    """Every button has words, and the tabulator finds it."""
    for button in widget.findChildren(QAbstractButton):
        if isinstance(button.parentWidget(), QLineEdit | QTabBar | QAbstractItemView):
            continue  # Qt's own: what clears a field, scrolls tabs, or stands in a table's corner
        words = button.text() or button.accessibleName() or button.toolTip()
        what = f"a {type(button).__name__} of page {entry.name!r} has no words: give it a text or an accessible name."
        require(words, what)
        if type(button).__name__ == "QPushButton":
            what = f"button {words!r} of page {entry.name!r} is not found by Tab: leave its focus policy as it is."
            require(button.focusPolicy() & Qt.FocusPolicy.TabFocus, what)
            what = f"button {words!r} of page {entry.name!r} has no tool tip: say what it does (widgets.common.button)."
            require(button.toolTip(), what)


def check_size(entry: EntryPoint, widget: QWidget) -> None:
    """It fits into the smallest window."""
    least = widget.minimumSizeHint()
    fits = least.width() <= SMALLEST[0] and least.height() <= SMALLEST[1]
    what = f"page {entry.name!r} needs {least.width()} × {least.height()} px, the smallest window has"
    require(fits, f"{what} {SMALLEST[0]} × {SMALLEST[1]}: let texts wrap, or put it into a QScrollArea.")


def check_theme(entry: EntryPoint, make: Callable[..., QWidget] | None, state: app_state.AppState) -> None:
    """In its place in the window it takes the style sheet, and what draws for itself takes another theme."""
    themes: list[Theme] = [LIGHT]
    with _found(make):
        place = LazyPage(entry, state, lambda: themes[-1], lambda: f"QLabel {{ color: {themes[-1].text}; }}")
        page = place.built()
        layout = page.layout() is not None
    what = f"page {entry.name!r} has no layout: what stands in its layouts is styled as the window's own pages are."
    require(layout and styled_widgets(page), what)
    for theme in (DARK, LIGHT):
        themes.append(theme)
        for update in place.theme_updates(theme):
            update()
    place.deleteLater()
