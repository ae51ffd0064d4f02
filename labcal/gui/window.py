"""The window: the frame with all pages, the desk behind it, and what is remembered between two days."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QCloseEvent, QGuiApplication
from PySide6.QtWidgets import QApplication, QVBoxLayout, QWidget

from labcal.gui import hold
from labcal.gui.desk import Desk
from labcal.gui.frame import Frame
from labcal.gui.scanner import Scanner
from labcal.gui.theme import DARK, LIGHT, WALL_SCALE, Theme, style_sheet

Build = Callable[[Desk, Theme], QWidget]


class Later(QWidget):
    """A page that is built when it is first seen: the window is up before the plots are."""

    def __init__(self, build: Callable[[], QWidget]) -> None:
        super().__init__()
        self._build: Callable[[], QWidget] | None = build
        self._column = QVBoxLayout(self)
        self._column.setContentsMargins(0, 0, 0, 0)
        self.page: QWidget | None = None

    def made(self) -> QWidget:
        """The page itself."""
        if self.page is None and self._build is not None:
            self.page = self._build()
            self._column.addWidget(self.page)
        assert self.page is not None
        return self.page

    def showEvent(self, event: object) -> None:
        """Build it now."""
        self.made()


def _run(desk: Desk, theme: Theme) -> QWidget:
    from labcal.gui.pages.run import RunPage

    return RunPage(desk, theme)


PAGES: dict[str, Build] = {"Run": _run}


def system_theme() -> Theme:
    """Dark or light, as the system says."""
    dark = QGuiApplication.styleHints().colorScheme() == Qt.ColorScheme.Dark
    return DARK if dark else LIGHT


class Window(Frame):
    """Everything together. `desk` may be handed in; `theme` overrides what the system says."""

    def __init__(self, desk: Desk, theme: Theme | None = None) -> None:
        self.desk = desk
        self.theme = theme or system_theme()
        self.later = {name: Later(partial(build, desk, self.theme)) for name, build in PAGES.items()}
        super().__init__(desk.lab, dict(self.later))
        self.set_look(1.0)
        self.scanner = Scanner(self)
        self.hearers += [hold.hear, self.scanner.hear]
        self.scanner.scanned.connect(desk.scan)
        self.coils_off.connect(desk.coils_off)
        self.top.dut.textEdited.connect(lambda text: desk.who(dut=text))
        self.top.operator.textEdited.connect(lambda text: desk.who(operator=text))
        desk.went.connect(self.open_page)
        geometry = desk.settings.value("geometry")
        if geometry is not None:
            self.restoreGeometry(geometry)

    def page(self, name: str) -> QWidget:
        """The page called `name`, built if it was not."""
        return self.later[name].made()

    def set_look(self, scale: float) -> None:
        """All texts `scale` times their size."""
        application = QApplication.instance()
        if isinstance(application, QApplication):
            application.setStyleSheet(style_sheet(self.theme, scale))

    def closeEvent(self, event: QCloseEvent) -> None:
        """Remember where it stood; coils to zero; hang up."""
        self.desk.settings.setValue("geometry", self.saveGeometry())
        super().closeEvent(event)
        self.desk.close()


def open_window(bench: str | None) -> Window:
    """The window on `bench`, else on the last one."""
    desk = Desk()
    window = Window(desk)
    window.show()
    chosen = bench or str(desk.settings.value("bench", "") or "")
    if chosen:
        QTimer.singleShot(0, desk, lambda: desk.open_bench(chosen))
    return window


__all__ = ["WALL_SCALE", "Window", "open_window"]
