"""How coils and platform are now, in two lines of a dialog."""

from __future__ import annotations

from PySide6.QtWidgets import QVBoxLayout, QWidget

from labcal.gui.theming.theme import GRID
from labcal.gui.translations.sentences import in_words
from labcal.gui.viewmodels.lab_now import mark_of, platform_drawn
from labcal.gui.widgets.common import label, set_state


class LabLines(QWidget):
    """Each with its mark; nothing of what is not known to be there."""

    def __init__(self) -> None:
        super().__init__()
        self.coils, self.platform = label("", wrap=True), label("", wrap=True)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(GRID)
        column.addWidget(self.coils)
        column.addWidget(self.platform)

    def say(self, coil_words: str, platform_words: str) -> None:
        """Both as the side panel says them."""
        marks = mark_of(coil_words), platform_drawn(platform_words, coil_words)
        said = zip((self.coils, self.platform), (coil_words, platform_words), marks, strict=True)
        for line, words, (shape, mark) in said:
            text = f"{shape} {in_words(words)}".strip()
            anew = text != line.text()
            line.setText(text)
            line.setVisible(bool(words))
            set_state(line, mark)
            if anew:
                line.repaint()  # at once: a dialog is drawn after its window, which said another thing for so long
