"""What a person who closes the window is asked while hands have to be off and no run goes on."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QVBoxLayout, QWidget

from labcal.gui.theming.theme import GRID
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.by_hand import by_hand_words
from labcal.gui.widgets.common import button, label, set_state
from labcal.gui.widgets.fault_card import TITLES
from labcal.gui.widgets.growing_dialog import GrowingDialog


class CloseAtRest(GrowingDialog):
    """`chosen`: whether to close all the same. Esc, Enter and Space stay."""

    chosen = Signal(bool)

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setModal(True)
        self.setWindowTitle(self.tr("Close the window?"))
        self.heading = label("", "title", wrap=True)
        self.by_hand = label("", "ask", wrap=True)
        for graver in (self.heading, self.by_hand):
            set_state(graver, "bad")
        self.coils, self.platform, self.guardian = (label("", wrap=True) for _ in range(3))
        self.stay = button(self.tr("Stay"), self.tr("Close nothing (Esc)"), primary=True)
        self.stay.setDefault(True)
        self.stay.setFocus()
        self.go = button(self.tr("Close all the same"), self.tr("The lab is left as it is said here"))
        self.go.setAutoDefault(False)
        self.stay.clicked.connect(self.reject)
        self.go.clicked.connect(self.accept)
        self.finished.connect(lambda result: self.chosen.emit(bool(result)))
        column, row = QVBoxLayout(self), QHBoxLayout()
        column.setContentsMargins(3 * GRID, 3 * GRID, 3 * GRID, 3 * GRID)
        column.setSpacing(2 * GRID)
        for words in (self.heading, self.by_hand, self.coils, self.platform, self.guardian):
            words.setMinimumWidth(60 * GRID)
            column.addWidget(words)
        row.addWidget(self.stay, 1)
        row.addWidget(self.go)
        column.addLayout(row)

    def say(
        self, *, by_hand: tuple[str, ...], coils_in_doubt: bool, coils: str, platform: str, guarded: bool | None
    ) -> None:
        """How the lab is now, in words; `by_hand`: the supplies to switch off. `guarded`: None where that is no matter.

        The heading is of what is not confirmed: the coils first.
        """
        self.heading.setText(translated(TITLES["coils" if by_hand or coils_in_doubt else "platform"]))
        self.by_hand.setText(by_hand_words(by_hand))
        self.by_hand.setVisible(bool(by_hand))
        self.coils.setText(coils)
        self.platform.setText(platform)
        self.platform.setVisible(bool(platform))
        self.guardian.setText(self._tries_on() if guarded else self._nobody_tries())
        self.guardian.setVisible(bool(by_hand) and guarded is not None)

    def _tries_on(self) -> str:
        return self.tr(
            "With the window closed the guardian keeps trying to bring every coil to zero; nobody sees whether it does."
        )

    def _nobody_tries(self) -> str:
        return self.tr(
            "No guardian holds the supplies: COILS OFF is given once more on closing; nobody sees what becomes of it."
        )
