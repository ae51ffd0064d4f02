"""The steps from a draft to a signed file: a key, an approval, signatures."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from typing import TypeVar

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import QComboBox, QLabel, QLineEdit, QWidget

from labcal.gui.ipc.answers import CalibrationFile
from labcal.gui.ipc.messages import Approve, Command, NewKey, Sign
from labcal.gui.ipc.wire import Fault
from labcal.gui.translations.sentences import in_words
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.key_rules import approver_objection, as_key_name, key_name_objection, key_objection
from labcal.gui.viewmodels.signing import SigningStep, awaited, doubts, until_words, valid_words
from labcal.gui.widgets.barcode_scanner import takes_names
from labcal.gui.widgets.common import button, combo_box, label, say_wanted, set_state
from labcal.gui.widgets.fault_card import FaultCard
from labcal.gui.widgets.kept_place import place_kept
from labcal.gui.widgets.secret import secret_entry
from labcal.gui.widgets.stated_fields import StatedFields
from labcal.gui.widgets.step_card import StepCard, StepRow
from labcal.record.person import perhaps_one_person

R = TypeVar("R")


class SigningSteps(StepRow):
    """1 Key, 2 Approve, 3 Sign, of what `chosen` gives; `done` gets what was done, and the file as it is then."""

    def __init__(
        self,
        app_state: AppState,
        chosen: Callable[[], CalibrationFile | None],
        fault: FaultCard,
        done: Callable[[str, CalibrationFile | None], object],
        lacks: Callable[[], str],
    ) -> None:
        """`lacks`: whom the certificate will not name, as a sentence; asked about before a signature."""
        super().__init__()
        self._app_state, self._chosen, self._fault, self._done = app_state, chosen, fault, done
        self._lacks = lacks
        self.keys: tuple[str, ...] = ()
        self._shown = ""  # of this file is what was done
        self.stated = StatedFields()
        self.signer, self.approver = QComboBox(), QComboBox()
        self.key, self.approval, self.signature = self._key_card(), self._approve_card(), self._sign_card()
        self.stated.until.textChanged.connect(self.check)
        self.hold((self.key, self.approval, self.signature))

    def _key_card(self) -> StepCard:
        card = StepCard(
            self.tr("1  Key"),
            self.tr(
                "Name: letters, digits and . _ @ + - without blanks, as ada.smith. Passphrase: ten characters or more, "
                "no single common word, row of keys or name; four words are easy to keep; nothing brings it back."
            ),
        )
        self.key_name = QLineEdit()
        self.key_name.setPlaceholderText(self.tr("Whose key"))
        self.new_words = self._secret(self.tr("New passphrase"), self.tr("Of the new key; asked at each signature"))
        self.again = self._secret(self.tr("Once more"), self.tr("Typed twice: nothing can bring it back"))
        self.key_name.setToolTip(self.tr("The name that this person signs under"))
        self.key_name.setAccessibleName(self.tr("Whose key"))
        takes_names(self.key_name)
        self.key_name.textChanged.connect(self.check)
        self.key_name.editingFinished.connect(self._offer_name)
        self.new_key = button(self.tr("New key"), self.tr("Make a key for this name, and trust it in this lab"))
        self.new_key.clicked.connect(self._new_key)
        card.put((self.key_name, self.new_words, self.again), self.new_key)
        return card

    def _approve_card(self) -> StepCard:
        card = StepCard(
            self.tr("2  Approve"),
            self.tr(
                "No passphrase: an approval is a name in the draft. It binds once this person has signed (3). "
                "After the first signature nobody can be added."
            ),
        )
        self.approver = QComboBox()
        self.approver.setEditable(True)
        if (typed := self.approver.lineEdit()) is not None:
            takes_names(typed)
        self.approver.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        say_wanted(self.approver, self.tr("Who approves"))
        self.approver.setAccessibleName(self.tr("Who approves"))
        self.approver.setToolTip(self.tr("Another person than the operator, by the name that they sign under"))
        self.approver.currentTextChanged.connect(self.check)
        self.approve = button(self.tr("Approve"), self.tr("Write this name into the draft"))
        self.approve.clicked.connect(self._approve)
        card.put((self.approver, self.stated.superseded, self.stated.until), self.approve)
        self.valid_once_approved = self._valid_in(card)
        return card

    def _sign_card(self) -> StepCard:
        card = StepCard(self.tr("3  Sign"), self.tr("These exact bytes: a signed file can no longer be changed."))
        self.signer = combo_box(self.tr("Who signs, of those who have a key here"), self.tr("Who signs"), letters=6)
        self.signer.setPlaceholderText(self.tr("Who signs"))
        self.signer.currentTextChanged.connect(self.check)
        self.passphrase = self._secret(self.tr("Passphrase"), self.tr("Of this person's key; asked each time"))
        self.sign = button(self.tr("Sign"), self.tr("Sign the file as it is"))
        self.sign.clicked.connect(self._sign)
        self.passphrase.returnPressed.connect(self._enter)
        card.put((self.signer, self.passphrase), self.sign)
        self.valid = self._valid_in(card)
        return card

    def _valid_in(self, card: StepCard) -> QLabel:
        """Until when it is good, said in the step that states it, and again in the one that binds it."""
        valid = label("", wrap=True)
        valid.setAccessibleName(self.tr("Until when it is good"))
        card.body.insertWidget(card.body.indexOf(card.words), valid)
        card.while_open.append(valid)
        return valid

    def _secret(self, name: str, tip: str) -> QLineEdit:
        entry = secret_entry(name, tip)
        entry.textChanged.connect(self.check)
        return entry

    def forget(self) -> None:
        """No passphrase waits here for whoever comes next."""
        for entry in (self.new_words, self.again, self.passphrase):
            entry.clear()

    def take_keys(self, names: tuple[str, ...]) -> None:
        """Who has a key here."""
        self.keys = names
        self._offer()
        self.check()

    def show_file(self, one: CalibrationFile | None, others: Iterable[CalibrationFile]) -> None:
        """Another file, or the same as it stands now."""
        self.stated.show_draft(one, others)
        self._offer()
        if (path := "" if one is None else one.path) != self._shown:
            self._shown = path
            for card in (self.key, self.approval, self.signature):
                card.say_done("")
            self._ask_before_approval("")
            self._ask_before_signing("")

    def _offer(self) -> None:
        """Who may approve, and who is to sign next."""
        one, typed, signs = self._chosen(), self.approver.currentText(), self.signer.currentText()
        operator = self._operator(one)
        others = [name for name in self.keys if not perhaps_one_person(name, operator)]
        with QSignalBlocker(self.approver), QSignalBlocker(self.signer):
            self.approver.clear()
            self.approver.addItems(others)
            open_still = one is not None and not (one.approvers or one.standing.signatures or one.not_measured)
            self.approver.setCurrentText(typed or (others[0] if others and open_still else ""))
            self.signer.clear()
            self.signer.addItems(self.keys)
            self.signer.setCurrentIndex(self.signer.findText(self._signs_next(one, signs)))

    def _signs_next(self, one: CalibrationFile | None, before: str) -> str:
        """Whoever is awaited, else who was chosen, else the operator."""
        waiting = [] if one is None else [name for name in awaited(one) if name in self.keys]
        own = [name for name in self.keys if perhaps_one_person(name, self._operator(one))]
        before = before if before in self.keys and (not waiting or before in waiting) else ""
        return next(iter([*filter(None, (before,)), *waiting, *own, *self.keys]), "")

    def _operator(self, one: CalibrationFile | None) -> str:
        return (one.operator if one is not None else "") or self._app_state.lab.state.operator

    def show_steps(self, stands: tuple[SigningStep, SigningStep, SigningStep, SigningStep]) -> None:
        """How each step stands."""
        for card, step in zip((self.key, self.approval, self.signature), stands, strict=False):
            card.show_step(step)
        self.rest(all(step.mark != "now" for step in stands[:3]))

    def begins_at(self, stands: tuple[SigningStep, SigningStep, SigningStep, SigningStep]) -> QWidget:
        """The field where what is to be done now begins."""
        fields = (self.key_name, self.approver, self.passphrase)
        return next((field for field, step in zip(fields, stands, strict=False) if step.mark == "now"), self.passphrase)

    def check(self) -> None:
        """What is typed is checked as it is typed; a button waits until all is there."""
        one, name, approver = self._chosen(), self.key_name.text().strip(), self.approver.currentText().strip()
        words, again = self.new_words.text(), self.again.text()
        wrong = key_objection(name, words, again, self.keys)
        self.key.say_wrong(wrong)
        self.signature.say_wrong("")
        for entry in (self.key_name, self.approver, self.passphrase):
            set_state(entry, "")
        set_state(self.key_name, "bad" if key_name_objection(name) else "")
        self.new_key.setEnabled(bool(name) and bool(words) and words == again and not wrong)
        draft = one is not None and not one.standing.signatures
        refused = "\n✕ ".join(
            filter(None, (approver_objection(approver, self._operator(one)), self.stated.objection()))
        )
        refused = refused if draft else ""
        self.approval.say_wrong(refused)
        typed, stated_there = self.stated.stated()[0], one is not None and self._stated_by_approval(one)
        no_day = one is None or (stated_there and bool(self.stated.objection()))  # what is refused states nothing else
        valid = "" if one is None or no_day else valid_words(one, typed)
        self.valid_once_approved.setText(valid if stated_there else "")
        self.valid.setText(until_words(one, typed) if valid and one is not None and stated_there else valid)
        self.approver.setEnabled(draft)  # nobody can be added after the first signature
        whole = one is not None and not one.not_measured
        self.approve.setEnabled(draft and whole and bool(approver) and not refused)
        signs = one is not None and bool(self.keys)
        for widget in (self.signer, self.passphrase):
            widget.setEnabled(signs)
        self.sign.setEnabled(
            signs and not self.stated.objection() and bool(self.signer.currentText()) and bool(self.passphrase.text())
        )

    def _stated_by_approval(self, one: CalibrationFile) -> bool:
        """Whether the last day is still open, and stated here: an empty one is not taken without a word."""
        return not (one.standing.signatures or one.approvers or one.not_measured)

    def _offer_name(self) -> None:
        """L. Holm's key is l.holm: it need not be invented."""
        typed = self.key_name.text().strip()
        if key_name_objection(typed) and (name := as_key_name(typed)):
            self.key_name.setText(name)
            self.key.say_done(self.tr("The key's name is {0}, made of “{1}”; or type another one.").format(name, typed))

    def _new_key(self) -> None:
        name, passphrase = self.key_name.text().strip(), self.new_words.text()

        def known(_: str) -> None:
            self.keys = tuple(sorted({*self.keys, name}))  # nobody waits for the new list
            for entry in (self.key_name, self.new_words, self.again):
                entry.clear()
            self._offer()
            self.check()
            self._said(self.key, self.tr("{0} has a key now.").format(name), None)

        self._ask(NewKey(name, passphrase), self.key, self.key_name, known)
        self.new_key.setEnabled(False)  # a second click makes no second one

    def _ask_before_approval(self, words: str) -> None:
        self.approval.ask(words)
        self.approve.setText(self.tr("Approve it all the same") if words else self.tr("Approve"))

    def _approve(self) -> None:
        """Where the cause is not certain the first press asks, and the second one approves."""
        if (one := self._chosen()) is not None and not self.approval.asked_just_now():
            if (doubt := doubts(one)) and self.approval.asked.isHidden():
                return self._ask_before_approval(self.tr("{0} Approve it all the same?").format(doubt))
            self._ask_before_approval("")
            name = self.approver.currentText().strip()

            def known(approved: CalibrationFile) -> None:
                self.approver.setCurrentText("")
                self._said(self.approval, self.tr("Approved by {0}.").format(name), approved)

            self._ask(Approve(one.path, name, *self.stated.stated()), self.approval, self.approver, known)
            self.approve.setEnabled(False)
        return None

    def _ask_before_signing(self, words: str) -> None:
        self.signature.ask(words)
        self.sign.setText(self.tr("Sign it all the same") if words else self.tr("Sign"))

    def _enter(self) -> None:
        """As a click on Sign, where that may be pressed; else what is missing."""
        if self.sign.isEnabled():
            return self.sign.click()
        nobody = "" if self.signer.currentText() else self.tr("Choose who signs.")
        return self.signature.say_wrong(self.stated.objection() or nobody or self.tr("Type the passphrase first."))

    def _sign(self) -> None:
        """Where nobody is named as laboratory or customer the first press asks, and the second one signs."""
        if (one := self._chosen()) is not None and not self.signature.asked_just_now():
            if not one.standing.signatures and (lacks := self._lacks()) and self.signature.asked.isHidden():
                return self._ask_before_signing(self.tr("{0} Sign it all the same?").format(lacks))
            self._ask_before_signing("")
            name, passphrase = self.signer.currentText(), self.passphrase.text()
            command = Sign(one.path, name, passphrase, *self.stated.stated())
            known = partial(self._said, self.signature, self.tr("Signed by {0}.").format(name))
            self._ask(command, self.signature, self.passphrase, known)
            with place_kept(self):
                self.passphrase.clear()
        return None

    def names_known(self) -> None:
        """Somebody is named now: what was asked before a signature is asked anew."""
        self._ask_before_signing("")

    def _said(self, card: StepCard, words: str, one: CalibrationFile | None) -> None:
        """What was done, in the card of its own step."""
        for each in (self.key, self.approval, self.signature):
            each.say_done(words if each is card else "")
        self._done(words, one)

    def _ask(self, command: Command[R], card: StepCard, entry: QWidget, then: Callable[[R], object]) -> None:
        """`entry` is where the person goes on where it is refused: it says why, and nothing on the page moves away."""

        def refused(fault: Fault) -> None:
            self.check()
            if fault.kind == "input":
                card.say_wrong(" ".join(filter(None, (in_words(fault.text), in_words(fault.remedy)))))
                set_state(entry, "bad")
            else:
                self._fault.show_fault(fault)
            entry.setFocus(Qt.FocusReason.OtherFocusReason)

        self._fault.show_fault(None)
        self._app_state.quick_worker.request(command, then, refused)
