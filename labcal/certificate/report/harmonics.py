"""The residual on the sphere: what the map left on each shell of one magnitude, by degree of spherical harmonics."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from labcal.certificate.report.page import Plot
from labcal.certificate.report.style import TEXT, ink
from labcal.fit.harmonics import DEGREES, Shell, shells_of_standstills
from labcal.record import Run

if TYPE_CHECKING:
    from matplotlib.figure import FigureBase

Array = NDArray[np.float64]
CAPTION = (
    "Rms of the residual vector over all directions of one magnitude, by degree of spherical harmonics; the lines: "
    "what its scatter alone gives. A map holds degree 0 and 1; 2 is products of components, 3 a cubic."
)


def on_the_sphere(run: Run, residual: Array) -> Plot | None:
    """The figure of a run at rest in many fields, from its residual (n, 3) [nT]; None where no shell goes all round."""
    found = shells_of_standstills(run, residual)
    return Plot(lambda figure: draw_degrees(figure, found), 2.3, CAPTION) if found else None


def draw_degrees(figure: FigureBase, found: Sequence[Shell]) -> None:
    """A bar for each degree and shell, and a line where the scatter alone would end."""
    axes, width = figure.subplots(), 0.8 / len(found)
    for number, shell in enumerate(found):
        places = np.array(DEGREES) + (number - (len(found) - 1) / 2) * width
        colour, _ = ink(number)
        axes.bar(places, shell.rms_nT, 0.9 * width, color=colour, label=f"{shell.magnitude_nT / 1000:.3g} µT")
        axes.hlines(shell.noise_nT, places - 0.45 * width, places + 0.45 * width, color=TEXT, lw=1.2)
    axes.set_xticks(DEGREES, [f"degree {degree}" for degree in DEGREES])
    axes.set(ylabel="rms (nT)")
    axes.grid(axis="x", visible=False)
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=len(found))
