"""A recording of others taken in: its mapping line by line with the first rows, a picture, corrections, and go."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtGui import QBrush, QColor
from PySide6.QtWidgets import QAbstractItemView, QHBoxLayout, QTableWidgetItem, QVBoxLayout, QWidget

from labcal.gui.ipc.answers import MappedLine, RecordingMapped
from labcal.gui.ipc.messages import ImportRecording, LookAtRecording
from labcal.gui.ipc.wire import Fault
from labcal.gui.theming.theme import GRID, Theme
from labcal.gui.translations.sentences import in_words
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.widgets.common import Card, button, label, plain, set_primary
from labcal.gui.widgets.fault_card import FaultCard
from labcal.gui.widgets.measurement_table import Table
from labcal.gui.widgets.plots import Traces

HEADINGS = ("mapping", "value", "row 1", "row 2", "row 3")
KEYS, VALUE, FIRST_ROW = 0, 1, 2
EDITED_BY = QAbstractItemView.EditTrigger


class RecordingView(QWidget):
    """`left` when the person goes back, `imported` with the run's id."""

    left = Signal()
    imported = Signal(str)

    def __init__(self, app_state: AppState, theme: Theme) -> None:
        super().__init__()
        self._app_state, self._theme = app_state, theme
        self.file = ""
        self._shown: RecordingMapped | None = None
        self._asked: LookAtRecording | None = None  # what is waited for
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2 * GRID)
        self.fault = FaultCard()
        self.fault.report_requested.connect(app_state.report_requested)
        column.addWidget(self.fault)
        column.addWidget(self._mapping_card(), 3)
        column.addWidget(self._picture_card(theme), 2)
        self._enable()

    def set_theme(self, theme: Theme) -> None:
        """Curves, and what is changed, in the theme's colours."""
        self._theme = theme
        self.traces.set_theme(theme)
        self._colour()

    def open(self, file: str) -> None:
        """Look at the recording `file`, by a guessed mapping."""
        self.file, self._shown = file, None
        self.card.heading.setText(self.tr("Recording {0}: what its columns are").format(Path(file).name))
        self.table.setRowCount(0)
        header = self.table.horizontalHeader()  # before it is in the window this would keep it from being styled there
        header.setSectionResizeMode(VALUE, header.ResizeMode.Interactive)
        header.resizeSection(VALUE, 28 * GRID)
        self._ask(LookAtRecording(file))

    def changes(self) -> tuple[tuple[tuple[str, ...], str], ...]:
        """What was typed and is not in the mapping that is in sight."""
        lines = self._shown.lines if self._shown is not None else ()
        typed = ((one, self._keys(row, one), self.table.text(row, VALUE).strip()) for row, one in enumerate(lines))
        return tuple((keys, text) for one, keys, text in typed if (keys, text) != (one.keys, one.value))

    def _keys(self, row: int, one: MappedLine) -> tuple[str, ...]:
        """A line's own, or what was typed for them where it has none."""
        typed = self.table.text(row, KEYS).strip()
        return one.keys or tuple(key.strip() for key in typed.split(".") if typed)

    def _mapping_card(self) -> Card:
        self.card = Card(self.tr("What its columns are"), self.tr("guessed: check every line"))
        self.table = Table(HEADINGS, 2, 3, 4)
        self.table.setEditTriggers(EDITED_BY.DoubleClicked | EDITED_BY.EditKeyPressed | EDITED_BY.AnyKeyPressed)
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectItems)
        self.table.setMinimumHeight(14 * GRID)
        self.table.itemChanged.connect(self._typed)
        how = self.tr(
            'Correct a value as a mapping has it (docs/import.md): "uT", ["y", "x", "-z"], "Bx [nT]"; an empty one '
            'takes the line away. accept: ["axes"] lets that doubt pass.'
        )
        self.card.body.addWidget(self.table, 1)
        self.card.body.addWidget(label(how, "caption", wrap=True))
        return self.card

    def _picture_card(self, theme: Theme) -> Card:
        card = Card(self.tr("Its readings"))
        self.traces = Traces(theme, "field  µT")
        self.words = label("", wrap=True)
        self.back = button(self.tr("Back"), self.tr("To the list of runs; nothing is imported"))
        self.back.clicked.connect(self.left)
        self.show_changes = button(self.tr("Check"), self.tr("Read the recording by the corrected mapping"))
        self.show_changes.clicked.connect(self._check)
        self.go = button(self.tr("Import"), self.tr("Take it into the store by this mapping, as a run of its own"))
        self.go.clicked.connect(self._import)
        row = QHBoxLayout()
        row.addStretch()
        for widget in (self.back, self.show_changes, self.go):
            row.addWidget(widget)
        card.body.addWidget(self.traces, 1)
        card.body.addWidget(self.words)
        card.body.addLayout(row)
        return card

    def _ask(self, command: LookAtRecording) -> None:
        self._asked = command
        self.fault.show_fault(None)
        self.words.setText(self.tr("Reading {0} …").format(Path(command.path).name))
        self._enable()
        self._app_state.fit_worker.request(command, partial(self._known, command), partial(self._not_known, command))

    def _check(self) -> None:
        if self._shown is not None:
            self._ask(LookAtRecording(self.file, self._shown.text, self.changes()))

    def _known(self, command: LookAtRecording, found: RecordingMapped) -> None:
        """What was asked last is shown, and nothing that was asked before."""
        if command is not self._asked:
            return
        self._asked, self._shown = None, found
        with QSignalBlocker(self.table):
            self.table.clearSpans()
            self.table.setRowCount(len(found.lines))
            for row, one in enumerate(found.lines):
                self._show_row(row, one)
        self.traces.show_rows(found.rows)
        wrong = self.tr("▲ Not imported so: {0}").format(in_words(found.objection))
        noticed = self.tr("✓ It can be imported. {0}").format("; ".join(map(in_words, found.remarks))).strip()
        self.words.setText(wrong if found.objection else noticed)
        self._colour()
        self._enable()

    def _not_known(self, command: LookAtRecording, fault: Fault) -> None:
        if command is self._asked:
            self._asked = None
            self.words.setText("")
            self.fault.show_fault(fault)
            self._enable()

    def _show_row(self, row: int, one: MappedLine) -> None:
        first = (*one.first, "", "", "")[:3] if one.first else (one.remark, "", "")
        if not one.first:
            self.table.setSpan(row, FIRST_ROW, 1, len(first))
        for column, text in enumerate((".".join(one.keys), one.value, *first)):
            self.table.setItem(row, column, item := QTableWidgetItem(text))
            item.setToolTip(plain(one.remark if column == VALUE and one.remark else text))
            if column != VALUE and (column != KEYS or one.keys):
                item.setFlags(item.flags() & ~Qt.ItemFlag.ItemIsEditable)

    def _typed(self) -> None:
        """What is in sight is no longer what would be imported."""
        self.words.setText(self.tr("{0} changed, not checked").format(len(self.changes())) if self.changes() else "")
        self._colour()
        self._enable()

    def _colour(self) -> None:
        changed = {keys for keys, _ in self.changes()}
        with QSignalBlocker(self.table):
            for row, one in enumerate(self._shown.lines if self._shown is not None else ()):
                if (item := self.table.item(row, VALUE)) is not None:
                    is_changed = self._keys(row, one) in changed
                    item.setForeground(QBrush(QColor(self._theme.warning if is_changed else self._theme.text)))

    def _enable(self) -> None:
        """It is imported as it is in sight, and not while a correction waits."""
        changed, waits = bool(self.changes()), self._asked is not None
        self.show_changes.setEnabled(changed and not waits)
        self.go.setEnabled(self._shown is not None and not self._shown.objection and not changed and not waits)
        for widget in (self.show_changes, self.go):
            set_primary(widget, widget is (self.show_changes if changed else self.go))

    def _import(self) -> None:
        if self._shown is None or not self.go.isEnabled():
            return
        self.go.setEnabled(False)
        command = ImportRecording(self.file, self._shown.text)
        self._app_state.fit_worker.request(command, self._taken, self._not_taken)

    def _taken(self, run_id: str) -> None:
        self._app_state.lab.update(message=self.tr("Imported: run {0}").format(run_id))
        self._app_state.store_changed.emit()
        self.imported.emit(run_id)

    def _not_taken(self, fault: Fault) -> None:
        self.fault.show_fault(fault)
        self._enable()
