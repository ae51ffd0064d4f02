"""Which theme: what was switched to by hand, else as the system has it."""

from __future__ import annotations

from PySide6.QtCore import QSettings, Qt
from PySide6.QtGui import QGuiApplication

from labcal.gui.theming.theme import DARK, LIGHT, Theme


def system_theme() -> Theme:
    """Dark or light, as the system says."""
    dark = QGuiApplication.styleHints().colorScheme() == Qt.ColorScheme.Dark
    return DARK if dark else LIGHT


def chosen_theme(settings: QSettings) -> Theme | None:
    """What was switched to by hand; None where nothing was."""
    return {"light": LIGHT, "dark": DARK}.get(str(settings.value("theme", "")))
