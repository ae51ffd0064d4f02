"""A bench file edited: settings with unit and meaning, limits first; what would change is seen before it is saved."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtGui import QBrush, QColor
from PySide6.QtWidgets import QAbstractItemView, QHBoxLayout, QPlainTextEdit, QTableWidgetItem, QVBoxLayout, QWidget

from labcal.gui.ipc.answers import BenchText, SettingLine
from labcal.gui.ipc.messages import EditBench
from labcal.gui.ipc.wire import Fault
from labcal.gui.theming.theme import GRID, Theme
from labcal.gui.translations.sentences import in_words
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.widgets.common import Card, button, label, plain, set_primary
from labcal.gui.widgets.fault_card import FaultCard
from labcal.gui.widgets.measurement_table import Table

HEADINGS = ("setting", "value", "unit", "meaning")
VALUE, UNIT = 1, 2
EDITED_BY = QAbstractItemView.EditTrigger


class BenchEditor(QWidget):
    """`left` when the person goes back; `saved` when the file is another one."""

    left = Signal()
    saved = Signal(str)

    def __init__(self, app_state: AppState, theme: Theme) -> None:
        super().__init__()
        self._app_state, self._theme = app_state, theme
        self.file, self._text = "", ""
        self._settings: tuple[SettingLine, ...] = ()
        self._seen: EditBench | None = None  # the difference that is in sight is of this
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2 * GRID)
        self.fault = FaultCard()
        self.fault.report_requested.connect(app_state.report_requested)
        column.addWidget(self.fault)
        column.addWidget(self._settings_card(), 3)
        column.addWidget(self._difference_card(), 2)
        app_state.run.changed.connect(self._enable)
        self._enable()

    def set_theme(self, theme: Theme) -> None:
        """What is changed in the theme's colours."""
        self._theme = theme
        self._colour()

    def open(self, file: str) -> None:
        """Read the settings of the bench file at `file`."""
        self.file = file
        self.card.heading.setText(self.tr("Settings of {0}").format(Path(file).name))
        self.fault.show_fault(None)
        self._app_state.quick_worker.request(EditBench(file), partial(self._known, file), self.fault.show_fault)

    def changes(self) -> tuple[tuple[tuple[str, ...], str], ...]:
        """What was typed and is not in the file."""
        typed = ((one, self.table.text(row, VALUE).strip()) for row, one in enumerate(self._settings))
        return tuple((one.keys, text) for one, text in typed if one.here and text != one.value)

    def _settings_card(self) -> Card:
        self.card = Card(self.tr("Settings of a bench file"), self.tr("limits first"))
        self.table = Table(HEADINGS, 3)
        self.table.setEditTriggers(EDITED_BY.DoubleClicked | EDITED_BY.EditKeyPressed | EDITED_BY.AnyKeyPressed)
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectItems)
        self.table.setMinimumHeight(14 * GRID)
        header = self.table.horizontalHeader()
        for column, width in ((VALUE, 17 * GRID), (UNIT, 9 * GRID)):  # long ones leave room for the meaning
            header.setSectionResizeMode(column, header.ResizeMode.Interactive)
            header.resizeSection(column, width)
        self.table.itemChanged.connect(self._typed)
        how = self.tr(
            "Type a value as TOML has it: 2.5, true, [1.0, 2.0], text between quotation marks; an empty one takes "
            "the setting away. In brackets: what holds where nothing is stated."
        )
        self.card.body.addWidget(self.table, 1)
        self.card.body.addWidget(label(how, "caption", wrap=True))
        return self.card

    def _difference_card(self) -> Card:
        card = Card(self.tr("What would change"))
        self.difference = QPlainTextEdit()
        self.difference.setReadOnly(True)
        self.difference.setTabChangesFocus(True)
        self.difference.setAccessibleName(self.tr("What would change"))
        self.difference.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
        self.words = label("", wrap=True)
        self.show_difference = button(self.tr("Show changes"), self.tr("Compare with the file, and check what it says"))
        self.show_difference.clicked.connect(self._ask)
        self.save = button(self.tr("Save"), self.tr("Write these lines into the file; all others stay as they are"))
        self.save.clicked.connect(self._save)
        self.back = button(self.tr("Back"), self.tr("To the instruments; what was not saved is forgotten"))
        self.back.clicked.connect(self.left)
        row = QHBoxLayout()
        row.addStretch()
        for widget in (self.back, self.show_difference, self.save):
            row.addWidget(widget)
        card.body.addWidget(self.difference, 1)
        card.body.addWidget(self.words)
        card.body.addLayout(row)
        return card

    def _known(self, file: str, found: BenchText) -> None:
        if file != self.file:
            return
        self._text, self._settings, self._seen = found.text, found.settings, None
        with QSignalBlocker(self.table):
            self.table.setRowCount(len(found.settings))
            for row, one in enumerate(found.settings):
                self._show_row(row, one)
        self.difference.setPlainText("")
        self.words.setText("")
        self._enable()

    def _show_row(self, row: int, one: SettingLine) -> None:
        said = in_words(one.meaning)
        meaning = (
            self.tr("{0} unless stated. {1}").format(one.usual, said).strip() if one.usual and not one.value else said
        )
        if not one.here:
            meaning = self.tr("{0} (over several lines: change it in the file)").format(said).strip()
        for column, text in enumerate((".".join(one.keys), one.value, in_words(one.unit), meaning)):
            self.table.setItem(row, column, item := QTableWidgetItem(text))
            item.setToolTip(plain(text))
            if column != VALUE or not one.here:
                item.setFlags(item.flags() & ~Qt.ItemFlag.ItemIsEditable)

    def _typed(self) -> None:
        """What was seen before is no longer what would change."""
        self._seen = None
        self.difference.setPlainText("")
        self.words.setText(self.tr("{0} changed, not saved").format(len(self.changes())) if self.changes() else "")
        self._colour()
        self._enable()

    def _colour(self) -> None:
        changed = {keys for keys, _ in self.changes()}
        with QSignalBlocker(self.table):
            for row, one in enumerate(self._settings):
                item = self.table.item(row, VALUE)
                colour = self._theme.warning if one.keys in changed else self._theme.text
                if item is not None:
                    item.setForeground(QBrush(QColor(colour)))

    def _enable(self) -> None:
        self.show_difference.setEnabled(bool(self.changes()))
        self.save.setEnabled(self._seen is not None and not self._app_state.run.alive)
        for widget in (self.show_difference, self.save):
            set_primary(widget, widget is (self.save if self._seen is not None else self.show_difference))

    def _ask(self) -> None:
        command = EditBench(self.file, self._text, self.changes())
        self.fault.show_fault(None)
        self._app_state.quick_worker.request(command, partial(self._difference_known, command), self.fault.show_fault)

    def _difference_known(self, command: EditBench, found: BenchText) -> None:
        if command.changes != self.changes() or command.bench != self.file:
            return
        self._seen = command
        self.difference.setPlainText(found.difference)
        wrong = self.tr("▲ Not a bench file then: {0}").format(found.objection)
        self.words.setText(wrong if found.objection else self.tr("✓ A bench file"))
        self._enable()

    def _save(self) -> None:
        """What is in sight, and nothing else."""
        if (seen := self._seen) is None or self._app_state.run.alive:
            return
        command = EditBench(seen.bench, seen.before, seen.changes, save=True)
        self._app_state.quick_worker.request(command, partial(self._written, seen.bench), self._not_written)

    def _written(self, file: str, found: BenchText) -> None:
        self._app_state.lab.update(message=self.tr("Saved: {0}").format(file))
        self._known(file, found)
        self.saved.emit(file)

    def _not_written(self, fault: Fault) -> None:
        self.fault.show_fault(Fault(fault.kind, fault.text, self.tr("The file is as it was."), fault.details))
