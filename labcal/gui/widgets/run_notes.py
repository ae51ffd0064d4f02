"""A note or a photograph for the record of the run that goes on."""

from __future__ import annotations

from PySide6.QtWidgets import QFileDialog, QHBoxLayout, QLineEdit, QWidget

from labcal.gui.ipc.messages import KeepPhoto
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.widgets.common import button

PICTURES = "*.jpg *.jpeg *.png *.webp"


class RunNotes(QWidget):
    """Says where what is written here is kept."""

    def __init__(self, app_state: AppState) -> None:
        super().__init__()
        self._app_state = app_state
        self.note = QLineEdit()
        self.note.setPlaceholderText(self.tr("Note"))
        self.note.setToolTip(
            self.tr(
                "Put a remark with its time into the record, and Enter: “lift moved”. History shows it with the run"
            )
        )
        self.note.returnPressed.connect(self._note)
        self.photo = button(self.tr("Photo …"), self.tr("Put a photograph into the record, with the note as its words"))
        self.photo.clicked.connect(self._photo)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self.note, 1)
        row.addWidget(self.photo)

    def enable(self, *, alive: bool) -> None:
        """There is a record as long as the run goes on."""
        self.note.setEnabled(alive)
        self.photo.setEnabled(alive)

    def _note(self) -> None:
        self._keep(self.note.text(), {})

    def _keep(self, text: str, kept: dict[str, str]) -> None:
        if not text.strip():
            return
        self._app_state.run.note(text, **kept)
        self._app_state.lab.update(
            message=self.tr("Kept in the run's record, which History shows: {0}").format(text.strip())
        )
        self.note.clear()

    def _photo(self) -> None:
        path, _ = QFileDialog.getOpenFileName(self, self.tr("A photograph for the record"), "", PICTURES)
        if path:
            self.keep_photo(path)

    def keep_photo(self, path: str) -> None:
        """Copy the photograph at `path` beside the store and put it into the record, with the note as its words."""
        text = self.note.text().strip() or self.tr("photograph")
        self._app_state.request(KeepPhoto(path), lambda kept: self._keep(text, dict(kept)))
        self.note.clear()
