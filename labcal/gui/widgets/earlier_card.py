"""Above every page: supplies of an earlier session that COILS OFF could not bring to zero, and what to do."""

from __future__ import annotations

from PySide6.QtWidgets import QHBoxLayout

from labcal.gui.viewmodels.earlier_supplies import EarlierSupplies
from labcal.gui.viewmodels.lab import LabViewModel
from labcal.gui.widgets.common import Card, button, label, set_state


class EarlierCard(Card):
    """Shows an `EarlierSupplies`, and nothing while none is left."""

    def __init__(self, earlier: EarlierSupplies, lab: LabViewModel) -> None:
        super().__init__()
        self._earlier, self._lab = earlier, lab
        self.words, self.remedy = label("", "title", wrap=True), label("", wrap=True)
        self.gone = button(self.tr("They are gone"), "")
        self.gone.clicked.connect(earlier.say_gone)
        row = QHBoxLayout()
        row.addWidget(self.remedy, 1)
        row.addWidget(self.gone)
        self.body.addWidget(self.words)
        self.body.addLayout(row)
        earlier.changed.connect(self._show)
        lab.changed.connect(self._enable)
        self._show()

    def _show(self) -> None:
        """One that answers and is not at zero comes first; then those of which nothing is known."""
        left = self._earlier.left
        on = [one.name for one in left if one.flows]
        silent = ", ".join(one.name for one in left if not one.flows)
        words = self.tr("▲ Supplies of an earlier session do not answer: {0}").format(silent)
        by_hand = self.tr("If one of them stands somewhere still, switch it off by hand, then press COILS OFF (F12).")
        taken = self.tr("Where they were taken away, or a simulated lab was served anew, say so.")
        if on:
            words = self.tr("✕ Supplies of an earlier session are not at zero: {0}").format(", ".join(on))
        self.words.setText(words)
        set_state(self.words, "bad" if on else "warning")
        self.remedy.setText(f"{by_hand} {taken}" if self._earlier.gone else by_hand)
        self.gone.setVisible(bool(self._earlier.gone))
        self._enable()
        self.setVisible(bool(left))

    def _enable(self, _: object = None) -> None:
        who = self._lab.state.operator and not self._lab.state.operator_objection
        self.gone.setEnabled(bool(who))
        self.gone.setToolTip(
            self.tr("Nothing is at their links any more: they are asked for no more, and the audit log has your name")
            if who
            else self.tr("Type the operator's name at the top.")
        )
