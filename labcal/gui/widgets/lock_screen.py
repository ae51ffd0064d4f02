"""What covers the window where nobody is logged in: a name or a badge opens it. COILS OFF stands above it and works."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QLineEdit, QVBoxLayout, QWidget

from labcal.gui.theming.theme import GRID
from labcal.gui.viewmodels.login import LoginViewModel
from labcal.gui.widgets.common import Card, button, label, set_state


class LockScreen(QWidget):
    """Shows a `LoginViewModel` that is locked, and nothing while it is open."""

    def __init__(self, login: LoginViewModel) -> None:
        super().__init__()
        self._login = login
        self.card = Card(self.tr("Who works here?"))
        self.card.setMinimumWidth(52 * GRID)
        self.entry = QLineEdit()
        self.entry.setAccessibleName(self.tr("Your name in the trust list"))
        self.entry.setPlaceholderText(self.tr("Name, or scan your badge"))
        self.entry.returnPressed.connect(self._enter)
        self.open = button(self.tr("Log in"), self.tr("Your name stands in the record from here on"), primary=True)
        self.open.clicked.connect(self._enter)
        self.words = label("", wrap=True)
        how = self.tr("COILS OFF (F12) works all the same. A name says who is meant; signing still asks for your key.")
        row = QHBoxLayout()
        row.addWidget(self.entry, 1)
        row.addWidget(self.open)
        self.card.body.addLayout(row)
        self.card.body.addWidget(self.words)
        self.card.body.addWidget(label(how, "caption", wrap=True))
        column = QVBoxLayout(self)
        column.addStretch()
        column.addWidget(self.card, 0, Qt.AlignmentFlag.AlignHCenter)
        column.addStretch()
        login.changed.connect(self._show)
        self._show()

    def _enter(self) -> None:
        if name := self.entry.text().strip():
            self.entry.clear()
            self._login.log_in(name)

    def _show(self) -> None:
        self.words.setText(self._login.refused)
        set_state(self.words, "bad" if self._login.refused else "")
        self.words.setVisible(bool(self._login.refused))
        self.setVisible(self._login.locked)
        if self._login.locked:
            self.entry.setFocus()
