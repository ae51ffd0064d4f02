"""Two runs beside each other: what changed in figures, and their residuals or loci in one picture."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from PySide6.QtCore import QT_TRANSLATE_NOOP, Signal
from PySide6.QtWidgets import QHBoxLayout, QStackedWidget, QVBoxLayout, QWidget

from labcal.gui.ipc.answers import Compared, Comparison
from labcal.gui.theming.theme import GRID, Theme
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.conformity import change_rows
from labcal.gui.viewmodels.drawn_against import against_words
from labcal.gui.viewmodels.loop_words import verdict_word
from labcal.gui.viewmodels.number_format import format_number
from labcal.gui.viewmodels.path import EXPLAINED
from labcal.gui.widgets.common import Card, button, combo_box, label, offer
from labcal.gui.widgets.measurement_table import Table
from labcal.gui.widgets.plot_export import export_buttons
from labcal.gui.widgets.plots import Loci, legend_above
from labcal.gui.widgets.study_plots import Residuals

HEADINGS = ("figure", "earlier", "later", "± U", "unit", "E_n", "")
OF_THE_DIFFERENCE = "± U (k=2) is that of the difference; beyond E_n = ±1 the DUT has changed."
TWO_DUTS = "They are of two DUTs. ± U (k=2) is that of the difference."
OF_TWO_DUTS = QT_TRANSLATE_NOOP(
    "Words",
    "They are of two DUTs: their offsets and gains are no change of one, and stand in no table. "
    "Residuals and loci of both are drawn below.",
)
NOT_EXPLAINED = "One of the two is not explained: what differs may be its error, and says nothing of the DUT yet."
UNLIKE = "One of the two is traced, the other is not: what differs may be what tracing took out. Trace both, or none."


class ComparisonView(QWidget):
    """`left` when the person has seen enough of it."""

    left = Signal()

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self._shown: Comparison | None = None
        self._alike = True  # both traced, or neither
        self._explained = True  # both, by the loop, or it has not decided
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2 * GRID)
        column.addWidget(self._figures(), 2)
        self.picture = self._picture()
        self.picture.hide()
        column.addWidget(self.picture, 3)

    def set_theme(self, theme: Theme) -> None:
        """Table and picture in the theme's colours."""
        self._theme = theme
        for part in (self.residuals, self.loci):
            part.set_theme(theme)
        self._draw()

    def wait_for(self, words: str) -> None:
        """Say what is under way; nothing of what was shown before stays."""
        self._shown = None
        self.card.heading.setText(words)
        self.whose.setText(self.tr("Runs without a calibration are fitted now."))
        self._draw()

    def show_comparison(self, found: Comparison, verdicts: Mapping[str, str] | None = None) -> None:
        """Show two runs; `verdicts` of the loop, by run, where it has decided."""
        self._shown, said = found, verdicts or {}
        duts = " / ".join(dict.fromkeys((found.older.dut, found.newer.dut)))
        self.card.heading.setText(self.tr("{0}: two runs compared").format(duts))
        earlier, later = self._sides(found)
        sides = ((earlier, found.older), (later, found.newer))
        self.table.set_headings((HEADINGS[0], earlier, later, *HEADINGS[3:]) if found.two_duts else HEADINGS)
        self.whose.setText(
            "\n".join(
                ": ".join(filter(None, (which, self._source(one), verdict_word(said.get(one.run_id, "")))))
                for which, one in sides
            )
        )
        self._alike = len({bool(said.get(one.run_id, "")) for _, one in sides}) == 1
        self._explained = all(said.get(one.run_id, "clean") in EXPLAINED for _, one in sides)
        names = [name for name in found.older.against if name in found.newer.against]
        offer(self.against, names, against_words)
        self._draw()

    def _sides(self, found: Comparison) -> tuple[str, str]:
        """What either is called: of one DUT by which came first, of two by their serials."""
        return (found.older.dut, found.newer.dut) if found.two_duts else (self.tr("Earlier"), self.tr("Later"))

    def _source(self, one: Compared) -> str:
        if one.calibration:
            return self.tr("run {0}, calibration {1}").format(one.run_id, one.calibration)
        return self.tr("run {0}, fitted now (it has no calibration)").format(one.run_id)

    def _figures(self) -> Card:
        self.card = Card(self.tr("Two runs compared"), self.tr("U: k=2"))
        self.whose, self.remark = label("", "caption", wrap=True), label("", "caption", wrap=True)
        self.table = Table(HEADINGS)
        self.table.right_heading(1, 2, 3, 5)
        self.table.setMinimumHeight(12 * GRID)
        self.back = button(self.tr("Back"), self.tr("To the list of runs"))
        self.back.clicked.connect(self.left)
        row = QHBoxLayout()
        row.addWidget(self.whose, 1)
        row.addWidget(self.back)
        self.card.body.addLayout(row)
        self.card.body.addWidget(self.remark)
        self.card.body.addWidget(self.table, 1)
        self.card.body.addStretch()
        return self.card

    def _picture(self) -> Card:
        card = Card()
        self.view = combo_box(self.tr("What of the two runs is drawn over each other"), self.tr("View"))
        self.view.addItems((self.tr("Residuals of the magnitude"), self.tr("Loci on the sphere, calibrated")))
        self.against = combo_box(self.tr("What the residuals are drawn against"), self.tr("Against"))
        self.residuals, self.loci = Residuals(self._theme, self.tr("residual of |b|  nT")), Loci(self._theme, clouds=2)
        self.faces = QStackedWidget()
        for face in (self.residuals, self.loci):
            self.faces.addWidget(face)
        self.words = label("", "caption", wrap=True)
        self.view.activated.connect(self._draw)
        self.against.activated.connect(self._draw)
        row = QHBoxLayout()
        row.addWidget(self.view, 2)
        row.addWidget(self.against, 1)
        for widget in export_buttons(self, lambda: self.loci if self.view.currentIndex() else self.residuals):
            row.addWidget(widget)
        card.body.addLayout(row)
        card.body.addWidget(self.faces, 1)
        card.body.addWidget(self.words)
        return card

    def _draw(self) -> None:
        found = self._shown
        self.picture.setVisible(found is not None)  # axes of nothing, from 0 to 1, say nothing
        self._show_rows(found)
        self.faces.setCurrentIndex(self.view.currentIndex())
        self.against.setVisible(self.view.currentIndex() == 0)
        if found is None:
            self.residuals.clear()
            self.words.clear()
        elif self.view.currentIndex() == 0:
            self._draw_residuals(found)
        else:
            self._draw_loci(found)

    def _show_rows(self, found: Comparison | None) -> None:
        changes = None if found is None else found.changes
        rows = [] if changes is None else change_rows(changes, alike=self._alike)
        self.table.clearContents()
        self.table.setRowCount(len(rows))
        self.table.setVisible(bool(rows))  # headings without a figure say nothing
        for row, cells in enumerate(rows):
            for column, cell in enumerate(cells):
                colour = getattr(self._theme, cell.state) if cell.state else ""
                self.table.set_cell(row, column, cell.text, right=cell.right, colour=colour, tip=cell.tip)
        if changes is not None:
            means = OF_THE_DIFFERENCE if self._explained else NOT_EXPLAINED
            means = TWO_DUTS if found is not None and found.two_duts else means
            said = (changes.in_words(), *changes.remarks) if self._alike else changes.remarks
            self.remark.setText(" ".join((*map(in_words, said), translated(means if self._alike else UNLIKE))))
        else:
            refused = (
                "" if found is None else translated(str(OF_TWO_DUTS)) if found.two_duts else in_words(found.refused)
            )
            self.remark.setText(refused)

    def _named(self, found: Comparison) -> list[tuple[str, str, Compared]]:
        """Name and colour of either run, the later one in front."""
        earlier, later = self._sides(found)
        return [(earlier, self._theme.before, found.older), (later, self._theme.after, found.newer)]

    def _draw_residuals(self, found: Comparison) -> None:
        against = self.against.currentData()
        named = [(n, c, one, one.residual) for n, c, one in self._named(found)]
        clouds = [(n, c, one.against[against], left) for n, c, one, left in named if left is not None]
        stated = [one.noise_nT for _, _, one, _ in named if one.noise_nT is not None and one.noise_stated]
        noise = stated or [one.noise_nT for _, _, one, _ in named if one.noise_nT is not None]
        self.residuals.show_clouds(against, clouds, max(noise, default=None))
        rms = [f"{n}: {self._rms(left)}" for n, _, _, left in named]
        own = self.tr("band: the larger noise that the two fits make of their own residuals, k=2; none is stated")
        means = self.tr("band: the larger of the two runs' stated noises of |b|, k=2, as on the Fit page")
        self.words.setText("   ".join((*rms, (means if stated else own) if noise else "")))

    def _rms(self, left: np.ndarray | None) -> str:
        good = np.empty(0) if left is None else left[np.isfinite(left)]
        if not len(good):
            return self.tr("no reference, no residual")
        rms = format_number(float(np.sqrt(np.mean(good**2))), signed=False)
        return self.tr("mean {0} nT, rms {1} nT").format(format_number(float(good.mean())), rms)

    def _draw_loci(self, found: Comparison) -> None:
        named = self._named(found)
        for cloud, (_, _, one) in enumerate(reversed(named)):
            self.loci.show_field(one.after, cloud)
        legend_above(self.loci.plots[0], [(name, colour) for name, colour, _ in named])
        self.words.setText(self.tr("faint: behind the sphere"))
