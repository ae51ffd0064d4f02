"""Which bench is opened: its file is chosen."""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP
from PySide6.QtWidgets import QFileDialog, QWidget

from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.app_state import AppState

OPEN = QT_TRANSLATE_NOOP("Words", "Open a bench file")


def choose_bench(parent: QWidget, app_state: AppState) -> None:
    """Ask for the file, and open that; nothing where none is chosen."""
    path, _ = QFileDialog.getOpenFileName(parent, translated(str(OPEN)), "", "*.toml")
    if path:
        app_state.open_bench(path)
