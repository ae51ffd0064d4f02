"""The colours of what wears no style sheet."""

from __future__ import annotations

from PySide6.QtGui import QColor, QPalette

from labcal.gui.theming.theme import Theme


def palette(theme: Theme) -> QPalette:
    """For what wears no style sheet: cards, placeholders, links, dialogs."""
    palette = QPalette()
    role = QPalette.ColorRole
    for which, colour in ((role.Window, theme.page), (role.Base, theme.surface), (role.Text, theme.text),
                          (role.WindowText, theme.text), (role.Button, theme.surface), (role.ButtonText, theme.text),
                          (role.AlternateBase, theme.sunken), (role.Highlight, theme.accent),
                          (role.HighlightedText, theme.on_accent), (role.PlaceholderText, theme.muted),
                          (role.Mid, theme.line), (role.BrightText, theme.bad)):  # fmt: skip
        palette.setColor(which, QColor(colour))
    return palette
