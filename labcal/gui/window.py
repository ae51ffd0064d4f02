"""The window: the frame with all pages, the state behind it, and what is remembered between two days."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from threading import Thread
from typing import Any

from PySide6.QtCore import QEvent, QObject, QSize, Qt, QTimer, Signal
from PySide6.QtGui import (
    QCloseEvent,
    QDragEnterEvent,
    QDropEvent,
    QGuiApplication,
    QKeySequence,
    QResizeEvent,
    QShortcut,
)
from PySide6.QtWidgets import QApplication, QFileDialog, QWidget

from labcal.gui.frame import Frame
from labcal.gui.ipc.messages import ListPeople
from labcal.gui.ipc.wire import Fault
from labcal.gui.leaving import Leaving
from labcal.gui.next_step import begins_at, one_is_blue, pressed_by_next, said_here
from labcal.gui.pages.lazy_page import LazyPage
from labcal.gui.pages.registry import pages
from labcal.gui.prebuilding import import_pages, preallocate_plot
from labcal.gui.problem_report import save_problem
from labcal.gui.screen import show_whole
from labcal.gui.theming.chosen import chosen_theme, system_theme
from labcal.gui.theming.palette import palette
from labcal.gui.theming.stylesheet import COMES_UP, apply_style, is_unstyled, styled_widgets
from labcal.gui.theming.theme import DARK, GRID, LIGHT, Theme, style_sheet, text_scale
from labcal.gui.translations.translate import following, languages, spoken
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.mark_words import mark_words
from labcal.gui.viewmodels.path import SHAPES
from labcal.gui.widgets import hold_button
from labcal.gui.widgets.barcode_scanner import Scanner
from labcal.gui.widgets.coils_on_card import say_coils
from labcal.gui.widgets.earlier_card import EarlierCard
from labcal.gui.widgets.fault_card import FaultCard
from labcal.gui.widgets.idle_queue import IdleQueue
from labcal.gui.widgets.key_sheet import KeySheet, described
from labcal.gui.widgets.lock_screen import LockScreen
from labcal.gui.widgets.over_page import OverPage
from labcal.gui.widgets.restyled import style_at_once, style_bit_by_bit
from labcal.gui.widgets.said_at import say_below
from labcal.gui.widgets.scan_card import ScanCard
from labcal.gui.widgets.shown_bar import ShownBar
from labcal.gui.widgets.sounds import is_on, switch
from labcal.system.run_door import goes_on_at

PREBUILD_DELAY_MS = 400
POLL_MS = 20  # between two looks whether the imports or a run are done
MOVES = QEvent.Type.MouseMove, QEvent.Type.Wheel, QEvent.Type.TouchBegin
SOMEBODY = QEvent.Type.KeyPress, QEvent.Type.MouseButtonPress, *MOVES


def signed_file(path: str) -> str:
    """Of a signature the calibration that it is of; any other file itself."""
    return path.removesuffix(".sshsig").removesuffix(".2") if path.lower().endswith(".sshsig") else path


class Window(Frame):
    """Everything together. `theme` overrides what the system says; `language_wanted`: to be made anew in another."""

    language_wanted = Signal(str)

    def __init__(self, app_state: AppState, theme: Theme | None = None) -> None:
        self.app_state = app_state
        self.wall = str(app_state.settings.value("wall", "no")) == "yes"
        self.theme = theme or chosen_theme(app_state.settings) or system_theme()
        self.lazy_pages = {n: LazyPage(one, app_state, lambda: self.theme, self.sheet) for n, one in pages().items()}
        super().__init__(app_state.lab, dict(self.lazy_pages), app_state.said_for_now)
        self.style_queue = IdleQueue(self)
        self.prebuild_timer = QTimer(self, singleShot=True)
        self.prebuild_timer.timeout.connect(self.prebuild)
        self.imports = Thread(target=import_pages, daemon=True, name="imports")
        self._before_wall: QSize | None = None
        self.fault, self.earlier = FaultCard(hands=app_state.hands), EarlierCard(app_state.off.earlier, app_state.lab)
        self.scan_card, self.shown_bar = ScanCard(app_state.scan_vm), ShownBar(app_state)
        self.cards = self.fault, self.earlier, self.shown_bar, self.scan_card
        for card in self.cards:
            card.setContentsMargins(0, 2 * GRID, 0, 0)
            self.above.addWidget(card)
        for over in (self.scan_card, self.top.reason):
            OverPage(over, self.stack)
        self.lock_screen = LockScreen(app_state.login)
        self.pages_column.addWidget(self.lock_screen, 1)
        self.fault.report_requested.connect(app_state.report_requested)
        self.fault.zero_wanted.connect(app_state.off.check_zero)
        self.setAcceptDrops(True)
        self.scanner, self.leaving, self._may_go = Scanner(self), Leaving(self, app_state), False
        self.key_handlers += [hold_button.handle_key, self.scanner.handle_key]
        self._connect(app_state)
        self._restyle()
        self.style_queue.finish()
        if theme is None:
            QGuiApplication.styleHints().colorSchemeChanged.connect(self._system_changed)
        if (geometry := app_state.settings.value("geometry")) is not None:
            self.restoreGeometry(geometry)

    def _connect(self, app_state: AppState) -> None:
        self.leaving.leave.connect(self.leave)
        self.scanner.scanned.connect(self._scanned)
        self.scanner.asked = lambda: app_state.login.locked or app_state.run.asks_serial
        app_state.login.changed.connect(self._show_login)
        self.lock_switch.clicked.connect(app_state.login.lock)
        self._show_login()
        self.coils_off.connect(app_state.off.order)
        self.side.read_all.clicked.connect(app_state.watch.read_all)
        self.top.dut.textEdited.connect(lambda text: app_state.set_identity(dut=text))
        self.top.operator.textEdited.connect(lambda text: app_state.set_identity(operator=text))
        self.top.dut.editingFinished.connect(app_state.one_dut.settle)
        app_state.page_requested.connect(self.open_page)
        app_state.next_requested.connect(self._go_on)
        self.theme_switch.clicked.connect(self._other_theme)
        self.size_switch.clicked.connect(self.toggle_wall)
        self.sound_switch.clicked.connect(self._other_sound)
        self.language_switch.clicked.connect(lambda: self.language_wanted.emit(following(spoken())))
        self.next.clicked.connect(self._go_on)
        next_key = QShortcut(QKeySequence("Ctrl+N"), self, self.next.press)
        next_key.setAutoRepeat(False)  # held down, it begins nothing that nobody has read
        described(next_key, self.tr("what is next for this DUT"))
        app_state.path.changed.connect(self._show_path)
        app_state.one_dut.changed.connect(self._show_next)
        self._show_path()
        self.stack.currentChanged.connect(self._page_turned)
        app_state.scan_vm.changed.connect(self._show_next)
        app_state.age_timer.timeout.connect(self._show_next)  # the page's own button may be blue by now
        app_state.fault.connect(self._show_fault)
        app_state.fault_over.connect(self._fault_is_over)
        app_state.lab.changed.connect(self._say_coils)
        app_state.report_requested.connect(self._save_problem)
        app_state.run.changed.connect(self._lock)
        wall = self.tr("letters to be read from two metres, and back")
        described(QShortcut(QKeySequence("F11"), self, self.toggle_wall), wall)
        for lazy_page in self.lazy_pages.values():
            lazy_page.wanted.connect(partial(self.prebuild_timer.start, 0))

    def prebuild(self) -> None:
        """Build a piece of a page that is not there yet, what is in sight first; go on until all are there.

        While a run goes on only what is in sight. In the end, have the worker of fits ready.
        """
        waiting = [lazy_page for lazy_page in self.lazy_pages.values() if not lazy_page.ready]
        if not waiting:
            return self.app_state.study_vm.prepare() if preallocate_plot() else self.prebuild_timer.start(0)
        first = min(waiting, key=lambda lazy_page: not lazy_page.isVisible())
        if first is next(iter(self.lazy_pages.values())):  # it is light: it needs none of the imports
            first.build()
        elif self.imports.ident is None:
            self.imports.start()
        elif self.imports.is_alive() or (self.app_state.run.alive and not first.isVisible()):
            return self.prebuild_timer.start(POLL_MS)
        elif first.page is not None or preallocate_plot():
            first.build()
        return self.prebuild_timer.start(0)

    def page(self, name: str) -> QWidget:
        """The page called `name`, built if it was not."""
        if self.imports.is_alive():
            self.imports.join()
        return self.lazy_pages[name].built()

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        """Take a file, wherever it is dropped; not while a run goes on, or the screen is locked."""
        is_file = any(url.isLocalFile() for url in event.mimeData().urls())
        if is_file and not self.app_state.run.alive and self.stack.isEnabled() and not self.lock_screen.isVisible():
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        """A calibration is verified, a run bundle imported, of any other recording the mapping is looked at."""
        dropped = (url.toLocalFile() for url in event.mimeData().urls() if url.isLocalFile())
        paths = {signed_file(path) for path in dropped}
        event.acceptProposedAction()
        if len(paths) > 1:
            words = self.tr("{0} files were dropped together; nothing was done with them.").format(len(paths))
            return self.fault.show_fault(Fault("input", words, self.tr("Drop one at a time.")))
        (path,) = paths
        is_calibration = path.lower().endswith(".json")
        name = "Certificate" if is_calibration else "History"
        self.open_page(name)
        page: Any = self.page(name)
        (page.verify if is_calibration else page.take_file)(path)
        return None

    def toggle_wall(self) -> None:
        """Texts to be read from two metres, or back (F11)."""
        room = text_scale(self.width(), self.height(), wall=True) != 1.0
        self.wall = room and not self.wall
        self.app_state.settings.setValue("wall", "yes" if self.wall else "no")
        if self.wall:
            self._before_wall = self.size()
        self._restyle()
        if not room:
            words = self.tr("The window has no room for larger letters: make it larger.")
            self.app_state.said_for_now.say(words)
            say_below(self.sidebar_buttons.buttons()[-1], words)  # a run writes the line below anew, again and again
        if not self.wall and self._before_wall is not None:
            self.style_queue.add(partial(self.resize, self._before_wall))

    def _system_changed(self) -> None:
        if chosen_theme(self.app_state.settings) is None:
            self.set_theme(system_theme())

    def _other_theme(self) -> None:
        """Dark in place of light or the other way round; kept for the next day."""
        theme = LIGHT if self.theme is DARK else DARK
        self.app_state.settings.setValue("theme", theme.name)
        self.set_theme(theme)

    def _other_sound(self) -> None:
        switch(self.app_state.settings)
        self._say_switches()

    def _say_switches(self) -> None:
        """What a click on them would give."""
        self.theme_switch.setText(self.tr("Go dark") if self.theme is LIGHT else self.tr("Go light"))
        self.size_switch.setText(self.tr("Smaller   F11") if self.wall else self.tr("Larger   F11"))
        self.sound_switch.setText(self.tr("Mute") if is_on(self.app_state.settings) else self.tr("Unmute"))
        self.language_switch.setText(languages()[following(spoken())])

    def set_theme(self, theme: Theme) -> None:
        """Show everything in `theme`, what is in sight first."""
        self.theme = theme
        self._restyle(recolour=True)

    def sheet(self) -> str:
        """The style sheet of every part."""
        return style_sheet(self.theme, text_scale(self.width(), self.height(), wall=self.wall))

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Another size: large letters become as large as it has room for."""
        super().resizeEvent(event)
        if text_scale(self.width(), self.height(), wall=self.wall) != self._scale:
            self._restyle()

    def _restyle(self, *, recolour: bool = False) -> None:
        """Style everything bit by bit, what is in sight first: no event takes long."""
        self._say_switches()
        QApplication.setPalette(palette(self.theme))
        sheet = self.sheet()
        for keys in self.findChildren(KeySheet):
            keys.setStyleSheet(sheet)
            keys.fit_into(self.size())
        self.set_scale(text_scale(self.width(), self.height(), wall=self.wall))
        self.hold_minimum(False)
        style_at_once(sheet, self.top, self.top.reason, self.side.hands_group)  # these are always in sight
        style_bit_by_bit(self.style_queue, self.side, styled_widgets(self.side), sheet, seen=True)
        for part in (self.sidebar, self.bottom, *self.cards, self.lock_screen):
            style_bit_by_bit(self.style_queue, part, styled_widgets(part), sheet)
        for lazy_page in sorted(self.lazy_pages.values(), key=lambda one: not one.isVisible()):
            updates = lazy_page.theme_updates(self.theme) if recolour else ()
            style_bit_by_bit(self.style_queue, lazy_page, lazy_page.styled_widgets(), sheet, updates)
        self.style_queue.put("minimum", lambda: self.hold_minimum(self._scale == 1.0))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Style what comes up new; then handle the keys."""
        if (kind := event.type()) in SOMEBODY:  # asked once: PySide makes it anew each time, for thousands of events
            self.app_state.watch.touched()
            if kind not in MOVES:
                self.app_state.login.touched()
            if kind == QEvent.Type.MouseButtonPress:
                self.scanner.flush()  # what was typed before a click comes before it
        elif kind in COMES_UP and isinstance(watched, QWidget) and is_unstyled(watched, self):
            apply_style(watched, self.sheet())
        return super().eventFilter(watched, event)

    def _show_path(self) -> None:
        marks, now = self.app_state.path.marks(), self.app_state.lab.state.now
        self.show_path({name: SHAPES[mark] for name, mark in marks.items()}, mark_words(marks, now))
        self._show_next()

    def _show_next(self) -> None:
        """Who sees already what goes on, and is not asked, has nothing to do but to wait; a scan is answered first."""
        to, app_state = self.app_state.path.next(), self.app_state
        here, unlike = self.page_shown() == to.page, app_state.one_dut.unlike(to, self.page_shown())
        begins = self.tr("Begin {0}").format(app_state.path.begins)
        following = begins if here and to.ready else said_here(self.lazy_pages, to, here, unlike)
        self.say_next(following, app_state.lab.state.dut_serial)
        warned = app_state.off.warns and not app_state.run.alive and to.page != "Bench"  # the red card comes first
        calm = not warned and not (here and app_state.run.alive)  # what a question asks is pressed on its own card
        QTimer.singleShot(0, self, lambda: one_is_blue(self.next, self.stack.currentWidget(), calm=calm))
        nothing_to_do = to.waits and here and app_state.one_dut.shows(to)
        self.next.setVisible(not (nothing_to_do and app_state.run.alive))  # who is needed when stands beside the steps
        self.next.setDisabled(app_state.login.locked or app_state.scan_vm.asks or nothing_to_do)

    def _page_turned(self) -> None:
        self.app_state.said_at_the_end.put_away(self.page_shown())
        self.app_state.refused.put_away()
        self.app_state.one_dut.settle()
        self.shown_bar.show_page(self.page_shown())
        self._show_next()

    def _go_on(self) -> None:
        """To what is next; where it is to say which DUT or who works here, into the field that is wanted."""
        to, before = self.app_state.path.next(), self.page_shown()
        if to.off:
            return self.app_state.off.order()
        self.app_state.one_dut.turn_to(to)  # its page may show another one's
        if self.page_shown() == to.page and (does := pressed_by_next(self.lazy_pages, to)) is not None:
            return does.click()
        if to.in_the_bar and (field := self.top.wanted(self.app_state.lab.state)) is not None:
            return field.setFocus(Qt.FocusReason.TabFocusReason)  # it is in sight: the page stays, with what is on it
        if self.page_shown() != to.page or not to.ready:  # what was chosen on the Run page stays chosen
            self.app_state.go(to)
        elif callable(begin := getattr(self.lazy_pages[to.page].page, "begin", None)):
            begin()
            return None
        at_the_top = self.top.wanted(self.app_state.lab.state) if to.page == "Start" else None
        for widget in [one for one in (at_the_top, *begins_at(self.lazy_pages[to.page])) if one is not None][:1]:
            widget.setFocus(Qt.FocusReason.TabFocusReason)
            self.lazy_pages[to.page].show_part(widget, alone=before != to.page)
        return None

    def _scanned(self, text: str) -> None:
        """A serial; on the locked screen a badge."""
        if self.app_state.login.locked:
            return self.app_state.login.log_in(text)
        return self.scan_card.hear(self.app_state, text)

    def _show_login(self) -> None:
        """Where it is locked nothing is in sight and nothing heard but COILS OFF and who logs in."""
        login = self.app_state.login
        self.lock_switch.setVisible(login.wanted)
        self.stack.setVisible(not login.locked)
        for part in (self.sidebar, self.next, self.top.dut, self.scan_card, self.shown_bar):
            part.setDisabled(login.locked)
        for shortcut in self.findChildren(QShortcut):
            shortcut.setEnabled(not login.locked)
        self._lock()

    def _lock(self) -> None:
        """Who and what stand fixed while a run goes on; where people log in, who works here is no matter of typing."""
        self.top.dut.setReadOnly(self.app_state.run.alive)
        self.top.operator.setReadOnly(self.app_state.run.alive or self.app_state.login.wanted)
        for one in (self.language_switch, self.lock_switch):
            one.setDisabled(self.app_state.run.alive)
        if self.app_state.run.alive:
            self.app_state.scan_vm.put_away()

    def _show_fault(self, fault: Fault) -> None:
        """That coils may be on stays in sight before anything else that goes wrong."""
        if self.app_state.warning_shown and not self.app_state.off.says(fault):
            return self.app_state.lab.update(message=fault.text)
        self.fault.show_fault(fault)
        return self._say_coils()

    def _fault_is_over(self, fault: Fault) -> None:
        self.fault.show_fault(None if self.fault.fault is fault else self.fault.fault)

    def _say_coils(self) -> None:
        """A card that says that the coils are not known to be at zero says how they are now."""
        if said := self.app_state.off.says(self.fault.fault):
            say_coils(self.fault, self.app_state)
        self.fault.let_check_zero(said and self.app_state.off.zero_in_doubt())
        self.fault.let_close(not (said and self.app_state.still_live()))
        self.app_state.warning_shown = said and not self.fault.isHidden()

    def _save_problem(self, fault: Fault | None) -> None:
        start = str(Path.home() / "labcal-problem.zip")
        out, _ = QFileDialog.getSaveFileName(self, self.tr("Save a problem report"), start, "*.zip")
        if out:
            steps = [(name, str(mark)) for name, mark in self.app_state.run.steps()]
            facts = self.app_state.facts
            save_problem(Path(out), fault, self.app_state.bench, steps, None if facts is None else facts.simulated)

    def leave(self, resumed_later: bool = False) -> None:
        """Go, whatever goes on: a run is aborted, or left to be resumed later; either with coils at zero."""
        self._may_go, self.says_off = True, not resumed_later
        self.close()

    def closeEvent(self, event: QCloseEvent) -> None:
        """Remember where it stood; coils to zero; hang up. In a run the person is asked first."""
        if not self._may_go and not self.leaving.may_go():
            return event.ignore()
        self.app_state.settings.setValue("geometry", self.saveGeometry())
        super().closeEvent(event)
        return self.app_state.close()


def open_window(bench: str | None, *, watched: bool = False, worker: int = 0) -> Window:
    """The window on `bench`, else on the last one; or come back to the run that goes on in the process `worker`."""
    app_state = AppState(watched=watched)
    window = Window(app_state)
    if comes_back := bool(worker) and goes_on_at(worker):
        app_state.come_back(worker)
    show_whole(window)
    QTimer.singleShot(PREBUILD_DELAY_MS, window, window.prebuild)
    app_state.request(ListPeople(), app_state.login.take_people)
    chosen = bench or str(app_state.settings.value("bench", "") or "")
    if not comes_back and chosen and (bench or Path(chosen).is_file()):
        QTimer.singleShot(0, app_state, lambda: app_state.open_bench(chosen))
    return window
