"""A form made from a procedure's declared parameters: one row each, its fixed unit and range beside it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from PySide6.QtCore import QLocale, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QFileDialog,
    QGridLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QWidget,
)

from labcal.bench.parameters import ParameterSpec
from labcal.errors import InputError
from labcal.gui.theming.theme import GRID
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.widgets.barcode_scanner import takes_numbers
from labcal.gui.widgets.common import button, named, offer, set_state
from labcal.gui.widgets.typed_number import NotClear, number_stated, numbers_stated

MOST_LETTERS = 24  # of a list of values that are all in sight
LEAST_LETTERS = 75  # of a form with what settings mean beside them
SEEN = 6  # settings, the first of each procedure
SUFFIX = {"nT": "_nT", "deg": "_deg", "deg/s": "_deg_per_s", "s": "_s", "A": "_A", "Hz": "_Hz", "degC": "_C", "m": "_m"}


def as_text(spec: ParameterSpec, value: Any) -> str:
    """A value as a person types it, and as `--set` takes it."""
    if value is None:
        return ""
    if spec.many:
        return ", ".join(_one(v) for v in value)
    return _one(value)


def _one(value: Any) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:g}" if isinstance(value, float) and abs(value) < 1e6 else str(value)


def as_written(spec: ParameterSpec, text: str) -> str:
    """A number with the decimal mark of the window's language, as readings have it; between several stand commas."""
    alone = spec.kind in ("number", "integer") and not spec.many
    return text.replace(".", QLocale().decimalPoint()) if alone else text


def _as_typed(spec: ParameterSpec, text: str) -> str:
    try:
        return as_text(spec, spec.parse(text))
    except InputError:
        return text


def range_of(spec: ParameterSpec) -> str:
    """What is allowed, short: "1000 … 100000 nT"."""
    if spec.limits is None:
        return translated("several, with commas") if spec.many else ""
    limits = (np.format_float_positional(limit, trim="-") for limit in (spec.limits.lo, spec.limits.hi))
    low, high = (as_written(spec, limit) for limit in limits)
    return f"{low} … {high} {spec.unit}".rstrip()


def title_of(spec: ParameterSpec) -> str:
    """Its name in words, without the unit: rate_deg_per_s is "Rate"."""
    words = spec.name.removesuffix(SUFFIX.get(spec.unit, "")).replace("_", " ")
    return in_words(words[:1].upper() + words[1:])


def ticked(on: bool) -> str:
    """A box with its tick and its word: in letters, which are as large and as dark as all others."""
    return f"{'☑' if on else '☐'}  {translated('yes' if on else 'no')}"


class ParameterForm(QWidget):
    """Entries for `specs`; `given()` says only what differs from the defaults.

    Those that most runs leave alone, the last ones, are folded away; one that differs or is refused is in sight.
    """

    changed = Signal()
    styled_as_whole = (QLabel, QLineEdit, QComboBox, QCheckBox, QPushButton)  # small parts, made for each procedure

    def __init__(self, specs: Sequence[ParameterSpec]) -> None:
        super().__init__()
        self._specs = specs
        self.fields: dict[str, QLineEdit | QComboBox | QCheckBox] = {}
        self.complaints: dict[str, QLabel] = {}
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(2 * GRID)
        grid.setVerticalSpacing(GRID)
        self._parts: dict[str, tuple[QWidget, ...]] = {}
        self._grid, self._narrow = grid, False
        self._folded = list(specs[SEEN:]) if len(specs) > SEEN + 1 else []
        for row, spec in enumerate(specs):
            self._add(grid, self._row(row), spec)
        self.more = button("", self.tr("Settings that most runs leave as they are"))
        self.more.setCheckable(True)
        self.more.toggled.connect(self._fold)
        grid.addWidget(self.more, 2 * SEEN, 0, 1, 3, Qt.AlignmentFlag.AlignLeft)  # what it opens comes below it
        self.more.setVisible(bool(self._folded))
        grid.setColumnStretch(3, 1)
        grid.setRowStretch(2 * len(specs) + 1, 1)
        if self._folded:
            self.setTabOrder(self.fields[specs[SEEN - 1].name], self.more)
        self._check()

    def _row(self, setting: int) -> int:
        """Of the grid, where this setting stands: two rows each, and one for the button before the folded ones."""
        return 2 * setting + int(bool(self._folded) and setting >= SEEN)

    def _add(self, grid: QGridLayout, row: int, spec: ParameterSpec) -> None:
        name = QLabel(title_of(spec))
        help_text, expected = in_words(spec.help), in_words(spec.expected)
        name.setToolTip(f"--set {spec.name}=…: {expected}")
        field = self._field(spec)
        field.setToolTip(f"{help_text or spec.name}: {expected}")
        field.setAccessibleName(help_text or spec.name)
        name.setBuddy(field)
        complaint = named(QLabel(), "caption")
        complaint.setWordWrap(True)
        self.fields[spec.name], self.complaints[spec.name] = field, complaint
        beside = self._chooser(spec) if spec.kind == "file" else QLabel(spec.unit)
        self._parts[spec.name] = (name, field, beside, complaint)
        for column, part in enumerate(self._parts[spec.name]):
            grid.addWidget(part, row, column)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """What a setting means stands beside it, or below where beside it there is room for a word or two alone."""
        super().resizeEvent(event)
        narrow = event.size().width() < LEAST_LETTERS * self.fontMetrics().horizontalAdvance("n")
        if narrow is self._narrow:
            return
        self._narrow = narrow
        for row, spec in enumerate(self._specs):
            complaint = self.complaints[spec.name]
            self._grid.removeWidget(complaint)
            place = (self._row(row) + 1, 0, 1, 4) if narrow else (self._row(row), 3, 1, 1)
            self._grid.addWidget(complaint, *place)

    def _chooser(self, spec: ParameterSpec) -> QPushButton:
        """A file is chosen, and not typed letter by letter."""
        choose = button("", self.tr("Choose a file"))
        choose.setText(self.tr("Choose …"))
        choose.clicked.connect(lambda: self._chosen(spec))
        return choose

    def _chosen(self, spec: ParameterSpec) -> None:
        if path := QFileDialog.getOpenFileName(self, title_of(spec), self.text(spec.name))[0]:
            self.set_text(spec.name, path)

    def _field(self, spec: ParameterSpec) -> QLineEdit | QComboBox | QCheckBox:
        if spec.kind == "switch":
            box = QCheckBox()
            box.setChecked(bool(spec.default))
            box.setText(ticked(bool(spec.default)))
            box.toggled.connect(lambda on: box.setText(ticked(on)))
            box.toggled.connect(self._check)
            return box
        if spec.kind == "choice" and not spec.many:
            chooser = QComboBox()
            offer(chooser, spec.choices)
            chooser.setCurrentIndex(max(0, chooser.findData(as_text(spec, spec.default))))  # this DUT may not have it
            chooser.currentTextChanged.connect(self._check)
            return chooser
        line = QLineEdit(as_written(spec, as_text(spec, spec.default)))
        if spec.kind in ("number", "integer") and not spec.many:
            line.setAlignment(Qt.AlignmentFlag.AlignRight)
        if spec.kind in ("number", "integer"):
            takes_numbers(line)
        if spec.many:  # several values are seen whole, as far as there is room
            letters = min(len(line.text()), MOST_LETTERS)
            line.setMinimumWidth(line.fontMetrics().horizontalAdvance("0") * letters + 4 * GRID)
            line.setCursorPosition(0)
        line.textChanged.connect(self._check)
        return line

    def text(self, name: str) -> str:
        """What stands in the field `name`, as text."""
        field = self.fields[name]
        if isinstance(field, QCheckBox):
            return "yes" if field.isChecked() else "no"
        return str(field.currentData()) if isinstance(field, QComboBox) else field.text()

    def texts(self) -> dict[str, str]:
        """What stands in every field, right or wrong."""
        return {name: self.text(name) for name in self.fields}

    def set_text(self, name: str, text: str) -> None:
        """Write into the field `name`."""
        field = self.fields[name]
        if isinstance(field, QCheckBox):
            field.setChecked(text == "yes")
        elif isinstance(field, QComboBox):
            field.setCurrentIndex(at if (at := field.findData(text)) >= 0 else field.currentIndex())
        else:
            field.setText(text)

    def propose(self, settings: Mapping[str, str]) -> None:
        """Write in what is stated as `--set` takes it; what is not accepted too, which its field then says."""
        for spec in self._specs:
            if spec.name in settings:
                self.set_text(spec.name, as_written(spec, _as_typed(spec, settings[spec.name])))

    def is_usual(self) -> bool:
        """Whether every field is as it was at first."""
        return all(self.text(spec.name) == self._usual(spec) for spec in self._specs)

    def make_usual(self) -> None:
        """Every field as it was at first."""
        for spec in self._specs:
            self.set_text(spec.name, self._usual(spec))

    def stated(self, spec: ParameterSpec) -> str:
        """What stands in a field, as `--set` takes it: with a point. Raises NotClear."""
        text = self.text(spec.name)
        none = spec.optional and text.strip().lower() in ("", "none")
        if text == self._usual(spec):
            return self._default(spec)
        if spec.kind not in ("number", "integer") or none:
            return text
        return numbers_stated(text) if spec.many else number_stated(text)

    def objection(self, spec: ParameterSpec) -> str:
        """Why a field is refused; "" where it is not."""
        try:
            if spec.required and not self.text(spec.name).strip():
                return self.tr("needed")
            value = spec.parse(self.stated(spec))
        except NotClear as error:
            return str(error)
        except InputError:
            return self.tr("expected {0}").format(in_words(spec.expected))
        return self.tr("there is no such file") if isinstance(value, Path) and not value.is_file() else ""

    def refused(self) -> ParameterSpec | None:
        """The first setting that is not accepted."""
        return next((spec for spec in self._specs if self.objection(spec)), None)

    def shortfall(self) -> str:
        """What does not come of the settings as they are, though they are accepted; else ""."""
        if not self.valid():
            return ""
        said = (spec.shortfall(spec.parse(self.stated(spec))) for spec in self._specs)
        return in_words(next(filter(None, said), ""))

    def valid(self) -> bool:
        """Whether every field is accepted."""
        return self.refused() is None

    def given(self) -> dict[str, str]:
        """The settings that differ from the defaults, as text; what is refused as it was typed."""
        said = {spec.name: self._stated_or_typed(spec) for spec in self._specs}
        return {s.name: said[s.name] for s in self._specs if s.required or said[s.name] != self._default(s)}

    def _stated_or_typed(self, spec: ParameterSpec) -> str:
        try:
            return self.stated(spec)
        except NotClear:
            return self.text(spec.name)

    def _default(self, spec: ParameterSpec) -> str:
        return "no" if spec.kind == "switch" and not spec.default else as_text(spec, spec.default)

    def _usual(self, spec: ParameterSpec) -> str:
        """The default as it is written in its field."""
        return as_written(spec, self._default(spec))

    def _fold(self) -> None:
        """Show the folded settings, or of them only what is not as usual."""
        self.more.setText(
            (self.tr("▾ Fewer settings") if self.more.isChecked() else self.tr("▸ More settings: {0}")).format(
                len(self._folded)
            )
        )
        for spec in self._folded:
            unusual = self.text(spec.name) != self._usual(spec) or bool(self.objection(spec))
            for part in self._parts[spec.name]:
                part.setVisible(self.more.isChecked() or unusual or part.hasFocus())

    def _check(self) -> None:
        for spec in self._specs:
            objection = self.objection(spec)
            about = "  ·  ".join(part for part in (in_words(spec.help), range_of(spec)) if part)
            self.complaints[spec.name].setText(f"✕ {objection}" if objection else about)
            for part in (self.complaints[spec.name], self.fields[spec.name]):
                set_state(part, "bad" if objection else "")
        self._fold()
        self.changed.emit()
