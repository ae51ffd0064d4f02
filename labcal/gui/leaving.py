"""Closing the window while a run goes on: nothing is lost by accident, and the person says what becomes of the run."""

from __future__ import annotations

import time
from pathlib import Path

from PySide6.QtCore import QObject, QTimer, Signal
from PySide6.QtWidgets import QApplication, QMenu, QStyle, QSystemTrayIcon

from labcal.bench.coils.state import NOT_READ
from labcal.gui.frame import Frame
from labcal.gui.translations.sentences import in_words
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.beside_coils import beside_coils
from labcal.gui.viewmodels.hands_now import reasons
from labcal.gui.viewmodels.lab import LabState
from labcal.gui.viewmodels.lab_now import platform_said
from labcal.gui.viewmodels.watched import as_watched
from labcal.gui.widgets.close_at_rest import CloseAtRest
from labcal.gui.widgets.close_question import CloseQuestion
from labcal.gui.widgets.going_down import GoingDown

NEEDS_SOMEBODY = ("asking", "ended")
LOOK_MS = 100
OUT_S = 30.0  # so long the way out of a run may take before the person is asked whether to go without its end
READ_MS = 1500  # so long the window stays with what was read back


class Leaving(QObject):
    """Asks before `window` goes in a run; `leave` says that it may go now, True: with the run left to be resumed."""

    leave = Signal(bool)

    def __init__(self, window: Frame, app_state: AppState) -> None:
        super().__init__(window)
        self._window, self._app_state = window, app_state
        self.question: CloseQuestion | None = None
        self.still_on: CloseAtRest | None = None
        self._guarded: bool | None = None
        self.tray: QSystemTrayIcon | None = None
        self.going: GoingDown | None = None
        self.behind = self._later = False
        self._out_by_s: float | None = None  # by then the run that the window waits for is to have ended
        self._look_timer, self._go_timer = QTimer(self, interval=LOOK_MS), QTimer(self, interval=READ_MS)
        self._look_timer.timeout.connect(self._look)
        self._go_timer.setSingleShot(True)
        self._go_timer.timeout.connect(self._go)
        app_state.run.changed.connect(self._run_changed)
        app_state.lab.changed.connect(self._say_coils)

    def may_go(self) -> bool:
        """Whether no run goes on and nobody has to keep hands off; else the person is asked."""
        if self._app_state.run.alive:  # somebody who closes it again does not want to wait
            self._ask() if self._out_by_s is None else self._ask_at_rest()
            return False
        self._app_state.grow_old()
        if self._app_state.lab.state.now.driven_elsewhere:  # that process answers for its coils
            self._window.says_off = False
            return True
        if not self._hands_off():
            return True
        self._ask_at_rest()
        return False

    def _hands_off(self) -> bool:
        return self._app_state.lab.state.keep_off[1] == "bad"

    def take(self, way: str) -> None:
        """What the person wants: stop, behind or later."""
        if way == "behind":
            self._go_behind()
        else:
            self._later, self._out_by_s = way == "later", time.monotonic() + OUT_S
            self.going = GoingDown(self._window)
            self.going.setStyleSheet(self._window.sheet())
            self.going.stays.connect(self._stay)
            self._say_coils(self._app_state.lab.state)
            self.going.open()
            self._look_timer.start()
            self._app_state.run.stop(later=self._later)

    def _look(self) -> None:
        """Go once the run has ended and its coils were read back; ask where that takes too long, or they were not."""
        app_state, asked = self._app_state, self.still_on is not None and self.still_on.isVisible()
        app_state.grow_old()
        over = not app_state.run.alive and app_state.kept.ordered_s is None
        if over and not self._hands_off():
            self._look_timer.stop()
            if self.still_on is not None:
                self.still_on.hide()
            if self.going is not None:
                self.going.say_end()
                self.going.open()
            return self._go_timer.start()
        late = self._out_by_s is not None and time.monotonic() > self._out_by_s
        if not asked and (late or (over and app_state.off.unconfirmed is not None)):
            self._ask_at_rest()
        return None

    def _go(self) -> None:
        """What was read back has been seen; unless something is on again meanwhile."""
        if self._hands_off():
            return self._ask_at_rest()
        later = self._later
        self._stay()
        return self.leave.emit(later)

    def _stay(self) -> None:
        """The window stays, whatever becomes of the run."""
        self._out_by_s, self._later = None, False
        self._look_timer.stop()
        self._go_timer.stop()
        if self.going is not None:
            self.going.hide()

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
        resumable = order is not None and order.procedure in self._app_state.path.resumable
        self.question = CloseQuestion(self._window, words, resumable=resumable)
        self.question.setStyleSheet(self._window.sheet())
        self.question.chosen.connect(self.take)
        self._say_coils(self._app_state.lab.state)
        self.question.open()

    def _ask_at_rest(self) -> None:
        if self.still_on is not None and self.still_on.isVisible():
            return
        self.still_on, self._guarded = CloseAtRest(self._window), self._is_guarded()
        self.still_on.setStyleSheet(self._window.sheet())
        self.still_on.chosen.connect(self._asked_at_rest)
        self._say_still_on()
        if self.going is not None:
            self.going.hide()
        self.still_on.open()

    def _asked_at_rest(self, go: bool) -> None:
        later = self._later
        self._stay()
        if go:
            self.leave.emit(later)

    def _say_still_on(self) -> None:
        app_state, now = self._app_state, self._app_state.lab.state.now
        if self.still_on is not None:
            coils = (in_words(app_state.coil_words()), beside_coils(now))
            self.still_on.say(
                by_hand=app_state.by_hand(),
                coils_in_doubt=bool(now.earlier_on or reasons(now.coil_words or NOT_READ, "")),
                coils=". ".join(filter(None, coils)),
                platform=platform_said(now.platform_words),
                guarded=self._guarded,
            )

    def _is_guarded(self) -> bool | None:
        """Whether a guardian keeps the supplies; None of a simulated lab, whose coils are gone with it."""
        from labcal.bench.guardian.client import is_guarded

        return None if self._app_state.lab.state.simulated else is_guarded(Path(self._app_state.bench))

    def _say_coils(self, state: LabState) -> None:
        at_rest = not self._app_state.run.alive and self._out_by_s is None and not self._hands_off()
        if at_rest and self.still_on is not None:
            self.still_on.hide()
        self._say_still_on()
        if self.question is not None:
            self.question.say_hands(*state.hands)
        seen = as_watched(state.now)
        for dialog in (self.question, self.going):
            if dialog is not None:
                dialog.say_lab(seen.coil_words, seen.platform_words)

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
        """Whoever is needed sees the window."""
        run = self._app_state.run
        if run.state in NEEDS_SOMEBODY and self.behind:
            self.come_back()
        if run.alive:
            return
        if self.question is not None:
            self.question.close()
