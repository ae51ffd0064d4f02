"""Certificate: what a file is and where it stands, its steps to the customer, and its figures; any file is verified."""

from __future__ import annotations

from datetime import datetime
from functools import partial
from pathlib import Path

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import QApplication, QHBoxLayout, QVBoxLayout, QWidget

from labcal.gui.ipc.answers import CalibrationFile, Standing
from labcal.gui.ipc.messages import ChangedSince, ListCalibrations, ListKeys, VerifyFile
from labcal.gui.ipc.record_messages import TellRecord
from labcal.gui.pages.certificate_paper import Paper
from labcal.gui.pages.certificate_steps import SigningSteps
from labcal.gui.theming.theme import GRID, Theme
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.calibration_rows import PARAMETERS
from labcal.gui.viewmodels.signing import SigningStep, doubts, file_state, file_word, handed_out_as, state_of, steps
from labcal.gui.viewmodels.stages import stages, to_be_done
from labcal.gui.viewmodels.told_words import open_words
from labcal.gui.viewmodels.untraced import comes_first, next_is, not_traced
from labcal.gui.widgets.calibration_views import CalibrationViews
from labcal.gui.widgets.common import Card, button, combo_box, flat, label, plain, set_state
from labcal.gui.widgets.drop_zone import Drop
from labcal.gui.widgets.fault_card import FaultCard
from labcal.gui.widgets.kept_place import place_kept
from labcal.gui.widgets.measurement_table import Table
from labcal.gui.widgets.names_card import NamesCard
from labcal.gui.widgets.open_externally import WrittenAt
from labcal.gui.widgets.run_chooser import run_name
from labcal.record.told import Told

MOST_ROWS = 80  # of the table are seen without rolling it


class CertificatePage(QWidget):
    """The chosen calibration, where it stands, its four steps from draft to file, and its figures below them."""

    opens_at_top = True  # how the file stands, before what is to be done with it
    shows_only = True  # where there is no room for it the page is scrolled, and nothing in it is squeezed

    def __init__(self, app_state: AppState, theme: Theme) -> None:
        super().__init__()
        self._app_state = app_state
        self._files: dict[str, CalibrationFile] = {}
        self._wanted, self._told_of = app_state.one_dut.take_wanted(), ""
        self._for = self._asked_for = ""  # this DUT it was chosen
        self._copies: dict[str, str] = {}  # handed out: where it lies, and of which file it is
        column = QVBoxLayout(self)
        column.setContentsMargins(2 * GRID, 2 * GRID, 2 * GRID, 2 * GRID)
        column.setSpacing(2 * GRID)
        self.fault = FaultCard()
        self.fault.report_requested.connect(app_state.report_requested)
        self.names = NamesCard(app_state, self.fault, self._names_known)
        self.steps = SigningSteps(app_state, self.chosen, self.fault, self._done, self.names.lacks)
        self.lies = WrittenAt()  # once it is signed
        self.paper = Paper(app_state, self.chosen, self.fault)
        self.said = self.paper.said
        self.paper.handed_out.connect(self._handed_out)
        self.list = combo_box(self.tr("Calibrations, the newest first"))
        self.list.setPlaceholderText(self.tr("Choose a calibration"))
        self.list.currentIndexChanged.connect(self._show)
        self.figures, self.empty_card = self._figures_card(theme), flat(self._empty_card())
        self.drop = flat(Drop(self.list))
        self.drop.dropped.connect(self.verify)
        self.drop.closed.connect(self._show)
        self.drop.open_at(app_state.path.handed_out.folder())
        column.addWidget(self.drop)
        column.addWidget(self.empty_card)
        column.addWidget(flat(self._chosen_card()))
        for part in (self.fault, self.names, self.steps, self.lies, self.paper):
            column.addWidget(part)
        column.addWidget(self.figures, 1)
        column.addStretch()
        app_state.calibrations_changed.connect(self._new)
        app_state.one_dut.changed.connect(self._other_dut)
        app_state.one_dut.file_wanted.connect(self._turn)
        app_state.quick_worker.progress.connect(self._say_progress)
        app_state.path.changed.connect(self._say_path)
        self._show()

    def showEvent(self, event: object) -> None:
        """What there is now."""
        self.refresh()

    def hideEvent(self, event: object) -> None:
        """No passphrase waits here for whoever comes next."""
        self.steps.forget()

    def set_theme(self, theme: Theme) -> None:
        """Results in the theme's colours."""
        self.views.set_theme(theme)

    def refresh(self) -> None:
        """Ask for the calibrations and the keys again."""
        self._app_state.quick_worker.request(ListCalibrations(), self._known, self.fault.show_fault)
        self._app_state.quick_worker.request(ListKeys(), self._keys_known, self.fault.show_fault)

    def _new(self, path: str) -> None:
        self._wanted = path
        self.refresh()

    def _turn(self) -> None:
        """To the file that Next speaks of, at once where it is listed here."""
        path = self._app_state.one_dut.take_wanted()
        if (index := self.list.findData(path)) >= 0:
            return self.list.setCurrentIndex(index)
        return self._new(path)

    def _other_dut(self) -> None:
        """What is of another DUT than the one that is looked at does not stay in sight, unless it was chosen here."""
        one_dut = self._app_state.one_dut
        gone_back = one_dut.calibration is None and self.chosen() is not None
        if self.isVisible() and (gone_back or one_dut.looked_at() not in (self._for, self._asked_for)):
            self._asked_for = one_dut.looked_at()
            if gone_back:
                self.list.setCurrentIndex(-1)
            self.refresh()

    def _empty_card(self) -> Card:
        card = Card()
        self.empty = label("", wrap=True)
        self.to_fit = button("", self.tr("The page where that is done"), primary=True)
        self.to_fit.clicked.connect(self._app_state.next_requested)
        card.body.addWidget(self.empty)
        card.body.addWidget(self.to_fit, 0, Qt.AlignmentFlag.AlignLeft)
        return card

    def _chosen_card(self) -> Card:
        """How the chosen one stands, in a word and in sentences."""
        self.detail = Card()
        self.word, self.standing = label("", "ask", wrap=True), label("", wrap=True)
        self.stage, self.to_do = label("", wrap=True), label("", "title")
        self.named = label("", "caption", wrap=True)
        self.doubt = label("", wrap=True)  # of the cause: no signature takes it away
        self.open = label("", wrap=True)  # of the run's own checks, before anybody approves
        for part in (self.doubt, self.open):
            set_state(part, "warning")
        head = QHBoxLayout()
        head.addWidget(self.word, 1)
        head.addWidget(self.to_do)
        self.detail.body.addLayout(head)
        for part in (self.stage, self.doubt, self.standing, self.open, self.named):
            self.detail.body.addWidget(part)
        return self.detail

    def _figures_card(self, theme: Theme) -> Card:
        card = Card()  # its tabs are its heading
        self.table = Table(PARAMETERS)
        self.table.show_rows(MOST_ROWS)
        self.views = CalibrationViews(self.table, theme)
        card.unit.setText(self.tr("U: k=2"))
        card.unit.setToolTip(
            self.tr(
                "± U (k=2) is of the parameter in its line alone. That of a component of the field, its mounting "
                "included, is under Uncertainty; rms on the Fit and Loop pages is standard (k=1)."
            )
        )
        head = QHBoxLayout()
        head.addWidget(self.views, 1)
        head.addWidget(card.unit, 0, Qt.AlignmentFlag.AlignTop)
        card.body.addLayout(head)
        for part in (self.table, self.views.remark):
            card.body.addWidget(part)
        card.body.addStretch()
        return card

    def chosen(self) -> CalibrationFile | None:
        """The calibration that is chosen."""
        return self._files.get(self.list.currentData() or "")

    def _known(self, files: tuple[CalibrationFile, ...]) -> None:
        self._app_state.path.take_calibrations(files)
        before = self.chosen()
        here = self._app_state.one_dut.looked_at()
        mine = [one.path for one in files if one.dut.serial == here]
        stays = self._app_state.one_dut.calibration is not None  # else another DUT was said since it was chosen
        stays = stays and before is not None and here in (self._for, before.dut.serial)
        self._files = {one.path: one for one in files}
        kept = before.path if before is not None and stays else next(iter(mine), "")
        kept = self._wanted if self._wanted in self._files else kept
        if here != self._for:
            self.drop.put_away()
        self._for = self._asked_for = here
        with QSignalBlocker(self.list):
            self.list.clear()
            for one in files:
                self.list.addItem(f"{file_word(one)}  ·  {self._of(one)}", one.path)
            self.list.setCurrentIndex(self.list.findData(kept))  # none by itself, where none is of the DUT at the top
        self._wanted = ""
        self._show()

    def _of(self, one: CalibrationFile) -> str:
        """Of which DUT and run it is, as on every page; by its file's name where that run is not in the store."""
        run = next((line for line in self._app_state.path.runs if line.run_id == one.run_id), None)
        simulated = translated("SIMULATED") if one.simulated else ""
        words = "  ·  ".join(filter(None, (one.dut.serial, Path(one.path).stem, simulated)))
        return words if run is None or run.dut_serial != one.dut.serial else run_name(run)

    def _say_empty(self) -> None:
        here, to = self._app_state.one_dut.looked_at(), self._app_state.path.next()
        none = self.tr("No calibration of {0} yet: a fit, and the trace of what it leaves, write a draft.").format(here)
        which = none if here else self.tr("Choose a calibration, or say at the top which DUT.")
        self.empty.setText(which)
        self.to_fit.setVisible(to.page != "Certificate" and not to.off)
        self.to_fit.setText(to.words)

    def _keys_known(self, names: tuple[str, ...]) -> None:
        self.steps.take_keys(names)
        self._show_steps()

    def _show(self) -> None:
        one = self.chosen()
        self._app_state.one_dut.take_calibration(one)
        self.empty_card.setVisible(one is None)
        self.list.setVisible(bool(self._files))
        self._say_empty()
        for part in (self.detail, self.steps, self.paper, self.figures):
            part.setVisible(one is not None)
        self.steps.show_file(one, self._files.values())
        signed = one is not None and bool(one.standing.signatures)
        self.lies.show_file(self.tr("The signed file is {0}, in the folder {1}"), one.path if one and signed else "")
        if one is None:
            self.names.show_file(None)
        if one is not None:
            self.list.setToolTip(plain(self.list.currentText()))  # the whole, where there is no room for it
            self.word.setText(f"{file_word(one).upper()}  ·  {one.dut.serial}")
            self.standing.setText("\n".join(self._standing_words(one)))
            self.names.show_file(one)
            set_state(self.word, file_state(one))
            if one.run_id != self._told_of:
                self._told_of = one.run_id
                self._run_told(one.run_id, Told())
            self.views.show_calibration(one)
            ask, known = self._app_state.quick_worker.request, partial(self.views.show_changes, one.path)
            ask(ChangedSince(one.path), known, self.fault.show_fault)
            ask(
                TellRecord(one.run_id),
                partial(self._run_told, one.run_id),
                lambda _: self._run_told(one.run_id, Told()),
            )
        self._show_steps()

    def _run_told(self, run: str, told: Told) -> None:
        """What the run itself left open stands above the approval."""
        if (one := self.chosen()) is not None and one.run_id == run:
            self.open.setText(open_words(told))
            self.open.setVisible(bool(self.open.text()))

    def _standing_words(self, one: CalibrationFile) -> list[str]:
        """How it stands, who measured and who approved: a line each."""
        draft = not one.standing.signatures
        signed = () if draft else one.standing.sentences  # that it is a draft, or unexplained, is said above
        words = [in_words(said) for said in signed if said != one.unexplained]
        words += [in_words("SIMULATED: it describes no real sensor.")] if draft and one.simulated else []
        operator, approved = one.operator or "–", ", ".join(one.approvers) or (self.tr("nobody yet") if draft else "")
        who = self.tr("Operator {0}; approved by {1}.") if approved else self.tr("Operator {0}.")
        return [*words, who.format(operator, approved)]

    def stands(self, one: CalibrationFile) -> tuple[SigningStep, SigningStep, SigningStep, SigningStep]:
        """How its steps stand."""
        path, operator = self._app_state.path, self._app_state.lab.state.operator
        return steps(one, self.steps.keys, operator, handed_out=path.handed_out.holds(one))

    def _show_steps(self) -> None:
        self.steps.check()
        if (one := self.chosen()) is not None:
            stands = self.stands(one)
            self.steps.show_steps(stands)
            self.paper.show_step(stands[-1])
            kept = self._app_state.path.handed_out
            self.stage.setText(stages(one, handed_out=kept.holds(one), verified=kept.verified(one)))
            self.stage.setVisible(all(step.mark != "now" for step in stands))  # else the cards below say it
            self._say_to_do(one, stands)
            self._show_named()
            set_state(self.paper.words, "warning" if handed_out_as(one) else "")

    def _say_progress(self, step: str) -> None:
        """Of a run that is worked out again."""
        self.said.setText(in_words(step))

    def _say_path(self) -> None:
        """What Next says, here as in the bar below."""
        self._say_empty()
        if (one := self.chosen()) is not None:
            self._say_to_do(one, self.stands(one))

    def _say_to_do(self, one: CalibrationFile, stands: tuple[SigningStep, ...]) -> None:
        """What is next, and why who approves has to think."""
        path = self._app_state.path
        step = to_be_done([step.mark for step in stands])
        path.take_step(one, step)
        self.to_do.setText(comes_first(path, one) or next_is(path, one, step))
        self.doubt.setText(" ".join(filter(None, (doubts(one), not_traced(path, one)))))
        for part in (self.to_do, self.doubt):
            part.setVisible(bool(part.text()))

    def _names_known(self, waits: bool) -> None:
        """`waits`: whoever stated them goes on with what is next."""
        self.steps.names_known()
        self._show_named()
        if waits and self.begins_at.isEnabled():
            self.begins_at.setFocus(Qt.FocusReason.OtherFocusReason)

    def _show_named(self) -> None:
        """By whom and for whom it is; before it is signed the card below asks for who is not named."""
        self.named.setText("" if self.names.isVisibleTo(self) else self.names.line())
        self.named.setVisible(bool(self.named.text()))

    @property
    def begins_at(self) -> QWidget:
        """Where what is to be done now begins."""
        if (one := self.chosen()) is None:
            return self.to_fit
        stands = self.stands(one)
        return self.paper.export if stands[-1].mark in ("now", "done") else self.steps.begins_at(stands)

    def _done(self, words: str, one: CalibrationFile | None) -> None:
        """What was done, in the window's line too; who is at work here goes on with what is next."""
        self._app_state.lab.update(message=words)
        here = QApplication.focusWidget()
        at_work = here is not None and self.isAncestorOf(here)
        if one is not None:
            self._files[one.path] = one
        with place_kept(self):  # how it stands now is said at the top
            self._show()
            if at_work and self.begins_at.isEnabled():
                self.begins_at.setFocus(Qt.FocusReason.OtherFocusReason)
        self.refresh()

    def _handed_out(self, one: CalibrationFile, copy: str) -> None:
        """What has left is checked as it lies there."""
        self._copies[copy], folder = one.path, str(Path(copy).parent)
        self._app_state.path.handed_out.take_folder(folder)
        self.drop.open_at(folder)
        self._app_state.path.take_handed_out(one)
        self._app_state.lab.update(message=self.tr("{0} is handed out.").format(one.dut.serial))
        self._show_steps()
        self.verify(copy)

    def verify(self, path: str) -> None:
        """Check the file at `path` and say how it stands."""
        self._app_state.quick_worker.request(VerifyFile(path), self._verified, self.fault.show_fault)

    def _verified(self, said: Standing) -> None:
        if said.path not in self._copies:
            self.said.clear()
        shape = {"bad": "✕", "warning": "▲", "good": "✓"}[state_of(said)]
        faults = [f"{one.file}: {one.objection}" for one in said.signatures if one.objection]
        beside = self.tr(
            "Its signatures are files beside it, {0}.sshsig: copy them into its folder, and verify it again."
        )
        lost = [] if said.signatures else [beside.format(Path(said.path).name)]
        words = " ".join([*map(in_words, said.sentences), *faults, *lost])
        checked = self.tr("checked at {0}").format(f"{datetime.now():%H:%M:%S}")
        self.drop.say(f"{shape} {Path(said.path).name}", f"{checked}: {words}", state_of(said))
        chosen = self.chosen()
        if chosen is not None and self._copies.get(said.path, said.path) != chosen.path:
            self.detail.hide()  # no RELEASED of another file stands below this one's verdict
        if (one := self._files.get(self._copies.get(said.path, said.path))) is not None and said.valid:
            self._app_state.path.handed_out.verify(one)
            self._show_steps()
