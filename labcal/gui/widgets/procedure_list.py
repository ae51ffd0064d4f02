"""The procedures there are, by group, with a search; what does not load stands among them with its reason."""

from __future__ import annotations

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtGui import QFont
from PySide6.QtWidgets import QLineEdit, QListWidgetItem

from labcal.gui.ipc.answers import Procedure, Procedures
from labcal.gui.theming.theme import GRID
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import procedure_title
from labcal.gui.viewmodels.procedure_groups import group_of, grouped
from labcal.gui.widgets.common import Card, label
from labcal.gui.widgets.grouped_list import GroupedList

HEADING = Qt.ItemDataRole.UserRole  # of an item that is no procedure


class ProcedureList(Card):
    """`list` has the name of each procedure; `search` hides what it does not find."""

    def __init__(self) -> None:
        super().__init__(" ")
        self._procedures: dict[str, Procedure] = {}
        self.heading.setText(self.tr("Procedures"))
        self.heading.setMinimumWidth(0)  # of its text
        self.list = GroupedList()
        self.list.setAccessibleName(self.tr("Procedures"))
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.list.setMinimumWidth(20 * GRID)
        self.search = QLineEdit()
        self.search.setPlaceholderText(self.tr("Search"))
        self.search.setToolTip(self.tr("By name, by what it does, or by what it needs"))
        self.search.setClearButtonEnabled(True)
        self.search.textChanged.connect(self._show_found)
        self.none_found = label(self.tr("None is found. Fewer words, or a part of one?"), wrap=True)
        self.none_found.hide()
        for part in (self.search, self.none_found, self.list):
            self.body.addWidget(part)

    def show_procedures(self, there: Procedures) -> None:
        """List them; none is chosen by that."""
        self._procedures = {one.name: one for one in there.found}
        with QSignalBlocker(self.list):  # nothing is chosen before the new ones are there
            self.list.clear()
        for group, names in grouped(self._procedures):
            self._add_heading(group)
            self.list.addItems(names)
        for name, fault in there.broken.items():
            broken = QListWidgetItem(f"✕ {name}", self.list)
            broken.setFlags(Qt.ItemFlag.NoItemFlags)
            broken.setToolTip(fault)

    def _add_heading(self, group: str) -> None:
        heading = QListWidgetItem(group, self.list)
        heading.setFlags(Qt.ItemFlag.NoItemFlags)
        heading.setData(HEADING, True)
        font = QFont()
        font.setBold(True)
        heading.setFont(font)

    def _show_found(self) -> None:
        """Hide what the search does not find, and headings with nothing below them."""
        heading: QListWidgetItem | None = None
        for item in map(self.list.item, range(self.list.count())):
            if item.data(HEADING):
                heading = item
                heading.setHidden(bool(self.search.text()))
            else:
                item.setHidden(not self._is_found(item.text().removeprefix("✕ ")))
                if heading is not None and not item.isHidden():
                    heading.setHidden(False)
        self.none_found.setVisible(all(self.list.item(row).isHidden() for row in range(self.list.count())))

    def _is_found(self, name: str) -> bool:
        one = self._procedures.get(name)
        said = (name,) if one is None else (name, procedure_title(name), one.title, one.needs, group_of(name))
        about = " ".join((*said, *map(in_words, said)))
        return all(word in about.casefold() for word in self.search.text().casefold().split())
