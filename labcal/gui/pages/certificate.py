"""Certificate: drafts, approve and sign by two persons, verify a dropped file, reports and exports."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TypeVar

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import (
    QComboBox,
    QGridLayout,
    QHBoxLayout,
    QLineEdit,
    QListWidget,
    QVBoxLayout,
    QWidget,
)

from labcal.gui.ipc.answers import CalibrationFile, Standing
from labcal.gui.ipc.messages import (
    Approve,
    ChangedSince,
    Command,
    ListCalibrations,
    ListKeys,
    NewKey,
    Sign,
    VerifyFile,
)
from labcal.gui.ipc.wire import Fault
from labcal.gui.pages.certificate_paper import Paper
from labcal.gui.theming.theme import GRID, Theme
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.calibration_rows import PARAMETERS
from labcal.gui.viewmodels.signing import next_step, standing_word, state_of
from labcal.gui.widgets.calibration_views import CalibrationViews
from labcal.gui.widgets.common import Card, button, label, plain, say_wanted, set_state
from labcal.gui.widgets.drop_zone import Drop
from labcal.gui.widgets.fault_card import FaultCard
from labcal.gui.widgets.kept_focus import focus_kept_in
from labcal.gui.widgets.measurement_table import Table
from labcal.gui.widgets.stated_fields import StatedFields
from labcal.system.private_memory import kept_private

R = TypeVar("R")


class CertificatePage(QWidget):
    """Calibrations of this lab at the left; the chosen one, and what may be done with it, beside them."""

    def __init__(self, app_state: AppState, theme: Theme) -> None:
        super().__init__()
        self._app_state = app_state
        self._files: dict[str, CalibrationFile] = {}
        self._wanted = ""
        column = QVBoxLayout(self)
        column.setContentsMargins(2 * GRID, 2 * GRID, 2 * GRID, 2 * GRID)
        column.setSpacing(2 * GRID)
        self.fault = FaultCard()
        self.fault.report_requested.connect(app_state.report_requested)
        column.addWidget(self.fault)
        row = QHBoxLayout()
        row.setSpacing(2 * GRID)
        row.addWidget(self._list_card(), 2)
        self.detail = self._detail_card(theme)
        row.addWidget(self.detail, 3)
        column.addLayout(row, 1)
        self.drop = Drop()
        self.drop.dropped.connect(self.verify)
        column.addWidget(self.drop)
        app_state.calibrations_changed.connect(self._new)
        app_state.quick_worker.progress.connect(self.said.setText)  # a run that is worked out again

    def showEvent(self, event: object) -> None:
        """What there is now."""
        self.refresh()

    def hideEvent(self, event: object) -> None:
        """No passphrase waits here for whoever comes next."""
        for entry in (self.passphrase, self.again):
            entry.clear()

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

    def _list_card(self) -> Card:
        card = Card(self.tr("Calibrations"))
        self.list = QListWidget()
        self.list.setAccessibleName(self.tr("Calibrations, the newest first"))
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.list.currentRowChanged.connect(self._show)
        self.empty = label(self.tr("None yet. Fit a run, then trace its residual: that writes a draft."), wrap=True)
        to_fit = button(self.tr("Go to Fit"), self.tr("Estimate a calibration"), primary=True)
        to_fit.clicked.connect(lambda: self._app_state.page_requested.emit("Fit"))
        self.to_fit = to_fit
        card.body.addWidget(self.empty)
        card.body.addWidget(to_fit, 0, Qt.AlignmentFlag.AlignLeft)
        card.body.addWidget(self.list, 1)
        card.body.addStretch()
        return card

    def _detail_card(self, theme: Theme) -> Card:
        card = Card(self.tr("Chosen calibration"), self.tr("U: k=2"))
        self.heading, self.standing = card.heading, label("", wrap=True)
        self.table = Table(PARAMETERS)
        self.views = CalibrationViews(self.table, theme)
        card.body.addWidget(self.standing)
        card.body.addWidget(self.views)
        card.body.addWidget(self.table, 1)
        card.body.addWidget(self.views.remark)
        self.next = label("", "", wrap=True)
        card.body.addWidget(self.next)
        card.body.addLayout(self._approve_row())
        card.body.addLayout(self._sign_row())
        self.paper = Paper(self._app_state, self.chosen, self.fault)
        self.said = self.paper.said
        card.body.addWidget(self.paper)
        return card

    def _approve_row(self) -> QHBoxLayout:
        self.approver = QComboBox()
        self.approver.setEditable(True)
        say_wanted(self.approver, self.tr("Who approves"))
        self.approver.setToolTip(
            self.tr("Another person than the operator, by the name that they sign under; written before anybody signs")
        )
        self.approver.currentTextChanged.connect(self._enable)
        self.approve = button(
            self.tr("Approve"),
            self.tr("Write this name into the draft. After the first signature nobody can be added."),
        )
        self.approve.clicked.connect(self._approve)
        row = QHBoxLayout()
        row.addWidget(label(self.tr("1"), "title"))
        self.stated = StatedFields()
        row.addWidget(self.approver, 1)
        row.addWidget(self.stated.superseded, 1)
        row.addWidget(self.approve)
        return row

    def _sign_row(self) -> QGridLayout:
        self.signer = QComboBox()
        self.signer.setEditable(True)
        say_wanted(self.signer, self.tr("Who signs"))
        self.signer.setToolTip(self.tr("Whose key; a name without a key here can be given a new one"))
        self.signer.currentTextChanged.connect(self._enable)
        self.passphrase = QLineEdit()
        self.passphrase.setPlaceholderText(self.tr("Passphrase"))
        self.passphrase.setToolTip(self.tr("Asked each time, never kept"))
        self.again = QLineEdit()
        self.again.setPlaceholderText(self.tr("Once more"))
        self.again.setToolTip(self.tr("A new key's passphrase is typed twice: nothing can bring it back"))
        for entry in (self.passphrase, self.again):
            entry.setAccessibleName(entry.placeholderText())
            entry.setEchoMode(QLineEdit.EchoMode.Password)
            entry.textEdited.connect(lambda _: kept_private())  # no core dump holds what is typed
            entry.textChanged.connect(self._enable)
        self.sign = button(
            self.tr("Sign"), self.tr("Sign these exact bytes. A signed file can no longer be changed."), primary=True
        )
        self.sign.clicked.connect(self._sign)
        self.new_key = button(
            self.tr("New key"), self.tr("Make a key for this name under this passphrase, and trust it in this lab")
        )
        self.new_key.clicked.connect(self._new_key)
        self.new_key.hide()
        grid = QGridLayout()
        grid.addWidget(label(self.tr("2"), "title"), 0, 0)
        grid.addWidget(self.signer, 0, 1, 1, 2)
        grid.addWidget(self.stated.until, 0, 3)
        grid.addWidget(self.passphrase, 1, 1)
        grid.addWidget(self.again, 1, 2)
        for widget in (self.new_key, self.sign):
            grid.addWidget(widget, 1, 3)
        grid.setColumnStretch(1, 1)
        return grid

    def chosen(self) -> CalibrationFile | None:
        """The calibration that is chosen."""
        row = self.list.currentRow()
        return self._files.get(self.list.item(row).data(Qt.ItemDataRole.UserRole)) if row >= 0 else None

    def _known(self, files: tuple[CalibrationFile, ...]) -> None:
        self._app_state.path.take_calibrations(files)
        before = self.chosen()
        kept = self._wanted or (before.path if before is not None else "")
        self._files = {one.path: one for one in files}
        quiet = QSignalBlocker(self.list)  # with none chosen for a moment, what has the focus would lose it
        self.list.clear()
        for one in files:
            simulated = f"\n{translated('SIMULATED')}" if one.simulated else ""
            self.list.addItem(f"{standing_word(one.standing)}  {one.dut.serial}\n{Path(one.path).stem}{simulated}")
            self.list.item(self.list.count() - 1).setData(Qt.ItemDataRole.UserRole, one.path)
        paths = list(self._files)
        self.list.setCurrentRow(paths.index(kept) if kept in paths else 0)
        quiet.unblock()
        for widget in (self.empty, self.to_fit):
            widget.setVisible(not files)
        self._wanted = ""
        self._show()

    def _keys_known(self, names: tuple[str, ...]) -> None:
        for chooser, first in ((self.signer, names[0] if names else ""), (self.approver, "")):
            typed = chooser.currentText()
            chooser.clear()
            chooser.addItems(names)
            chooser.setCurrentText(typed or first)
            if (line := chooser.lineEdit()) is not None and not line.hasFocus():
                line.setCursorPosition(0)  # of a long one its beginning is seen
        self._enable()

    def _show(self) -> None:
        one = self.chosen()
        self.stated.show_draft(one, self._files.values())
        self.detail.setVisible(one is not None)
        self.list.setVisible(bool(self._files))
        if one is not None:
            self.heading.setText(f"{one.dut.serial}  ·  {one.run_id}")
            self.heading.setToolTip(plain(self.heading.text()))  # the whole, where there is no room for it
            standing = one.standing
            draft = not standing.signatures
            state = "" if draft else state_of(standing)
            approved = ", ".join(one.approvers) or self.tr("nobody yet")
            words = [self.tr("Draft: not signed.")] if draft else list(map(in_words, standing.sentences))
            words += [in_words("SIMULATED: it describes no real sensor.")] if draft and one.simulated else []
            words.append(self.tr("Operator {0}; approved by {1}.").format(one.operator or "–", approved))
            self.standing.setText(" ".join(words))
            set_state(self.standing, state)
            self.views.show_calibration(one)
            ask, known = self._app_state.quick_worker.request, partial(self.views.show_changes, one.path)
            ask(ChangedSince(one.path), known, self.fault.show_fault)
        self._enable()

    def _enable(self) -> None:
        one, name = self.chosen(), self.signer.currentText().strip()
        known = self.signer.findText(name, Qt.MatchFlag.MatchExactly | Qt.MatchFlag.MatchCaseSensitive) >= 0
        words, twice = bool(self.passphrase.text()), self.passphrase.text() == self.again.text()
        new = not known and (bool(name) or not self.signer.count())  # where nobody has a key, one is made first
        for widget, shown in ((self.again, new), (self.new_key, new), (self.sign, not new)):
            widget.setVisible(shown)
        draft = one is not None and not one.standing.signatures
        self.approver.setEnabled(draft)  # nobody can be added after the first signature
        self.approve.setEnabled(draft and bool(self.approver.currentText().strip()))
        self.sign.setEnabled(one is not None and known and words)
        self.new_key.setEnabled(new and bool(name) and words and twice)
        self.begins_at = self.passphrase if name else self.signer
        self.paper.setEnabled(one is not None)
        step = next_step(one, self._app_state.lab.state.operator) if one else ""
        if new and self.again.text() and not twice:
            step = self.tr("The two passphrases differ.")
        elif new and not name:
            step = self.tr("{0} Nobody has a key here: write who signs, a passphrase twice, then New key.").format(step)
        elif new:
            step = self.tr("{0} has no key here: type a passphrase twice, and New key makes one under it.").format(name)
        elif known and not words and draft:
            step = self.tr("{0} To sign as {1}, type the passphrase.").format(step, name)
        self.next.setText(step)

    def _approve(self) -> None:
        if (one := self.chosen()) is not None:
            name = self.approver.currentText().strip()
            self._ask(Approve(one.path, name, *self.stated.stated()), self.approver, self._approved)

    def _approved(self) -> None:
        self.approver.setCurrentText("")
        self.signer.setFocus()

    def _sign(self) -> None:
        if (one := self.chosen()) is not None:
            name, passphrase = self.signer.currentText(), self.passphrase.text()
            command = Sign(one.path, name, passphrase, *self.stated.stated())
            self._ask(command, self.passphrase, self.signer.setFocus)
            self.passphrase.clear()

    def _ask(self, command: Command[R], entry: QWidget, then: Callable[[], object]) -> None:
        """`entry` is where the person goes on where it is refused."""

        def known(_: R) -> None:
            self.said.clear()
            then()
            self.refresh()

        def refused(fault: Fault) -> None:
            self.said.clear()
            self.fault.show_fault(fault)
            entry.setFocus()

        self.fault.show_fault(None)
        self._app_state.quick_worker.request(command, known, refused)

    def _new_key(self) -> None:
        name = self.signer.currentText().strip()
        made = self.tr("{0} has a key now, under this passphrase.").format(name)

        def known() -> None:
            if self.signer.findText(name, Qt.MatchFlag.MatchExactly | Qt.MatchFlag.MatchCaseSensitive) < 0:
                self.signer.addItem(name)  # nobody waits for the new list
            with focus_kept_in(self, self.approver, self.signer):
                self._enable()
            self.said.setText(made)

        self._ask(NewKey(name, self.passphrase.text()), self.signer, known)
        with focus_kept_in(self, self.passphrase):  # the button is grey without the second one
            self.again.clear()

    def verify(self, path: str) -> None:
        """Check the file at `path` and say how it stands."""
        self._app_state.quick_worker.request(VerifyFile(path), self._verified, self.fault.show_fault)

    def _verified(self, said: Standing) -> None:
        self.said.clear()
        shape = {"bad": "✕", "warning": "▲", "good": "✓"}[state_of(said)]
        faults = [f"{one.file}: {one.objection}" for one in said.signatures if one.objection]
        words = " ".join([*map(in_words, said.sentences), *faults])
        self.drop.words.setText(f"{shape} {Path(said.path).name}: {words}")
        set_state(self.drop.words, state_of(said))
