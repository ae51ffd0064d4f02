"""The run as it goes: steps at the left; the question or the live picture in the middle; what was measured below."""

from __future__ import annotations

import time

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtWidgets import QApplication, QHBoxLayout, QSplitter, QVBoxLayout, QWidget

from labcal.gui.ipc.messages import KeepPhoto
from labcal.gui.ipc.wire import BROKEN, Fault
from labcal.gui.theming.theme import GRID, Theme
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import procedure_title, translated
from labcal.gui.viewmodels.answers_again import AnswersAgain
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.by_hand import by_hand_words
from labcal.gui.viewmodels.delays_left import delay_words
from labcal.gui.viewmodels.failed_step import SHOWN, in_short
from labcal.gui.viewmodels.lab_now import OFF
from labcal.gui.viewmodels.lost_since import LostSince
from labcal.gui.viewmodels.off_headline import off_headline
from labcal.gui.viewmodels.run_steps import may_pause
from labcal.gui.viewmodels.run_verdict import ended_for_another, keeps_a_turn, run_verdict, to_be_fitted
from labcal.gui.viewmodels.what_happens import hands_at, headline_state, keep_off, kept_out, what_happens
from labcal.gui.widgets.act_button import ActButton, in_a_row
from labcal.gui.widgets.acts_card import ActsCard
from labcal.gui.widgets.answer_for import AnswerForCard
from labcal.gui.widgets.axis_lights import AxisLights
from labcal.gui.widgets.bar_in_margin import WholeInWidth
from labcal.gui.widgets.common import Card, FaceStack, deferred_layout, label, set_primary, set_state
from labcal.gui.widgets.covered_bar import CoveredBar
from labcal.gui.widgets.fault_card import FaultCard
from labcal.gui.widgets.flow import Flow
from labcal.gui.widgets.headline import RunHeadline
from labcal.gui.widgets.kept_focus import focus_kept_in
from labcal.gui.widgets.measurement_table import MeasuredCard
from labcal.gui.widgets.paused_hands import PausedHands
from labcal.gui.widgets.plots import Loci, Traces
from labcal.gui.widgets.prompt_card import DEAD_MS, PromptCard
from labcal.gui.widgets.run_notes import RunNotes
from labcal.gui.widgets.run_pictures import RunPictures
from labcal.gui.widgets.sounds import Sounds
from labcal.gui.widgets.step_list import StepList
from labcal.gui.widgets.time_left import TimeLeft
from labcal.gui.widgets.verdict_card import VerdictCard
from labcal.gui.widgets.whole_card import UncutCard

FRAME_MS = 40


class Live(QWidget):
    """Shows `app_state.run`; `put_away` says the person has seen how it ended."""

    put_away = Signal()

    def __init__(self, app_state: AppState, theme: Theme, loci: Loci, traces: Traces) -> None:
        super().__init__()
        self._app_state, self._run, self._theme = app_state, app_state.run, theme
        self.loci, self.traces = loci, traces
        self._asked: object = None
        self._heard_again, self._lost_since = AnswersAgain(), LostSince()
        self.pictures = RunPictures(self._run, loci, traces)
        self._just_went_on = QTimer(self, interval=DEAD_MS, singleShot=True)  # a second click was meant for Go on
        self._just_went_on.timeout.connect(self._show)
        self._goes_on = self._details = False  # once ended: it may be gone on with; what was measured is in sight
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(2 * GRID)
        left = self._left()
        row.addWidget(left, 2)
        right = QSplitter(Qt.Orientation.Vertical)
        right.setChildrenCollapsible(False)
        right.setHandleWidth(2 * GRID)
        right.addWidget(middle := self._middle())
        self._holders = (left, middle, self._picture)
        self.below = MeasuredCard(self._theme)
        self.table = self.below.table
        right.addWidget(self.below)
        right.setStretchFactor(0, 3)
        right.setStretchFactor(1, 1)
        rolled = QVBoxLayout()
        rolled.addWidget(right)
        row.addWidget(WholeInWidth(rolled, 2 * GRID), 5)  # where there is no room it rolls, and Stop stays in sight
        self.frame_timer = QTimer(self, interval=FRAME_MS)
        self.frame_timer.timeout.connect(self.draw)
        self.sounds = Sounds(self, app_state.settings)
        self.prompt.calls.connect(lambda: self.sounds.play("needed"))
        self._run.ended.connect(self._ended)  # a method: it goes when the page does, as a lambda would not
        self._run.changed.connect(self._show)
        app_state.lab.changed.connect(self._coils_known)
        if self._run.state == "ended":  # in another language
            self.verdict.told.show_run(self._run.run_id)
        self._say_lab()
        self._show()

    def _ended(self, run_id: str, _status: str) -> None:
        self.verdict.told.show_run(run_id)
        self.sounds.play("done")

    def set_theme(self, theme: Theme) -> None:
        """In the theme's colours."""
        self._theme = theme
        self.headline.set_theme(theme)
        self._show()

    def _left(self) -> QWidget:
        self.title, self.whose = label("", "title", wrap=True), label("", wrap=True)
        self.whose.setAccessibleName(self.tr("Whose run this is"))
        self.time_left = TimeLeft(self._run)
        self.steps = StepList()
        self.notes = RunNotes(self._app_state)
        self.note, self.photo = self.notes.note, self.notes.photo
        self.waits_for = label("", wrap=True)  # beside the button that is grey for it
        set_state(self.waits_for, "bad")
        self.waits_for.hide()
        above = QVBoxLayout()
        for widget in (self.title, self.whose, self.time_left):
            above.addWidget(widget)
        above.addWidget(self.steps, 1)
        above.addStretch()
        card = ActsCard(above, self.notes, self.waits_for, self._buttons())
        card.setMinimumWidth(24 * GRID)
        return card

    def _buttons(self) -> Flow:
        says = self.tr("Pause"), self.tr("Pausing …"), self.tr("Go on")
        self.pause = ActButton(says, self.tr("Wait where the next step begins, with the coils at zero"))
        self.pause.clicked.connect(self._pause_or_go_on)
        self.stop = ActButton(
            self.tr("Stop"), self.tr("End this run now, in order. The coils go to zero; what was measured is kept.")
        )
        self.stop.clicked.connect(self._run.stop)
        self.close_run = ActButton(self.tr("Close"), self.tr("Back to the procedures; the run is in the History"))
        self.close_run.clicked.connect(self.put_away)
        self.go_on = ActButton(self.tr("Go on"), self.tr("What is missing of this run"), primary=True)
        self.go_on.clicked.connect(self._resume)
        self.fit = ActButton(self.tr("Fit"), self.tr("Estimate the calibration from this run"), primary=True)
        self.fit.clicked.connect(self._fit)
        return in_a_row(self._app_state.said_for_now, self.pause, self.stop, self.close_run, self.go_on, self.fit)

    def _middle(self) -> QWidget:
        self.prompt = PromptCard(self._theme)
        self.fault = FaultCard(closable=False, hands=self._app_state.hands)
        self.prompt.answered.connect(self._answer)
        self._app_state.bench_changed.connect(self._take_camera)
        self._take_camera()
        self.fault.report_requested.connect(self._app_state.report_requested)
        self.fault.zero_wanted.connect(self._app_state.off.check_zero)
        self.middle = FaceStack()
        self._picture = self._live_card()
        self.verdict = VerdictCard(self._app_state, self._theme)
        self.verdict.details_wanted.connect(self._show_details)
        self.answer_for = AnswerForCard(self._app_state)
        for widget in (self._picture, self.prompt, self.verdict, self.answer_for):
            self.middle.addWidget(widget)
        holder = QWidget()
        column = QVBoxLayout(holder)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2 * GRID)
        self.lights = AxisLights(self._theme)
        column.addWidget(self.fault)
        column.addWidget(self.lights)
        column.addWidget(self.middle, 1)
        return holder

    def _take_camera(self) -> None:
        facts = self._app_state.facts
        self.prompt.camera.source = "" if facts is None else facts.camera

    def _answer(self, text: str) -> None:
        """What the camera sees as the DUT is said to stand goes into the record as well."""
        seen = self.prompt.camera.save() if text == "done" else ""
        self._run.answer(text)
        if seen:
            words = self.tr("as it was mounted")
            self._app_state.request(KeepPhoto(seen), lambda kept: self._run.note(words, **kept))

    def _live_card(self) -> Card:
        card = UncutCard()
        self.headline = RunHeadline(self._theme)
        self.hands = PausedHands()
        self.turn = CoveredBar()
        card.body.addWidget(self.headline)
        card.body.addWidget(self.hands)
        card.body.addWidget(self.loci, 3)
        card.body.addWidget(self.turn)
        card.body.addWidget(self.traces, 2)
        return card

    def _fit(self) -> None:
        """To the Fit page, which begins at once: it was asked for."""
        self._app_state.open_study(self._run.run_id)
        self._app_state.study_vm.fit("ml")

    def _resume(self) -> None:
        self._just_went_on.start()
        if self._run.order is not None:
            self._app_state.resume(self._run.run_id, self._run.order.procedure, self._run.order.dut)

    def _pause_or_go_on(self) -> None:
        if self._run.state != "paused":
            return self._run.pause()
        self._just_went_on.start()
        self._run.go_on()
        return self._show()

    def _show(self) -> None:
        asked = self._asked
        with focus_kept_in(self, self.fit, self.close_run, self.note):
            self._show_run()
        if self._asked is not asked and self.isVisible() and not self.note.text():
            self.prompt.take_focus()

    def _show_run(self) -> None:
        run, ended = self._run, self._run.state == "ended"
        self.title.setText(procedure_title(run.order.procedure) if run.order else "")
        whose = (run.order.dut, run.order.operator, run.began) if run.order else ()
        self.whose.setText(" · ".join(filter(None, whose)))
        self._show_steps()
        self.pause.say(2 if run.state == "paused" else int(run.pausing))
        self.pause.setEnabled(may_pause(run.state, run.step, pausing=run.pausing) and not self._just_went_on.isActive())
        self.stop.setEnabled(run.alive and run.state != "stopping" and not self._just_went_on.isActive())
        turned = run.turns() or bool(run.drawn.now)  # else nothing is recorded, and there is nothing to fit
        self._details = self._details and ended
        decided = ended and not self._details  # the verdict has the whole place
        again = self._goes_on = (
            ended
            and bool(run.run_id)
            and run.status == "interrupted"
            and run.order is not None
            and run.order.procedure in self._app_state.path.resumable
        )
        with deferred_layout(self, *self._holders):
            for widget, shown in (
                (self.pause, not ended),
                (self.stop, not ended),
                (self.close_run, ended),
                (self.go_on, again),
                (self.fit, ended and turned and run.status == "finished"),
                (self.lights, run.looks_at_axes() and not decided),
                (self.steps, bool(run.names)),
                (self.loci, turned and self._something_turns()),
            ):
                widget.setVisible(shown)
            self.turn.show_run(run)
        fits = turned and to_be_fitted(run)
        set_primary(self.close_run, not again and not fits)
        set_primary(self.fit, fits)
        self.fit.setEnabled(bool(run.run_id) and run.status == "finished")
        self.notes.enable(alive=run.alive)
        self._show_below()
        self.show_verdict()
        self.table.show_measurements(run.measurements.values())
        self.lights.show_run(run)
        self._show_fault(run.fault)
        self._ask()
        if not run.alive:
            self._draw_last()
        elif not self.frame_timer.isActive():  # one that is begun anew at each word comes to no frame at a high pace
            self.frame_timer.start()

    def _show_below(self) -> None:
        """What was measured: not below a card that warns, where it would take the room of what goes on."""
        run, decided = self._run, self._run.state == "ended" and not self._details
        gives_way = run.prompt is not None or decided or self._app_state.warning_shown
        self.below.setVisible(bool(run.measurements) and not gives_way)

    def _something_turns(self) -> bool:
        """Whether there is anything on the circles, or is to be now: empty ones say nothing while nothing turns."""
        drawn = self._run.drawn
        return bool(self._run.axis) or bool(drawn.now) or bool(drawn.earlier)

    def show_verdict(self) -> None:
        """What the run came to, as far as it has ended."""
        run, path = self._run, self._app_state.path
        if run.state != "ended":
            return self.verdict.word.set_text("")  # of the run before
        other = path.begun_elsewhere(run.run_id)
        how = run_verdict(run, path.resumable, mended=bool(self._answer_again()), elsewhere=other)
        self.verdict.show_verdict(run.order.dut if run.order else "", how)
        words, state = off_headline(self._app_state.lab.state.now) if run.by_off else ("", "")
        return self.verdict.say_off(words, state) if words else None

    def _show_details(self) -> None:
        self._details = True  # what was measured, in place of the verdict, until the next run
        self._show()

    def _draw_last(self) -> None:
        self.frame_timer.stop()
        self.draw()

    def _show_fault(self, fault: Fault | None) -> None:
        self.fault.show_fault(fault)
        self.answer_for.show_fault(fault)
        self.verdict.next.setVisible(fault is None or fault.kind != "stopped")  # its card says that
        if fault is None:
            self.verdict.say_reason("")
            return self.fault.hide()
        self._say_coils_left()
        if "try again" in fault.remedy.lower():
            self.fault.remedy.setText(f"{self.fault.remedy.text()} {self._where_to_begin_again()}")
        if fault.kind != "stopped":
            return None
        kept = self.tr("What was measured is kept in the History. To measure again: Close, then Begin.")
        goes_on = self.tr("{0} Or Close, and begin anew.").format(self.verdict.next.text())
        return self.fault.text.setText(goes_on if self._goes_on else kept)

    def _where_to_begin_again(self) -> str:
        """By which button, now that the run has ended."""
        if self._goes_on:
            return self.tr("Here that is Go on: what was finished is kept.")
        return self.tr("This run has ended: Close, then Begin measures anew.")

    def _coils_known(self) -> None:
        """They were switched off after a run that failed: its card knows. No result stays under another's serial."""
        if ended_for_another(self._run, self._app_state.lab.state.dut_serial):
            self.put_away.emit()
        self._say_lab()
        self._show_below()
        self.show_verdict()
        if self._run.fault is not None:
            self._say_coils_left()

    def _say_lab(self) -> None:
        now = self._app_state.lab.state.now
        set_primary(self.go_on, not now.to_be_mended)
        self.go_on.setEnabled(not now.failed)
        self.waits_for.setText(translated(str(SHOWN)).format(", ".join(now.failed)) if now.failed else "")
        self.waits_for.setVisible(bool(now.failed) and self._goes_on)
        words, mark = hands_at(self._run, now)
        self.prompt.say_lab(now, words if mark == OFF else "", keep_off(self._run, now)[0])
        self.prompt.say_anew(anew=self._run.anew)
        self.prompt.say_lost(now.failed, self._lost_since.named(now))
        self.prompt.say_moved(self._run.moved.words(by_the_wall=not self._run.virtual_time))
        words, mark, waits = kept_out(self._run, now)
        self.prompt.say_kept_out(words, mark, waits=waits)
        self.hands.show_state(self._app_state.lab.state, paused=self._run.state == "paused")
        self.prompt.say_serials(self._app_state.lab.state.other_serials)

    def _say_coils_left(self) -> None:
        """One card at a time: that the coils may be on is said above, and comes first."""
        self.fault.say_coils(self._coils_left())
        began = self._run.lab is not None or (self._run.fault is not None and self._run.fault.kind in BROKEN)
        self.fault.say_platform(
            self._app_state.platform_words() if began else "", told=self._app_state.off.told
        )  # else nothing was moved
        gives_way, back = self._app_state.warning_shown, self._answer_again()
        fault = self._run.fault if gives_way and not back else None
        self.fault.setVisible(not (gives_way or back))
        calm = fault is None or fault.kind == "stopped"  # as it was asked for: nothing failed
        self.verdict.say_reason(in_short(fault) if fault is not None else back, "" if calm else "bad")

    def _answer_again(self) -> str:
        """Whom this run waited for in vain, and who was heard since; "" where that is none, or lost still."""
        return self._heard_again.words(self._run, self._app_state.facts, self._app_state.lab.state.now)

    def _coils_left(self) -> str:
        """How the coils are after a run that failed."""
        words, now = in_words(self._app_state.coil_words()), self._app_state.lab.state.now
        words = f"{words}. {now.in_common}" if now.in_common else words
        off = by_hand_words(self._app_state.by_hand(), pressed=bool(self._app_state.off.pressed))
        return f"{words}. {off}." if off and now.coils_at_zero is False else words

    def _ask(self) -> None:
        prompt = self._run.prompt
        kept = self._run.step is None or keeps_a_turn(self._run)  # before a step came nobody knows that none is
        self.prompt.say_kept(turn=kept, delays=delay_words(self._run))
        self.prompt.show_prompt(prompt)
        self._say_lab()
        decided = self._run.state == "ended" and not self._details
        shown: QWidget = self.answer_for if self.answer_for.asks else self.verdict
        shown = self.prompt if prompt is not None else shown if decided else self._picture
        self._say_now()  # before it comes into sight: what it said last is past
        self.middle.setCurrentWidget(shown)
        if prompt is not None and prompt is not self._asked:
            QApplication.alert(self)
        self._asked = prompt

    def _show_steps(self) -> None:
        self.steps.show_steps(self._run.steps(), self._theme)
        self.time_left.show_now(self._app_state.lab.state.now)

    def _say_now(self) -> None:
        now = self._app_state.lab.state.now
        words = what_happens(self._run, now, alarmed=self._app_state.warning_shown)
        self.headline.say(words, headline_state(words))

    def draw(self) -> None:
        """Draw what has come since the last frame, for half of the time at most: the rest is for what comes."""
        begun_s = time.monotonic()
        self.time_left.show_now(self._app_state.lab.state.now)
        self._say_now()
        self.turn.show_run(self._run)
        self.pictures.draw()
        wait_ms = max(FRAME_MS, int(2000 * (time.monotonic() - begun_s)))
        if wait_ms != self.frame_timer.interval():
            self.frame_timer.setInterval(wait_ms)
