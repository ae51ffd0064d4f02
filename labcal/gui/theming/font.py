"""The letters of the window: those that somebody chose for the system's windows, else Source Sans, which labcal brings.

A package holds it, so that a computer without a desktop and without a network has it too.
"""

from __future__ import annotations

from importlib.resources import files

from PySide6.QtCore import QByteArray
from PySide6.QtGui import QFont, QFontDatabase

NOBODY_CHOSE = ("", "Sans", "Sans Serif", "sans-serif")  # what Qt says on a system without a choice
PACKAGE, FAMILY = "font_source_sans_pro", "Source Sans Pro"
STYLES = ("Regular", "It", "Semibold", "Bold")


def with_tabular_figures(font: QFont) -> QFont:
    """`font` with figures of one width, where it has such: nothing jumps when a digit changes."""
    tabular = QFont(font)
    tabular.setFeature(QFont.Tag("tnum"), 1)
    return tabular


def interface_font(system: QFont) -> QFont:
    """The `system`'s font where somebody chose it, else Source Sans; with figures of one width."""
    font = with_tabular_figures(system)
    if system.family() in NOBODY_CHOSE:
        _register()
        font.setFamily(FAMILY)  # signs that it lacks come from the system's fonts, letter by letter
    return font


def _register() -> None:
    """Make the package's files known to Qt, once."""
    if not QFontDatabase.hasFamily(FAMILY):
        for style in STYLES:
            letters = (files(PACKAGE) / "files" / f"SourceSansPro-{style}.ttf").read_bytes()
            QFontDatabase.addApplicationFontFromData(QByteArray(letters))
