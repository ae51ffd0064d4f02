"""A person lets a run begin that the check standard keeps from it: who, why, signed where they have a key."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout

from labcal.gui.ipc.messages import AnswersFor, ListKeys, RunProcedure
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.operator_name import name_objection
from labcal.gui.widgets.common import Card, button, combo_box, label, set_state
from labcal.gui.widgets.flow import Flow
from labcal.gui.widgets.secret import secret_entry
from labcal.gui.widgets.wanted_line import WantedLine


class AnswerForCard(Card):
    """In place of the verdict of a run that was kept from beginning; begins it again with who answers for it."""

    def __init__(self, app_state: AppState) -> None:
        super().__init__(self.tr("Answer for this run"))
        self._app_state, self.asks = app_state, False
        self._answered: RunProcedure | None = None  # this order, and it may not have begun yet
        words = label(
            self.tr(
                "It begins though the check standard is out of control. Name and reason stand in its record and in the "
                "audit log; with a key they are signed."
            ),
            wrap=True,
        )
        self.who = WantedLine(self.tr("Who answers for it"), self.tr("The person who lets this run begin"))
        known = self.tr("What is known of the check standard: it was dropped")
        self.because = WantedLine(self.tr("Why it may begin"), known)
        for entry in (self.who, self.because):
            entry.textChanged.connect(self.check)
        self.key = combo_box(self.tr("Whose key signs it"), letters=10)
        self.key.currentIndexChanged.connect(self.check)
        self.passphrase = secret_entry(self.tr("Passphrase"), self.tr("Of this key; asked each time"))
        self.passphrase.textChanged.connect(self.check)
        self.begin = button(self.tr("Let it begin"), self.tr("Begin this run; it is noted who answered for it"))
        self.begin.clicked.connect(self._answer)
        self.objection = label("", "caption", wrap=True)
        set_state(self.objection, "bad")
        row = QHBoxLayout()
        row.addWidget(self.objection, 1)
        row.addWidget(self.begin, 0, Qt.AlignmentFlag.AlignRight)
        self.body.addWidget(words)
        self.body.addLayout(Flow(self.who, self.because, self.key, self.passphrase))
        self.body.addLayout(row)
        self.body.addStretch()
        self.offer(())

    def offer(self, keys: Sequence[str]) -> None:
        """Have these keys to sign with."""
        self.key.clear()
        self.key.addItem(self.tr("no key: not signed"), "")
        for name in keys:
            self.key.addItem(name, name)
        self.check()

    def show_fault(self, fault: Fault | None) -> None:
        """Ask where the check standard is against the run, and again where a key did not open; else keep none."""
        run, asked = self._app_state.run, self.asks
        order, again = run.order, run.order is not None and self._answered is run.order and not run.run_id
        kind = "" if fault is None else fault.kind
        self.asks = order is not None and (kind == "standard" or (again and kind == "input"))
        if not self.asks:
            self.passphrase.clear()
        elif not asked and not again and order is not None:
            self._app_state.request(ListKeys(), self.offer)
            self.who.setText(order.operator)
            self.because.clear()

    def check(self) -> None:
        """Say what is against what was typed; nothing begins before all is there."""
        said = name_objection(self.who.text())
        self.objection.setText(f"✕ {said}" if said else "")
        self.passphrase.setVisible(bool(self.key.currentData()))
        signed = not self.key.currentData() or bool(self.passphrase.text())
        self.begin.setEnabled(bool(self.who.text().strip() and self.because.text().strip()) and signed and not said)

    def _answer(self) -> None:
        key, order = str(self.key.currentData() or ""), self._app_state.run.order
        by = AnswersFor(
            self.who.text().strip(), self.because.text().strip(), key, self.passphrase.text() if key else ""
        )
        self.passphrase.clear()
        self._answered = order
        if order is not None:
            self._app_state.run.start(order, replace(order, answered_for=by))
