"""Fit: methods side by side, loci before and after, the residual against whatever may drive it."""

from __future__ import annotations

from math import sqrt
from typing import Any

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QSplitter, QVBoxLayout, QWidget

from labcal.gui.chooser import RunChooser
from labcal.gui.desk import Desk
from labcal.gui.fault_card import FaultCard
from labcal.gui.measurement_table import Table
from labcal.gui.numbers import number
from labcal.gui.plots import Loci
from labcal.gui.study_plots import Residuals
from labcal.gui.theme import GRID, Theme
from labcal.gui.widgets import Card, button, label
from labcal.gui.wire import unpack

HEADINGS = ("method", "k x", "± U", "k y", "± U", "k z", "± U", "held out", "axis max", "time s", "frame")


class FitPage(QWidget):
    """Shows `desk.study_vm`."""

    def __init__(self, desk: Desk, theme: Theme) -> None:
        super().__init__()
        self._desk, self._study, self._theme = desk, desk.study_vm, theme
        column = QVBoxLayout(self)
        column.setContentsMargins(2 * GRID, 2 * GRID, 2 * GRID, 2 * GRID)
        column.setSpacing(2 * GRID)
        column.addLayout(self._head())
        self.fault = FaultCard()
        self.fault.report_asked.connect(desk.report_asked)
        column.addWidget(self.fault)
        column.addWidget(self._table_card(), 2)
        column.addWidget(self._pictures(), 3)
        self._study.changed.connect(self._show)
        self._show()

    def _head(self) -> QHBoxLayout:
        self.chooser = RunChooser(self._desk)
        self.chooser.chosen.connect(self.open_run)
        self.fit = button(self.tr("Fit"), self.tr("Estimate by maximum likelihood, the default method"), primary=True)
        self.fit.clicked.connect(lambda: self._study.fit("ml"))
        self.all = button(self.tr("All methods"), self.tr("Estimate by every method, to see whether they agree"))
        self.all.clicked.connect(self._study.fit_all)
        self.cancel = button(self.tr("Give up"), self.tr("End what is being computed"))
        self.cancel.clicked.connect(self._study.cancel)
        self.draft = button(self.tr("Make a draft"), self.tr("Write a draft calibration from the selected method"))
        self.draft.clicked.connect(self._draft)
        self.trace = button(self.tr("Trace the residual"), self.tr("Find what causes what is left over: the Loop page"))
        self.trace.clicked.connect(self._trace)
        self.waiting = label("", "caption")
        row = QHBoxLayout()
        row.addWidget(self.chooser)
        row.addWidget(self.waiting, 1)
        for widget in (self.cancel, self.fit, self.all, self.draft, self.trace):
            row.addWidget(widget)
        return row

    def _table_card(self) -> Card:
        card = Card(
            self.tr("Methods side by side"),
            self.tr("offsets k and U (k=2) in nT, held-out error in nT, axis error in deg"),
        )
        self.empty = label(self.tr("Choose a run above, then Fit."), "ask")
        self.empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.table = Table(HEADINGS, stretch=0)
        self.table.right_heading(*range(1, 10))
        self.table.itemSelectionChanged.connect(self._show_pictures)
        card.body.addWidget(self.empty, 1)
        card.body.addWidget(self.table, 1)
        return card

    def _pictures(self) -> QWidget:
        holder = QSplitter()
        holder.setHandleWidth(2 * GRID)
        holder.setChildrenCollapsible(False)
        loci = Card(self.tr("On the sphere"), self.tr("orange: as read   blue: calibrated"))
        self.loci = Loci(self._theme, clouds=2)
        loci.body.addWidget(self.loci)
        residual = Card(self.tr("Residual |b| against"), self.tr("band: the noise this method states, k=2"))
        self.against = QComboBox()
        self.against.setToolTip(self.tr("What the residual is drawn against"))
        self.against.activated.connect(self._show_pictures)
        self.residual = Residuals(self._theme)
        residual.body.addWidget(self.against)
        residual.body.addWidget(self.residual, 1)
        holder.addWidget(loci)
        holder.addWidget(residual)
        holder.setSizes([600, 400])
        return holder

    def open_run(self, run: str) -> None:
        """Study `run`."""
        self.chooser.show_run(run)
        self._study.open(run)

    def _trace(self) -> None:
        self._desk.went.emit("Loop")
        if self._study.loop is None:
            self._study.close_loop()

    def _draft(self) -> None:
        if (method := self.method()) is not None:
            self._study.draft(method)
            self._desk.went.emit("Certificate")

    def method(self) -> str | None:
        """The method that is selected in the table, else the best that came to a result."""
        chosen = self.table.selectedItems()
        name = chosen[0].text() if chosen else ""
        return name if name in self._study.fits and self._study.fits[name]["fit"]["ok"] else self._study.best()

    def _show(self) -> None:
        study = self._study
        self.fault.show_fault(study.fault)
        if self.chooser.currentData() != study.run:
            self.chooser.show_run(study.run)
        self.waiting.setText(self.tr("computing: {0}").format(", ".join(study.waiting)) if study.busy else "")
        self.cancel.setVisible(study.busy)
        self.fit.setEnabled(bool(study.run) and not study.busy and "ml" not in study.fits)
        self.all.setEnabled(bool(study.methods) and not study.busy)
        self.draft.setEnabled(study.best() is not None)
        self.trace.setEnabled(bool(study.run) and not study.busy)
        self.empty.setVisible(not study.fits)
        self.table.setVisible(bool(study.fits))
        self.table.setRowCount(len(study.fits))
        for row, said in enumerate(study.fits.values()):
            self._show_fit(row, said["fit"])
        self._show_pictures()

    def _show_fit(self, row: int, fit: dict[str, Any]) -> None:
        self.table.set_cell(row, 0, fit["method"], tip=fit["why_not"] or "")
        if not fit["ok"]:
            for column in range(1, len(HEADINGS)):
                self.table.set_cell(row, column, "–", right=column < 10, tip=fit["why_not"])
            return
        covariance = fit["covariance"]
        for axis, value in enumerate(fit["k_nT"]):
            u = None if covariance is None else 2 * sqrt(max(0.0, covariance[9 + axis][9 + axis]))
            self.table.set_cell(row, 1 + 2 * axis, number(value), right=True, colour=self._theme.axes[axis])
            self.table.set_cell(row, 2 + 2 * axis, "–" if u is None else number(u, signed=False), right=True)
        worst = max(fit["axis_error_deg"], default=None) if fit["axis_error_deg"] else None
        for column, value, decimals in ((7, fit["holdout_rms_scalar_nT"], 1), (8, worst, 2), (9, fit["seconds"], 2)):
            self.table.set_cell(
                row, column, "–" if value is None else number(value, decimals, signed=False), right=True
            )
        self.table.set_cell(row, 10, self.tr("known") if fit["frame_known"] else self.tr("free"))

    def _show_pictures(self) -> None:
        look, method = self._study.look, self.method()
        if look is None:
            return None
        names = list(look["against"])
        if [self.against.itemText(n) for n in range(self.against.count())] != names:
            self.against.clear()
            self.against.addItems(names)
        self.loci.show_field(unpack(look["before"]), 1)
        said = self._study.fits.get(method or "")
        if said is None or "residual" not in said:
            self.loci.show_field(np.empty((0, 3)), 0)
            return self.residual.clear()
        self.loci.show_field(unpack(said["after"]), 0)
        against = self.against.currentText()
        cloud = (method or "", self._theme.accent, unpack(said["residual"]))
        x = unpack(look["against"][against])
        return self.residual.show_residual(against, x, [cloud], said["noise_nT"])
