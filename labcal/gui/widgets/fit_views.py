"""Pictures of a fit as the three papers draw them: loci, magnitudes, residuals, their histogram, a filter's growth."""

from __future__ import annotations

from functools import cached_property
from typing import TypeVar

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QSizePolicy, QStackedWidget, QWidget

from labcal.gui.ipc.answers import Fitted, Growth, Look
from labcal.gui.theming.theme import Theme
from labcal.gui.viewmodels.drawn_against import against_words
from labcal.gui.viewmodels.number_format import format_number
from labcal.gui.viewmodels.turns import turns_of
from labcal.gui.widgets.common import Card, combo_box, label, offer, shrinkable
from labcal.gui.widgets.plot_export import export_buttons
from labcal.gui.widgets.plot_letters import say_above
from labcal.gui.widgets.plots import DASHED, apply_theme, legend_above, named_curves, plot
from labcal.gui.widgets.shell_plot import draw_degrees
from labcal.gui.widgets.study_plots import Residuals, with_alpha
from labcal.gui.widgets.turn_loci import TurnLoci

W = TypeVar("W", bound=QWidget)
FACES = ("loci", "residual", "magnitude", "histogram", "growth", "degrees")  # pictures, by the names of their widgets
BINS = 60
LEAST_PX = 220  # of a picture
SIGMAS = 3.0  # the papers' bounds


def band_of(said: Fitted) -> float | None:
    """The noise of |b| [nT] that is drawn: what the run states, as the verdict has it; else the method's own."""
    return said.noise_nT if said.stated_nT is None else said.stated_nT


class FitViews(Card):
    """One picture at a time, as large as there is room; `filter_wanted` asks for a filter's history."""

    filter_wanted = Signal()

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self._look: Look | None = None
        self._said: Fitted | None = None
        self.view = combo_box(self.tr("The figures of the papers that the methods are from"), self.tr("View"))
        self.against = combo_box(self.tr("What the residual is drawn against"), self.tr("Against"))
        self.words = shrinkable(label("", "caption"))
        self.faces = QStackedWidget()
        row = QHBoxLayout()
        row.addWidget(self.view, 2)
        row.addWidget(self.against, 1)
        for widget in export_buttons(self, lambda: getattr(self, self.shown())):
            row.addWidget(widget)
        self.body.addLayout(row)
        self.body.addWidget(self.faces, 1)
        self.body.addWidget(self.words)
        self.view.addItems(self._titles())
        self.view.activated.connect(self._chosen)
        self.faces.setMinimumHeight(LEAST_PX)
        self.faces.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Ignored)
        self._name_view()
        self.against.activated.connect(self._draw)

    def begin(self) -> bool:
        """Build a part of the first picture; says whether any was missing."""
        if self.faces.count() > 0:
            return self.loci.build_more()
        self._chosen()
        return True

    @cached_property
    def loci(self) -> TurnLoci:
        """Directions as read and calibrated."""
        return self._face(TurnLoci(self._theme, clouds=2))

    @cached_property
    def residual(self) -> Residuals:
        """Of the magnitude, against anything."""
        return self._face(Residuals(self._theme, self.tr("residual of |b|  nT")))

    @cached_property
    def magnitude(self) -> pg.PlotWidget:
        """As read, calibrated, and of the reference."""
        return self._face(plot(self._theme, "time  s", self.tr("|b|  nT")))

    @cached_property
    def histogram(self) -> pg.PlotWidget:
        """Of the residual, with the noise that the method states."""
        return self._face(plot(self._theme, self.tr("residual of |b|  nT"), self.tr("samples")))

    @cached_property
    def growth(self) -> pg.PlotWidget:
        """A filter's bias with its bounds."""
        return self._face(plot(self._theme, "time  s", self.tr("bias of the reading  nT")))

    @cached_property
    def degrees(self) -> pg.PlotWidget:
        """What the map left on shells of one magnitude, by degree."""
        return self._face(
            plot(self._theme, self.tr("degree of spherical harmonics"), self.tr("rms of the residual  nT"))
        )

    def _face(self, widget: W) -> W:
        """A picture is built when it is first looked at."""
        self.faces.addWidget(widget)
        return widget

    def set_theme(self, theme: Theme) -> None:
        """What is shown next has the theme's colours."""
        self._theme = theme
        for n in range(self.faces.count()):
            if isinstance(face := self.faces.widget(n), pg.PlotWidget):
                apply_theme(face, theme)

    def _titles(self) -> tuple[str, ...]:
        """Of `FACES`."""
        return (
            self.tr("Loci on the sphere (Riwanto 2017, figs. 5, 7)"),
            self.tr("Residual of the magnitude (Crassidis 2003, fig. 3)"),
            self.tr("Magnitude and reference (Springmann 2011, figs. 2, 4)"),
            self.tr("Histogram of the residual (Springmann 2011, fig. 7)"),
            self.tr("Bias and 3σ as readings come (Crassidis 2003, figs. 1, 2)"),
            self.tr("Residual on the sphere, by degree (Risbo 2003)"),
        )

    def shown(self) -> str:
        """Which of `FACES` is looked at."""
        return FACES[self.view.currentIndex()]

    def show_fit(self, look: Look | None, method: str, said: Fitted | None) -> None:
        """Draw what is known of a run (`look`) and of one method's answer (`said`)."""
        self._look, self._method, self._said = look, method, said
        offer(self.against, list(look.against) if look else [], against_words)
        self._draw()

    def show_growth(self, method: str, said: Growth | None) -> None:
        """Draw a filter's history: estimates as lines, their bounds as bands of the same colour."""
        self.growth.clear()
        if said is None:
            return
        t, bias, u = said.t_s, said.bias_nT, said.u_nT
        for axis, colour in enumerate(self._theme.axes):
            upper, lower = (
                pg.PlotCurveItem(t, bias[:, axis] + s * u[:, axis], pen=pg.mkPen(with_alpha(colour, 120)))
                for s in (SIGMAS, -SIGMAS)
            )
            for item in (upper, lower, pg.FillBetweenItem(upper, lower, brush=with_alpha(colour, 50))):
                self.growth.addItem(item)
            self.growth.plot(t, bias[:, axis], pen=pg.mkPen(colour, width=2))
        names = [(f"{method}  b{axis}", colour) for axis, colour in zip("xyz", self._theme.axes, strict=True)]
        legend_above(self.growth, names)
        self.growth.autoRange()

    def _chosen(self) -> None:
        self.faces.setCurrentWidget(getattr(self, self.shown()))
        self._name_view()
        if self.shown() == "growth":
            self.filter_wanted.emit()
        self._draw()

    def _name_view(self) -> None:
        """What belongs to the picture that is looked at: a second choice where there is one, and its legend."""
        self.against.setVisible(self.shown() == "residual")
        words = (
            self.tr("grey: as read   strong: calibrated   faint: behind the sphere"),
            self._band_words(),
            "",
            self._line_words(),
            self.tr("the ekf, or the filter that is chosen above"),
            self.tr("lines: what scatter alone gives   2: products of two components   3: a cubic"),
        )
        self.words.setText(words[self.view.currentIndex()])

    def _band_words(self) -> str:
        """What the verdict above goes by; the method's own noise alone where none is stated."""
        if self._said is not None and self._said.stated_nT is None:
            return self.tr("band: the noise that this method makes of its own residual, k=2; none is stated")
        return self.tr("band: the stated noise of |b|, k=2")

    def _line_words(self) -> str:
        if self._said is not None and self._said.stated_nT is None:
            return self.tr("line: the noise that this method makes of its own residual; none is stated")
        return self.tr("line: the stated noise of |b|")

    def _draw(self) -> None:
        """The picture that is looked at."""
        look, said = self._look, self._said
        self._name_view()
        if self.shown() == "degrees":
            draw_degrees(self.degrees, self._theme, () if said is None else said.shells)
        if look is None or self.shown() in ("growth", "degrees"):
            return
        if self.shown() == "loci":
            self.loci.show_field(look.before, 1)
            after = np.empty((0, 3)) if said is None or said.after is None else said.after
            self.loci.show_turns(after, turns_of(look.segments, look.segment_index))
        elif self.shown() == "magnitude":
            self._draw_magnitude(look, said)
        elif self.shown() == "residual":
            self._draw_residual(look, said)
        else:
            self._draw_histogram(said)

    def _draw_residual(self, look: Look, said: Fitted | None) -> None:
        if said is None or said.residual is None:
            return self.residual.clear()
        against = self.against.currentData()
        cloud = (self._method, self._theme.after, said.residual)
        return self.residual.show_residual(against, look.against[against], [cloud], band_of(said))

    def _draw_magnitude(self, look: Look, said: Fitted | None) -> None:
        self.magnitude.clear()
        against = {name.split("  ")[0]: values for name, values in look.against.items()}
        curves = [(self.tr("as read"), self._theme.before, np.linalg.norm(look.before, axis=1))]
        if said is not None and said.after is not None:
            curves.append((self.tr("calibrated"), self._theme.after, np.linalg.norm(said.after, axis=1)))
        if "field" in against:
            curves.append((f"{DASHED} {self.tr('reference')}", self._theme.before, against["field"]))
        named_curves(self.magnitude, against["time"], curves)

    def _draw_histogram(self, said: Fitted | None) -> None:
        self.histogram.clear()
        if said is None or said.residual is None:
            return
        residual, noise_nT = said.residual[np.isfinite(said.residual)], band_of(said)
        if not len(residual):
            return
        counts, edges = np.histogram(residual, BINS)
        bars = pg.BarGraphItem(
            x0=edges[:-1],
            width=np.diff(edges),
            y0=0,
            height=counts,
            pen=None,
            brush=with_alpha(self._theme.before, 160),
        )
        self.histogram.addItem(bars)
        if noise_nT:
            x = np.linspace(edges[0], edges[-1], 301)
            area = len(residual) * (edges[1] - edges[0])
            gauss = area * np.exp(-0.5 * (x / noise_nT) ** 2) / (noise_nT * np.sqrt(2 * np.pi))
            self.histogram.plot(x, gauss, pen=pg.mkPen(self._theme.text, width=2))
        rms = format_number(float(np.sqrt(np.mean(residual**2))), signed=False)
        words = self.tr("mean {0} nT, rms {1} nT").format(format_number(float(residual.mean())), rms)
        say_above(self.histogram, words)
        self.histogram.autoRange()
