"""Closing the window while a run goes on: nothing is lost by accident, and the person says what becomes of the run."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QApplication, QMenu, QStyle, QSystemTrayIcon

from labcal.gui.frame import Frame
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.lab import LabState
from labcal.gui.widgets.close_question import CloseQuestion

NEEDS_SOMEBODY = ("asking", "ended")


class Leaving(QObject):
    """Asks before `window` goes in a run; `leave` says that it may go now, True: with the run left to be resumed."""

    leave = Signal(bool)

    def __init__(self, window: Frame, app_state: AppState) -> None:
        super().__init__(window)
        self._window, self._app_state = window, app_state
        self.question: CloseQuestion | None = None
        self.tray: QSystemTrayIcon | None = None
        self.behind = self._at_end = False
        app_state.run.changed.connect(self._run_changed)
        app_state.lab.changed.connect(self._say_coils)

    def may_go(self) -> bool:
        """Whether no run goes on; else the person is asked."""
        if not self._app_state.run.alive:
            return True
        self._ask()
        return False

    def take(self, way: str) -> None:
        """What the person wants: stop, behind or later."""
        if way == "behind":
            self._go_behind()
        elif way == "later":
            self.leave.emit(True)
        else:
            self._at_end = True
            self._app_state.run.stop()

    def come_back(self) -> None:
        """The window in sight again."""
        if self.behind:
            self.behind = False
            QApplication.setQuitOnLastWindowClosed(True)
            self._window.showNormal()
            self._window.raise_()
            self._window.activateWindow()
        if self.tray is not None:
            self.tray.hide()

    def _ask(self) -> None:
        if self.question is not None and self.question.isVisible():
            return
        order = self._app_state.run.order
        words = f"{order.procedure}, {order.dut}" if order is not None else ""
        resumable = order is not None and order.procedure in self._app_state.resumable
        self.question = CloseQuestion(self._window, words, resumable=resumable)
        self.question.setStyleSheet(self._window.sheet())
        self.question.chosen.connect(self.take)
        self._say_coils(self._app_state.lab.state)
        self.question.open()

    def _say_coils(self, state: LabState) -> None:
        if self.question is not None:
            self.question.say_coils(state.now.coil_words)

    def _go_behind(self) -> None:
        self.behind = True
        QApplication.setQuitOnLastWindowClosed(False)  # there is none in sight meanwhile
        if not QSystemTrayIcon.isSystemTrayAvailable():
            return self._window.showMinimized()
        self.tray = self.tray or self._tray_icon()
        self.tray.setToolTip(self._app_state.lab.state.message)
        self.tray.show()
        return self._window.hide()

    def _tray_icon(self) -> QSystemTrayIcon:
        icon = self._window.style().standardIcon(QStyle.StandardPixmap.SP_ComputerIcon)
        tray, menu = QSystemTrayIcon(icon, self._window), QMenu(self._window)
        menu.addAction(self.tr("Show the run"), self.come_back)
        menu.addAction(self.tr("COILS OFF"), self._window.coils_off.emit)
        tray.setContextMenu(menu)
        tray.activated.connect(self.come_back)
        return tray

    def _run_changed(self) -> None:
        """Whoever is needed sees the window; where the run was to stop first, it has."""
        run = self._app_state.run
        if run.state in NEEDS_SOMEBODY and self.behind:
            self.come_back()
        if run.alive:
            return
        if self.question is not None:
            self.question.close()
        if self._at_end:
            self._at_end = False
            self.leave.emit(False)
