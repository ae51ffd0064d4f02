"""What people state of a draft beside its numbers: until when it is good, and which calibration it supersedes."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from PySide6.QtCore import QDate, QLocale, QObject, Qt
from PySide6.QtWidgets import QLineEdit

from labcal.gui.ipc.answers import CalibrationFile
from labcal.gui.widgets.common import combo_box, set_state


class StatedFields(QObject):
    """Two fields for a draft that nobody has approved yet, both empty at first; away for any other file."""

    def __init__(self) -> None:
        super().__init__()
        self._draft = ""
        self.until = QLineEdit()
        self.until.setPlaceholderText(self.tr("Last day, or empty"))
        self.until.setToolTip(self.tr("The last day on which it is good, as 2027-11-21; empty: no date is stated"))
        self.until.setAccessibleName(self.tr("Good until"))
        tip = self.tr("The calibration of the same serial that this one takes the place of")
        self.superseded = combo_box(tip, self.tr("Supersedes"), letters=6)

    def show_draft(self, one: CalibrationFile | None, others: Iterable[CalibrationFile]) -> None:
        """What can be stated of this file: nothing where it is approved or signed."""
        draft = one is not None and not one.standing.signatures and not one.approvers
        for field in (self.until, self.superseded):
            field.setVisible(draft)
        if one is None or not draft or one.path == self._draft:
            return
        self._draft = one.path
        self.until.setText(one.until)
        self.superseded.clear()
        self.superseded.addItem(self.tr("Supersedes none"), "")
        for other in others:
            if other.standing.signatures and other.dut.serial == one.dut.serial:
                self.superseded.addItem(self.tr("Supersedes {0}").format(Path(other.path).stem), other.path)

    def objection(self) -> str:
        """Why what stands for the day is none, or one that is over; "" where it is good, or nothing is stated."""
        day = "" if self.until.isHidden() else self._day()
        over = bool(day) and QDate.fromString(day or "", "yyyy-MM-dd") < QDate.currentDate()
        set_state(self.until, "bad" if day is None or over else "")
        if over:
            return self.tr("{0} is over: the last day on which it is good is today or later").format(day)
        if day is not None:
            return ""
        example = QLocale().toString(QDate(2027, 11, 21), QLocale.FormatType.ShortFormat)
        words = self.tr("“{0}” is no day; write it like 2027-11-21 or {1}")
        return words.format(self.until.text().strip(), example)

    def _day(self) -> str | None:
        """As the file states it; also of a day as it is written here. None where it is none."""
        return day_stated(self.until.text())

    def stated(self) -> tuple[str, str]:
        """The day, and the file that is superseded; "" for neither, and for both where there is nothing to state."""
        if self.until.isHidden():
            return "", ""
        return self._day() or "", str(self.superseded.currentData(Qt.ItemDataRole.UserRole) or "")


def day_stated(typed: str) -> str | None:
    """A day that was typed, as 2027-11-21: so, or with the points, or as this place writes it; "" of nothing."""
    typed = typed.strip()
    points = QDate.fromString(typed, "d.M.yyyy")
    here = QLocale().toDate(typed, QLocale.FormatType.ShortFormat)
    days = (QDate.fromString(typed, "yyyy-MM-dd"), points, here)
    whole = typed[-4:].isdigit() or typed[:4].isdigit()  # of a year in two digits the century is not known
    found = next((day for day in days if day.isValid() and whole), None)
    return "" if not typed else None if found is None else found.toString("yyyy-MM-dd")
