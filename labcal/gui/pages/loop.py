"""Loop: what is left over → who could have done it → what changes if it is added → what we still do not know."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QPlainTextEdit, QVBoxLayout, QWidget

from labcal.gui.ipc.answers import Change, Loop
from labcal.gui.ipc.wire import Fault
from labcal.gui.theming.theme import GRID, Theme
from labcal.gui.translations.sentences import in_words
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.cause_words import Cause, in_plain_words, with_id
from labcal.gui.viewmodels.drawn_against import against_words
from labcal.gui.viewmodels.kept_of_run import kept_words
from labcal.gui.viewmodels.largest_of_U import how_to_lower_U, largest_of_U
from labcal.gui.viewmodels.loop_causes import CauseRow
from labcal.gui.viewmodels.loop_words import called, headline, not_determined, of_which_error, said_plainly
from labcal.gui.viewmodels.number_format import format_number
from labcal.gui.viewmodels.path import EXPLAINED, Wanted
from labcal.gui.viewmodels.study import cause_name
from labcal.gui.widgets.causes_table import CausesTable
from labcal.gui.widgets.common import (
    Card,
    button,
    combo_box,
    label,
    named,
    offer,
    rename,
    set_primary,
    set_state,
    shrinkable,
)
from labcal.gui.widgets.fault_card import FaultCard
from labcal.gui.widgets.flow import Flow
from labcal.gui.widgets.goes_on_elsewhere import GoesOnElsewhere
from labcal.gui.widgets.idle_queue import IdleQueue
from labcal.gui.widgets.plot_export import export_buttons
from labcal.gui.widgets.plot_letters import LETTERS
from labcal.gui.widgets.run_chooser import RunChooser, go_to_run_button
from labcal.gui.widgets.study_plots import Bars, Residuals
from labcal.gui.widgets.trace_progress import TraceProgress
from labcal.gui.widgets.whole_card import SharedCard, WholeCard

LEAST_PX, LEAST_OF_WORDS_PX = 220, 100  # of a picture, and of what is not known: with less room the page is scrolled


class LoopPage(QWidget):
    """Shows the loop of `app_state.study_vm`."""

    def __init__(self, app_state: AppState, theme: Theme) -> None:
        super().__init__()
        self._app_state, self._study, self._theme = app_state, app_state.study_vm, theme
        column = QVBoxLayout(self)
        column.setContentsMargins(2 * GRID, 2 * GRID, 2 * GRID, 2 * GRID)
        column.setSpacing(2 * GRID)
        column.addLayout(self._head())
        self.progress = TraceProgress(app_state)
        self.waiting, self.work = self.progress.waiting, self.progress.work
        self.fault = FaultCard()
        self.fault.report_requested.connect(app_state.report_requested)
        for widget in (self.progress, self.fault):
            column.addWidget(widget)
        self.empty, self.to_run = label("", "ask", wrap=True), go_to_run_button(app_state)
        column.addWidget(self.empty, 1)
        column.addWidget(self.to_run, 1, Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignTop)
        self.story = self._story()
        column.addWidget(self.story, 1)
        self.elsewhere = GoesOnElsewhere(app_state)
        column.addWidget(self.elsewhere)
        self._idle_queue = IdleQueue(self)
        self._study.changed.connect(self._show)
        app_state.path.changed.connect(self._show_uncertainty)
        self._show()

    def _head(self) -> Flow:
        self.chooser = RunChooser(self._app_state)
        self.chooser.chosen.connect(self._app_state.one_dut.open)
        self.chooser.known.connect(self._show)
        self.close_loop = button(
            self.tr("Trace the residual"), self.tr("Find what causes what is left over"), primary=True
        )
        self.close_loop.clicked.connect(self._study.close_loop)
        self.cancel = button(self.tr("Cancel"), self.tr("End what is being computed; what is done stays"))
        self.cancel.clicked.connect(self._study.cancel)
        self.sign = button(
            self.tr("To the certificate"), self.tr("The draft with the accepted effects: approve and sign it")
        )
        self.sign.clicked.connect(lambda: self._app_state.page_requested.emit("Certificate"))
        return Flow(self.chooser, self.cancel, self.close_loop, self.sign)

    def _story(self) -> QWidget:
        holder = QWidget()
        column = QVBoxLayout(holder)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2 * GRID)
        column.addWidget(self._verdict_card())
        pictures = QHBoxLayout()
        pictures.setSpacing(2 * GRID)
        pictures.addWidget(self._left_card(), 1)
        pictures.addWidget(self._change_card(), 1)
        column.addLayout(pictures, 2)
        column.addWidget(self._who_card(), 3)
        column.addWidget(self._unknown_card(), 1)
        return holder

    def _verdict_card(self) -> Card:
        card = WholeCard()
        self.verdict, self.plainly = label("", "ask"), shrinkable(label("", wrap=True))
        self.called, self.summary = (shrinkable(label("", "caption", wrap=True)) for _ in range(2))
        self.summary.hide()
        self.fold = button(self.tr("In figures"), self.tr("The loop's own words: held-out rms, tests, rows set aside"))
        self.fold.setCheckable(True)
        self.fold.toggled.connect(self.summary.setVisible)
        self.before_after, self.noise = label("", "large"), label("", wrap=True)
        words, numbers = QVBoxLayout(), QVBoxLayout()
        words.addWidget(self.verdict)
        self.most_of_U = shrinkable(label("", wrap=True))
        words.addWidget(self.plainly)
        words.addWidget(self.called)
        words.addWidget(self.most_of_U)
        words.addWidget(self.summary)
        for widget in (self.before_after, self.noise):
            widget.setAlignment(Qt.AlignmentFlag.AlignRight)
            numbers.addWidget(widget)
        numbers.addWidget(self.fold, 0, Qt.AlignmentFlag.AlignRight)
        words.addStretch()
        numbers.addStretch()
        row = QHBoxLayout()
        row.addLayout(words, 1)
        row.addSpacing(4 * GRID)
        row.addLayout(numbers)
        card.body.addLayout(row)
        return card

    def _left_card(self) -> Card:
        card = Card(self.tr("1  What is left over"), self.tr("noise k=2"))
        card.unit.setToolTip(self.tr("Band: the noise of one axis of one row"))
        self.left = Residuals(self._theme)
        card.body.addWidget(self.left)
        return card

    def _who_card(self) -> Card:
        card = SharedCard(self.tr("3  What could cause it"), self.tr("beside declared errors"))
        self.bars = Bars(self._theme)
        self.others = CausesTable(self._theme)
        self.others.itemSelectionChanged.connect(self._picked)
        self.none_searched = label(self.tr("No cause was searched for: 4 says why."), wrap=True)
        self.change_why, self.change_words = label("", wrap=True), label("", "caption", wrap=True)
        card.body.addWidget(self.bars)
        card.body.addWidget(self.none_searched)
        card.body.addWidget(self.others, 1)
        for words in (self.change_why, self.change_words):
            card.body.addWidget(words)
        return card

    def _change_card(self) -> Card:
        card = SharedCard(self.tr("2  What it changes"), "")
        self.change_heading = card.heading
        self.against = combo_box(self.tr("What the residual is drawn against; the named cause first"))
        self.against.activated.connect(self._show_change)
        self.change = Residuals(self._theme)
        LETTERS.changed.connect(self._fit_pictures)
        self._fit_pictures()
        card.body.addLayout(Flow(self.against, *export_buttons(self, lambda: self.change)))
        card.body.addWidget(self.change, 1)
        return card

    def _fit_pictures(self) -> None:
        """High enough for the names of their axes, in letters of any size."""
        for one in (self.left, self.change):
            one.setMinimumHeight(round(LETTERS.scale * LEAST_PX))

    def _unknown_card(self) -> Card:
        card = Card(self.tr("4  Still not known"), "")
        self.unknown = self.begins_at = named(QPlainTextEdit(), "story")
        self.unknown.setReadOnly(True)
        self.unknown.document().setDocumentMargin(0)  # in line with the heading
        self.unknown.setMinimumHeight(LEAST_OF_WORDS_PX)
        self.next = button(
            "",
            self.tr("Its plan is shown on the Run page before anything moves, and the run is started there"),
            primary=True,
        )
        self.next.clicked.connect(self._measure)
        card.body.addWidget(self.unknown, 1)
        card.body.addWidget(self.next)
        return card

    def _measure(self) -> None:
        proposed = self._study.loop.next_experiment if self._study.loop is not None else None
        if proposed is None or proposed.procedure is None:
            return None
        mine = self._study.look.dut if self._study.look is not None else ""
        there = self._app_state.lab.state.dut_serial
        if mine != there:
            words = self.tr("This run is of {0}; the DUT at the top is {1}. Put {0} on the bench, and scan it.")
            return self.fault.show_fault(Fault("input", words.format(mine, there)))
        self._study.want(proposed.procedure)
        wanted = Wanted(proposed.procedure, plan=True, settings=proposed.settings)
        return self._app_state.open_procedure(wanted.names, wanted)

    def set_theme(self, theme: Theme) -> None:
        """States, bars and points in the theme's colours."""
        self._theme = theme
        self._show()

    def _show(self) -> None:
        study = self._study
        if self.chooser.currentData() != study.run:
            self.chooser.show_run(study.run)
        self.fault.show_fault(study.fault)
        self.progress.show_progress()
        self.cancel.setVisible(study.busy)
        self.close_loop.setVisible(not study.busy)
        again = bool(self._app_state.path.traced(study.run))
        self.close_loop.setText(self.tr("Work it out again") if again else self.tr("Trace the residual"))
        refused = self._app_state.path.why_no_fit(study.run)
        self.close_loop.setEnabled(bool(study.run) and not study.busy and not refused)
        self.sign.setEnabled(study.loop is not None)
        set_primary(self.close_loop, study.loop is None)
        set_primary(self.sign, study.loop is not None and study.loop.verdict in EXPLAINED)
        self.story.setVisible(study.loop is not None)
        self.empty.setVisible(study.loop is None)
        self._say_empty()
        if study.loop is not None:
            self._show_loop(study.loop)

    def _say_empty(self) -> None:
        """What to do where nothing is traced yet."""
        study, none = self._study, "" if self._study.run else self.chooser.why_none()
        words = self.tr("Choose a run above, then let its residual be traced to a cause.")
        if "loop" in study.waiting:
            words = self.tr("Looking at the residual; a whole preflight takes some minutes.")
        elif study.run:
            refused = self._app_state.path.why_no_fit(study.run)
            trace, kept = self.tr("Trace the residual of this run to its cause."), self._kept()
            words = refused or (kept if self._app_state.path.traced(study.run) else f"{trace}\n{kept}".strip())
        self.empty.setText(none or words)
        self.to_run.setVisible(bool(none))
        height = Qt.AlignmentFlag.AlignBottom if none else Qt.AlignmentFlag.AlignVCenter
        self.empty.setAlignment(height | Qt.AlignmentFlag.AlignHCenter)

    def _kept(self) -> str:
        again = self.tr("Pictures and the figures of each cause are not kept: “Work it out again” makes them.")
        kept = kept_words(self._app_state.path, self._study.run)
        return f"{kept}\n{again}" if kept else ""

    def _show_uncertainty(self) -> None:
        """What makes most of the draft's U: the error at the top is not all that is not known."""
        draft = self._app_state.path.kept(self._study.run)
        self.most_of_U.setText(largest_of_U(draft))
        self.most_of_U.setToolTip(how_to_lower_U(draft))
        self.most_of_U.setVisible(bool(self.most_of_U.text()))

    def _show_loop(self, loop: Loop) -> None:
        words, state = headline(loop)
        self.verdict.setText(words)
        set_state(self.verdict, state)
        self.plainly.setText(said_plainly(loop))
        self.called.setText(called(loop))
        self.called.setVisible(bool(self.called.text()))
        beside = self.tr("These figures are beside the errors that the run declares; above they are in it.")
        noise, above = of_which_error(loop)
        lower = how_to_lower_U(self._app_state.path.kept(self._study.run))
        self.summary.setText("\n".join(filter(None, (f"{in_words(loop.summary)} {beside}", above, lower))))
        before, after = loop.before_nT, loop.after_nT
        self.before_after.setText(f"{format_number(before, signed=False)} → {format_number(after, signed=False)} nT")
        self.noise.setText(noise)
        self.noise.setToolTip(above)
        self._show_uncertainty()
        self._show_unknown(loop)
        self._fill_against(loop)
        self._name_change()
        self._idle_queue.add(self._show_candidates, self._show_bars, self._show_left, self._show_change)

    def _show_bars(self) -> None:
        """As calibrated, with each named cause in turn, and with its rivals instead."""
        if self._study.loop is None:
            return
        loop = self._study.loop
        base = next((e.holdout_rms_before_nT for e in loop.accepted if e.holdout_rms_before_nT), loop.before_nT)
        rows: list[tuple[str, float, tuple[float, float] | None, str]] = [
            (self.tr("as calibrated"), base, None, self._theme.muted)
        ]
        for effect in loop.accepted:
            gain, words = effect.improvement_ci95_nT, in_plain_words(effect, loop.phrases)
            start = effect.holdout_rms_before_nT or base
            interval = (start - gain[1], start - gain[0]) if gain else None
            rows.append((f"+ {words}", effect.holdout_rms_after_nT or base, interval, self._theme.after))
            for rival in effect.rivals:
                instead = self.tr("or {0}").format(in_plain_words(rival, loop.phrases))
                rows.append((instead, rival.holdout_rms_after_nT, None, self._theme.warning))
        self.bars.show_bars(rows, loop.noise_floor_nT)

    def _show_candidates(self) -> None:
        """Every cause with its standing; the reason of the one that is chosen is whole below."""
        if self._study.loop is None:
            return
        self.others.show_loop(self._study.loop, self._theme)
        listed = bool(self.others.rowCount())
        self.others.setVisible(listed)
        self.change_why.setVisible(listed)
        self.none_searched.setVisible(not listed)
        self._name_change()  # what is chosen may be a cause of another answer now

    def picked(self) -> CauseRow | None:
        """What is chosen in the table; None for the loop's own verdict."""
        return None if self._study.loop is None else self.others.picked()

    def _picked(self) -> None:
        if (chosen := self.picked()) is not None:
            self._study.look_at(chosen.cause.effect, chosen.cause.channels)
        if self._study.loop is not None:
            self._fill_against(self._study.loop)
            self._name_change()
            self._idle_queue.add(self._show_change)

    def _show_unknown(self, loop: Loop) -> None:
        lines = [self.tr("Added to it: {0}.").format(one) for one in self._study.measured]
        lines += map(in_words, loop.remarks)
        aside = {name: n for name, n in loop.set_aside.items() if n}
        lines += [self.tr("Rows set aside: {0} {1}").format(n, in_words(name)) for name, n in aside.items()]
        for effect in loop.accepted:
            named, as_well = with_id(effect, loop.phrases), self.tr("“{0}” explains it about as well as “{1}”.")
            lines += [as_well.format(with_id(r, loop.phrases), named) for r in effect.rivals]
        proposed = loop.next_experiment
        procedure = "" if proposed is None else proposed.procedure or ""
        if proposed is not None:
            lines += [in_words(proposed.why), in_words(proposed.do)]
        if procedure:
            lines.append(self.tr("Measured by the procedure {0}.").format(procedure))
        self.unknown.setPlainText("\n\n".join(lines) or self.tr("Nothing that this run could show."))
        self.next.setVisible(bool(procedure))
        tells, misses = self.tr("Measure what would tell them apart"), self.tr("Measure what is missing")
        self.next.setText(misses if not_determined(loop) else tells)
        self.next.setAccessibleDescription(procedure)

    def _fill_against(self, loop: Loop) -> None:
        against, chosen = loop.change.against, self.picked()
        effects: tuple[Cause, ...] = (chosen.cause,) if chosen else loop.accepted
        channels = [c for one in effects for c in one.channels]
        driven = channels or [loop.drawn_against.get(one.effect, "time") for one in effects]
        offer(self.against, sorted(against, key=lambda name: name.split("  ")[0] not in driven), against_words)

    def _show_left(self) -> None:
        if (said := self._study.loop) is not None:
            before = said.change.before
            inks = zip("xyz", self._theme.axes, strict=True)
            clouds = [(axis, ink, before[:, n]) for n, (axis, ink) in enumerate(inks) if n < before.shape[1]]
            noise_nT = said.noise_floor_nT / before.shape[1] ** 0.5
            self.left.show_residual("time  s", said.change.against["time  s"], clouds, noise_nT)

    def _one(self) -> Change | None:
        """What is drawn before and after: all named causes, or the one that is chosen, alone."""
        chosen, loop = self.picked(), self._study.loop
        if chosen is not None:
            return self._study.causes.get(cause_name(chosen.cause.effect, chosen.cause.channels))
        return None if loop is None else loop.change

    def _name_change(self) -> None:
        """Whose change it is, why it stands as it does, and how much it is."""
        chosen, one = self.picked(), self._one()
        title = self.tr("2  What it changes") if chosen is None else self.tr("2  With “{0}”").format(chosen.words)
        self.change_heading.setText(title)
        self.change_heading.setToolTip(title)
        choose = self.tr("Choose one to see what it alone would change.")
        self.change_why.setText(choose if chosen is None else f"{chosen.words}: {chosen.why}")
        rename(self.change_why, "caption" if chosen is None else "")
        if one is None:
            return self.change_words.setText(self.tr("computing …") if self._study.busy else "")
        self.change_words.setText("")
        if chosen is not None:  # of all named causes it is said at the top
            left = format_number(float(np.sqrt(np.nanmean(np.sum(one.after**2, axis=1)))), signed=False)
            self.change_words.setText(self.tr("it alone would leave {0} nT of the rows of the fit").format(left))
        return None

    def _show_change(self) -> None:
        one, said, theme, name = self._one(), self._study.loop, self._theme, self.against.currentData()
        if one is None or said is None or name not in one.against:
            return self.change.clear()
        before, after = one.before, one.after
        noise_nT = said.noise_floor_nT / before.shape[1] ** 0.5
        both = [(self.tr("as calibrated"), theme.before, before), (self.tr("with it"), theme.after, after)]
        return self.change.show_residual(name, one.against[name], both, noise_nT)
