"""Fit: methods side by side with their uncertainties, and the pictures of the papers they are from."""

from __future__ import annotations

from math import sqrt

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QAbstractItemView, QHBoxLayout, QHeaderView, QVBoxLayout, QWidget

from labcal.gui.ipc.answers import FitFigures, Fitted, Matrix
from labcal.gui.theming.theme import GRID, Theme
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.fit_words import OF_WHICH, said_of, set_aside_words
from labcal.gui.viewmodels.gain_words import GAINS, gain_means, gain_name
from labcal.gui.viewmodels.kept_of_run import kept_words
from labcal.gui.viewmodels.number_format import decimals_for, format_number
from labcal.gui.widgets.common import Card, button, label, set_primary, set_state
from labcal.gui.widgets.fault_card import FaultCard
from labcal.gui.widgets.fit_views import FitViews
from labcal.gui.widgets.flow import Flow
from labcal.gui.widgets.goes_on_elsewhere import GoesOnElsewhere
from labcal.gui.widgets.idle_queue import IdleQueue
from labcal.gui.widgets.measurement_table import Table
from labcal.gui.widgets.no_fit import NoFit
from labcal.gui.widgets.run_chooser import RunChooser, go_to_run_button
from labcal.gui.widgets.work_bar import WorkBar

QUALITY = ("held-out |b|  nT", "axis error, worst  deg", "time  s", "frame")
OFFSETS = ("offset k x  nT", "offset k y  nT", "offset k z  nT")
LEAST_ROWS = 8  # of the table are always seen: how good, and where zero is
FILTERS = ("ekf", "ukf", "ukf-augmented", "centered-sequential")


class FitPage(QWidget):
    """Shows `app_state.study_vm`."""

    shows_only = True  # where there is no room for it the page is scrolled, and nothing in it is squeezed

    def __init__(self, app_state: AppState, theme: Theme) -> None:
        super().__init__()
        self._app_state, self._study, self._theme = app_state, app_state.study_vm, theme
        column = QVBoxLayout(self)
        column.setContentsMargins(2 * GRID, 2 * GRID, 2 * GRID, 2 * GRID)
        column.setSpacing(2 * GRID)
        column.addLayout(self._head())
        self.waiting = label("", "caption", wrap=True)
        self.work = WorkBar()
        column.addWidget(self.waiting)
        column.addWidget(self.work)
        self.fault = FaultCard()
        self.fault.report_requested.connect(app_state.report_requested)
        column.addWidget(self.fault)
        self.no_fit = NoFit()
        self.no_fit.others_wanted.connect(self._study.fit_all)
        self.no_fit.again_wanted.connect(lambda: app_state.open_procedure("preflight"))
        column.addWidget(self.no_fit)
        self.views = FitViews(theme)
        self.views.filter_wanted.connect(self._show_growth)
        column.addWidget(self._table_card(), 2)
        column.addWidget(self.views, 3)
        self.elsewhere = GoesOnElsewhere(app_state)
        column.addWidget(self.elsewhere)
        self.idle_queue = IdleQueue(self)
        self._study.changed.connect(self._show)
        self._show()

    def build_more(self) -> bool:
        """Build a part of the first picture; says whether any was missing."""
        return self.views.begin()

    def set_theme(self, theme: Theme) -> None:
        """Names of axes and pictures in the theme's colours."""
        self._theme = theme
        self._show()

    def _head(self) -> Flow:
        self.chooser = RunChooser(self._app_state)
        self.chooser.chosen.connect(self.open_run)
        self.chooser.known.connect(self._show)
        self.fit = button(self.tr("Fit"), self.tr("Estimate by maximum likelihood, the default method"), primary=True)
        self.fit.clicked.connect(lambda: self._study.fit("ml"))
        self.all = button(self.tr("All methods"), self.tr("Estimate by every method, to see whether they agree"))
        self.all.clicked.connect(self._study.fit_all)
        self.cancel = button(self.tr("Cancel"), self.tr("End what is being computed; what is done stays"))
        self.cancel.clicked.connect(self._study.cancel)
        self.draft = button(self.tr("Make a draft"), self.tr("Write a draft calibration from the selected method"))
        self.draft.clicked.connect(self._draft)
        self.trace = button(self.tr("Trace the residual"), self.tr("Find what causes what is left over: the Loop page"))
        self.trace.clicked.connect(self._trace)
        return Flow(self.chooser, self.cancel, self.fit, self.all, self.draft, self.trace)

    def _table_card(self) -> Card:
        card = Card(self.tr("Methods side by side"), self.tr("value ± U, k=2"))
        self.empty = label("", "ask", wrap=True)
        self.empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.table = Table((self.tr("parameter"),))
        self.table.show_rows(LEAST_ROWS, LEAST_ROWS)
        self.table.setToolTip(self.tr("Choose a column to see its pictures"))
        self.table.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        self.table.horizontalHeader().geometriesChanged.connect(self._fill_table)
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectColumns)
        self.table.itemSelectionChanged.connect(self._show_pictures)
        self.to_run = go_to_run_button(self._app_state)
        self.verdict = label("", wrap=True)
        self.verdict.setAccessibleName(self.tr("Whether the fit is good"))
        self.verdict.setToolTip(translated(str(OF_WHICH)))
        card.body.addWidget(self.verdict)
        card.body.addWidget(self.empty, 1)
        card.body.addWidget(self.to_run, 1, Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignTop)
        card.body.addWidget(self.table, 1)
        card.body.addLayout(self._set_aside())
        self.why = label("", "caption", wrap=True)
        self.why.hide()
        card.body.addWidget(self.why)
        return card

    def _set_aside(self) -> QHBoxLayout:
        """Which methods have no part in the verdict, and behind a fold what they say."""
        self.aside, self.fold = (
            label("", "caption", wrap=True),
            button(self.tr("Why"), self.tr("What each of them says")),
        )
        self.fold.setCheckable(True)
        self.fold.toggled.connect(self._show_why)
        row = QHBoxLayout()
        row.addWidget(self.aside, 1)
        row.addWidget(self.fold, 0, Qt.AlignmentFlag.AlignTop)
        return row

    def _show_why(self, shown: bool) -> None:
        """It opens downward: the table above keeps its height, and the button stays below the mouse."""
        if shown:
            self.table.setMinimumHeight(self.table.height())
        else:
            self.table.setMinimumHeight(0)  # of its rows
        self.why.setVisible(shown)

    def open_run(self, run: str) -> None:
        """Study `run`."""
        self.chooser.show_run(run)
        self._app_state.one_dut.open(run)

    def _trace(self) -> None:
        self._app_state.page_requested.emit("Loop")
        if not self._app_state.path.traced(self._study.run):
            self._study.close_loop()

    def _draft(self) -> None:
        if (method := self.method()) is not None:
            self._study.draft(method)
            self._app_state.page_requested.emit("Certificate")

    def method(self) -> str | None:
        """The method whose column is selected, else the best that came to a result."""
        chosen, names = self.table.selectedIndexes(), list(self._study.fits)
        name = names[chosen[0].column() - 1] if chosen and 0 < chosen[0].column() <= len(names) else ""
        return name if name and self._study.fits[name].fit.ok else self._study.best()

    def _show(self) -> None:
        study = self._study
        self.fault.show_fault(study.fault)
        self.no_fit.show_study(study)
        if self.chooser.currentData() != study.run:
            self.chooser.show_run(study.run)
        refused = self._app_state.path.why_no_fit(study.run)
        self.waiting.setText(
            self.tr("computing: {0}").format(", ".join(map(translated, study.waiting))) if study.busy else refused
        )
        self.waiting.setVisible(bool(self.waiting.text()))
        self.cancel.setVisible(study.busy)
        self.work.show_work(study.busy)
        for widget in (self.fit, self.all):
            widget.setVisible(not study.busy)
        ready = bool(study.run) and not study.busy and not refused
        self.fit.setEnabled(ready and "ml" not in study.fits)
        self.all.setEnabled(ready and bool(study.methods))
        self.draft.setEnabled(study.best() is not None and not refused)
        traced = self._app_state.path.traced(study.run)
        self.trace.setText(self.tr("See what was found") if traced else self.tr("Trace the residual"))
        self.trace.setEnabled(ready and not study.no_fit)
        set_primary(self.fit, "ml" not in study.fits)
        set_primary(self.trace, "ml" in study.fits and not traced and not study.no_fit)
        self.empty.setVisible(not study.fits)
        self.table.setVisible(bool(study.fits))
        self.idle_queue.add(self._show_fits, self._show_pictures)
        self._say_empty()

    def _say_empty(self) -> None:
        """What to do where there is no fit yet."""
        study, none = self._study, "" if self._study.run else self.chooser.why_none()
        refused = self._app_state.path.why_no_fit(study.run)
        kept = kept_words(self._app_state.path, study.run)
        if kept and not refused:
            kept += "\n" + self.tr(
                "Pictures and the figures of each method are not kept: Fit works them out again, side by side."
            )
        finds = self.tr(
            "Fit finds what turns a reading into field: the gains K and the offset k of the sensor. All methods "
            "compares eleven ways."
        )
        exactly = self.tr(
            "b = K m − k: the field b [nT] of the reading m. K are nine gains, a row for each axis of the field; k is "
            "the offset [nT]."
        )
        ready = refused or kept or finds
        waits = self.tr("The first method takes some seconds.") if study.busy else ready
        self.empty.setText(none or (waits if study.run else self.tr("Choose a run above, then Fit.")))
        self.empty.setToolTip(exactly if self.empty.text() == finds else "")
        self.to_run.setVisible(bool(none))
        self.views.setVisible(bool(study.run))

    def _show_fits(self) -> None:
        fits = self._study.fits
        self.table.set_headings((self.tr("parameter"), *fits))
        self.table.right_heading(*range(1, len(fits) + 1))
        names = (*QUALITY, *OFFSETS)
        self.table.setRowCount(len(names) + len(GAINS))
        for row, name in enumerate(names):
            self.table.set_cell(row, 0, translated(name), colour=self._colour(name))
        for row, gain in enumerate(GAINS, start=len(names)):
            self.table.set_cell(row, 0, gain_name(*gain), tip=gain_means(*gain))
        for column, said in enumerate(fits.values(), start=1):
            for row, text in enumerate(cells(said.fit)):
                self.table.set_cell(row, column, text, right=True, tip=in_words(said.fit.why_not or ""))

        self._fill_table()
        self.why.setText("\n".join(refusals(fits)))
        self.aside.setText(set_aside_words(fits, self.method() or ""))
        aside = bool(self.aside.text()) and not self._study.no_fit  # else the card above says it
        self.aside.setVisible(aside)
        self.fold.setVisible(aside)
        self.why.setVisible(aside and self.fold.isChecked())

    def _fill_table(self) -> None:
        """What room is left goes to the names, as in every table of figures; with less, the table rolls."""
        header, mode = self.table.horizontalHeader(), QHeaderView.ResizeMode
        columns = range(header.count())
        needed = sum(max(self.table.sizeHintForColumn(n), header.sectionSizeHint(n)) for n in columns)
        wanted = mode.Stretch if needed < self.table.viewport().width() else mode.ResizeToContents
        if header.sectionResizeMode(0) != wanted:
            header.setSectionResizeMode(0, wanted)

    def _colour(self, name: str) -> str:
        axis = name.split()[2] if name in OFFSETS else ""
        return getattr(self._theme, f"axis_{axis}") if axis else ""

    def _show_pictures(self) -> None:
        method = self.method() or ""
        words, state = said_of(method, self._study.fits.get(method), self._app_state.path.traced(self._study.run))
        self.verdict.setText(words)
        self.verdict.setVisible(bool(words))
        set_state(self.verdict, state)
        self.views.show_fit(self._study.look, method, self._study.fits.get(method))
        if self.views.shown() == "growth":
            self._show_growth()

    def _show_growth(self) -> None:
        method = self.method()
        name = method if method in FILTERS else FILTERS[0]
        if self._study.run:
            self._study.follow(name)
        self.views.show_growth(name, self._study.growth.get(name))


def refusals(fits: dict[str, Fitted], most: int = 2) -> list[str]:
    """Why methods gave no calibration, a reason once, with the methods that it is of."""
    reasons: dict[str, list[str]] = {}
    for name, said in fits.items():
        if not said.fit.ok:
            reasons.setdefault(in_words(said.fit.why_not or ""), []).append(name)
    return [f"✕ {', '.join(names)}: {why}" for why, names in reasons.items()][:most]


def cells(fit: FitFigures) -> list[str]:
    """One method's column: how good it is, then k and K with U (k=2)."""
    if not fit.ok or fit.K is None or fit.k_nT is None:
        return ["✕", *["–"] * (len(QUALITY) + len(OFFSETS) + len(GAINS) - 1)]
    worst = max(fit.axis_error_deg, default=None) if fit.axis_error_deg else None
    quality = ((fit.holdout_rms_scalar_nT, 1), (worst, 3), (fit.seconds, 2))
    said = ["–" if value is None else format_number(value, decimals, signed=False) for value, decimals in quality]
    said.append(translated("known") if fit.frame_known else translated("free"))
    values = [(n + 9, k) for n, k in enumerate(fit.k_nT)]
    values += list(enumerate(v for row in fit.K for v in row))
    return said + [_with_U(value, fit.covariance, at) for at, value in values]


def _with_U(value: float, covariance: Matrix | None, at: int) -> str:
    if covariance is None:
        return format_number(value, 1 if at >= 9 else 5)
    U = 2 * sqrt(max(0.0, covariance[at][at]))
    decimals = decimals_for(U, value)
    return f"{format_number(value, decimals)} ± {format_number(U, decimals, signed=False)}"
