"""The term without a name on a page: its curve with its band, or its map, and what it is."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from labcal.certificate.report.page import Block, Plot
from labcal.certificate.report.style import AXES
from labcal.loop.result import ClosedLoop
from labcal.model import EffectRecord
from labcal.model.effects.inputs import CHANNEL, UNITS
from labcal.model.smooth import curve
from labcal.record import Run

if TYPE_CHECKING:
    from matplotlib.figure import FigureBase

POINTS, GRID = 160, 60
COVERAGE = 2.0


def empirical_blocks(result: ClosedLoop, run: Run) -> list[Block]:
    """The figure of each empirical term, shipped or proposed."""
    terms = [(e, "shipped") for e in result.accepted if e.basis is not None]
    terms += [(e, "proposed, not shipped: close-loop --empirical ships it") for e in result.proposed]
    return [_figure(term, run, said) for term, said in terms]


def _figure(term: EffectRecord, run: Run, said: str) -> Plot:
    where = "Outside what is drawn it is left out, the row flagged `domain`, and u grows to the prior"
    caption = f"A term without a name, {said}. {term.why} {where} ({_prior(term):.0f} nT)."
    if len(term.inputs) == 1:
        return Plot(lambda figure: draw_curve(figure, term, run), 2.6, f"{caption} Bands: U, k = 2.")
    return Plot(lambda figure: draw_map(figure, term, run), 2.8, caption)


def _prior(term: EffectRecord) -> float:
    return 0.0 if term.basis is None else term.basis.prior_nT


def draw_curve(figure: FigureBase, term: EffectRecord, run: Run) -> None:
    """The function on each axis over its domain, with its expanded uncertainty."""
    axes, hull = figure.subplots(), np.array(term.domain[0].hull)
    x = np.linspace(hull.min(), hull.max(), POINTS)
    assert term.basis is not None
    f, u = curve(term.basis, x[:, None])
    for i, (name, colour) in enumerate(zip("xyz", AXES, strict=True)):
        axes.plot(x, f[:, i], color=colour, label=name)
        axes.fill_between(x, (f - COVERAGE * u)[:, i], (f + COVERAGE * u)[:, i], color=colour, alpha=0.2, lw=0)
    axes.set(xlabel=_label(term.inputs[0], run), ylabel="offset (nT)")
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=3)


def draw_map(figure: FigureBase, term: EffectRecord, run: Run) -> None:
    """The function along its largest direction over its domain, and its expanded uncertainty beside it."""
    hull = np.array(term.domain[0].hull)
    grid = [np.linspace(low, high, GRID) for low, high in zip(hull.min(axis=0), hull.max(axis=0), strict=True)]
    x = np.array([(a, b) for a in grid[0] for b in grid[1]])
    assert term.basis is not None
    f, u = curve(term.basis, x)
    seen = ~term.domain[0].outside(x)
    along = np.linalg.svd(f[seen] - f[seen].mean(axis=0), full_matrices=False)[2][0]
    panels = figure.subplots(1, 2, sharey=True)
    for panel, values, name in zip(
        panels,
        (f @ along, COVERAGE * np.sqrt(u**2 @ along**2)),
        (f"offset along ({along[0]:.2f}, {along[1]:.2f}, {along[2]:.2f}), nT", "U (k = 2), nT"),
        strict=True,
    ):
        drawn = np.where(seen, values, np.nan).reshape(GRID, GRID).T
        mesh = panel.pcolormesh(grid[0], grid[1], drawn, cmap="cividis", shading="nearest", rasterized=True)
        figure.colorbar(mesh, ax=panel)
        panel.set(xlabel=_label(term.inputs[0], run))
        panel.set_title(name)
        panel.grid(visible=False)
    panels[0].set(ylabel=_label(term.inputs[1], run))


def _label(name: str, run: Run) -> str:
    if not name.startswith(CHANNEL):
        return f"{name.replace('_', ' ')} ({UNITS[name.partition('_')[0]]})"
    channel = run.channel(name.removeprefix(CHANNEL))
    return f"{channel.name} ({channel.unit.replace('degC', '°C')})"
