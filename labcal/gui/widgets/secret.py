"""Where a passphrase is typed."""

from __future__ import annotations

from PySide6.QtWidgets import QLineEdit

from labcal.system.private_memory import kept_private


def secret_entry(name: str, tip: str) -> QLineEdit:
    """A field that shows none of what is typed; no core dump holds it."""
    entry = QLineEdit()
    entry.setPlaceholderText(name)
    entry.setAccessibleName(name)
    entry.setToolTip(tip)
    entry.setEchoMode(QLineEdit.EchoMode.Password)
    entry.textEdited.connect(lambda _: kept_private())
    return entry
