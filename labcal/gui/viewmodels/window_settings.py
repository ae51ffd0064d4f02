"""What the window remembers between two days."""

from __future__ import annotations

from PySide6.QtCore import QSettings

from labcal.files.home import file_at_home


def window_settings() -> QSettings:
    """Its file, in labcal's folder."""
    return QSettings(str(file_at_home("window.ini")), QSettings.Format.IniFormat)
