"""The window: the frame with all pages, the desk behind it, and what is remembered between two days."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QCloseEvent, QColor, QGuiApplication, QKeySequence, QPalette, QShortcut
from PySide6.QtWidgets import QApplication, QFileDialog, QVBoxLayout, QWidget

from labcal.gui import hold
from labcal.gui.desk import Desk
from labcal.gui.fault_card import FaultCard
from labcal.gui.frame import Frame
from labcal.gui.problem import save_problem
from labcal.gui.scanner import Scanner
from labcal.gui.theme import DARK, LIGHT, WALL_SCALE, Theme, style_sheet
from labcal.gui.widgets import named
from labcal.gui.wire import Fault

if TYPE_CHECKING:
    from labcal.gui.pages.run import RunPage

AHEAD_MS = 400
PAGES = ("Start", "Bench", "Run", "Fit", "Loop", "Certificate", "History")


class Later(QWidget):
    """A page that is built when it is first seen: the window is up before the plots are."""

    def __init__(self, build: Callable[[], QWidget]) -> None:
        super().__init__()
        self._build = build
        self._column = QVBoxLayout(self)
        self._column.setContentsMargins(0, 0, 0, 0)
        self.page: QWidget | None = None

    def made(self) -> QWidget:
        """The page itself."""
        if self.page is None:
            self.page = self._build()
            self._column.addWidget(self.page)
            for part in self.page.findChildren(QWidget):
                part.ensurePolished()  # sizes are those of the window's fonts before anything is laid out
        return self.page

    def forget(self) -> None:
        """Build it anew: at once where it is in sight, else when it is next seen."""
        if self.page is not None:
            self.page.hide()
            self.page.setParent(None)
            self.page.deleteLater()
            self.page = None
        if self.isVisible():
            QTimer.singleShot(0, self, self.made)

    def showEvent(self, event: object) -> None:
        """Build it now."""
        self.made()


def build_page(name: str, desk: Desk, theme: Callable[[], Theme]) -> QWidget:
    """The page called `name`: class NamePage in labcal.gui.pages.name."""
    module = import_module(f"labcal.gui.pages.{name.lower()}")
    made: QWidget = getattr(module, f"{name}Page")(desk, theme())
    return made


def system_theme() -> Theme:
    """Dark or light, as the system says."""
    dark = QGuiApplication.styleHints().colorScheme() == Qt.ColorScheme.Dark
    return DARK if dark else LIGHT


class Window(Frame):
    """Everything together. `theme` overrides what the system says."""

    def __init__(self, desk: Desk, theme: Theme | None = None) -> None:
        self.desk = desk
        self.theme = theme or system_theme()
        self.later = {name: Later(partial(build_page, name, desk, lambda: self.theme)) for name in PAGES}
        super().__init__(desk.lab, dict(self.later))
        self.wall = str(desk.settings.value("wall", "no")) == "yes"
        self.fault = named(FaultCard(), "topfault")
        self.above.addWidget(self.fault)
        self.fault.report_asked.connect(desk.report_asked)
        self.scanner = Scanner(self)
        self.hearers += [hold.hear, self.scanner.hear]
        self._connect(desk)
        self._look()
        if theme is None:
            QGuiApplication.styleHints().colorSchemeChanged.connect(lambda _: self.set_theme(system_theme()))
        if (geometry := desk.settings.value("geometry")) is not None:
            self.restoreGeometry(geometry)

    def _connect(self, desk: Desk) -> None:
        self.scanner.scanned.connect(desk.scan)
        self.coils_off.connect(desk.coils_off)
        self.top.dut.textEdited.connect(lambda text: desk.who(dut=text))
        self.top.operator.textEdited.connect(lambda text: desk.who(operator=text))
        desk.went.connect(self.open_page)
        desk.fault.connect(self.fault.show_fault)
        desk.report_asked.connect(self._save_problem)
        desk.study_asked.connect(self._study)
        desk.procedure_asked.connect(self._procedure)
        desk.plan_asked.connect(self._plan)
        desk.run.changed.connect(self._lock)
        QShortcut(QKeySequence("F11"), self, self.toggle_wall)

    def build_ahead(self) -> None:
        """Build the next page that nobody has seen, and again a moment later: none is to be built during a run.

        Then have the worker of fits ready.
        """
        waiting = [later for later in self.later.values() if later.page is None]
        if waiting and not self.desk.run.alive:
            waiting[0].made()
            QTimer.singleShot(AHEAD_MS, self, self.build_ahead)
        elif not waiting:
            self.desk.study_vm.prepare()

    def page(self, name: str) -> QWidget:
        """The page called `name`, built if it was not."""
        return self.later[name].made()

    def toggle_wall(self) -> None:
        """Texts to be read from two metres, or back (F11)."""
        self.wall = not self.wall
        self.desk.settings.setValue("wall", "yes" if self.wall else "no")
        self._look()

    def set_theme(self, theme: Theme) -> None:
        """Show everything in `theme`; what is known stays."""
        self.theme = theme
        for later in self.later.values():
            later.forget()
        self._look()

    def _look(self) -> None:
        """The style sheet is the window's own: the application's is looked up by widgets that nobody sees, too."""
        scale = WALL_SCALE if self.wall else 1.0
        QApplication.setPalette(_palette(self.theme))
        self.setStyleSheet(style_sheet(self.theme, scale))
        self.set_scale(scale)

    def _lock(self) -> None:
        """Who and what stand fixed while a run goes on."""
        for entry in (self.top.dut, self.top.operator):
            entry.setReadOnly(self.desk.run.alive)

    def _study(self, run: str) -> None:
        self.open_page("Fit")
        self.desk.study_vm.open(run)

    def _procedure(self, names: str) -> RunPage:
        from labcal.gui.pages.run import RunPage

        self.open_page("Run")
        page = self.page("Run")
        assert isinstance(page, RunPage)
        page.open_procedure(names)
        return page

    def _plan(self, name: str) -> None:
        self._procedure(name).choose.rehearse()

    def _save_problem(self, fault: Fault | None) -> None:
        start = str(Path.home() / "labcal-problem.zip")
        out, _ = QFileDialog.getSaveFileName(self, self.tr("Save a problem report"), start, "*.zip")
        if out:
            steps = [(name, str(mark)) for name, mark in self.desk.run.steps()]
            save_problem(Path(out), fault, self.desk.bench, steps, self.desk.facts)

    def closeEvent(self, event: QCloseEvent) -> None:
        """Remember where it stood; coils to zero; hang up."""
        self.desk.settings.setValue("geometry", self.saveGeometry())
        super().closeEvent(event)
        self.desk.close()


def _palette(theme: Theme) -> QPalette:
    """For what no style sheet reaches: placeholders, links, dialogs."""
    palette = QPalette()
    role = QPalette.ColorRole
    for which, colour in ((role.Window, theme.page), (role.Base, theme.surface), (role.Text, theme.text),
                          (role.WindowText, theme.text), (role.Button, theme.surface), (role.ButtonText, theme.text),
                          (role.AlternateBase, theme.sunken), (role.Highlight, theme.accent),
                          (role.HighlightedText, theme.on_accent), (role.PlaceholderText, theme.muted)):  # fmt: skip
        palette.setColor(which, QColor(colour))
    return palette


def open_window(bench: str | None) -> Window:
    """The window on `bench`, else on the last one."""
    desk = Desk()
    window = Window(desk)
    window.show()
    QTimer.singleShot(AHEAD_MS, window, window.build_ahead)
    chosen = bench or str(desk.settings.value("bench", "") or "")
    if chosen and (bench or Path(chosen).is_file()):
        QTimer.singleShot(0, desk, lambda: desk.open_bench(chosen))
    return window
