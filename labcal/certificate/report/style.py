"""Colours, line widths and numbers of every printed page: Okabe-Ito inks on white, one way to write a number."""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import Any

TEXT, MUTED, LINE = "#1c2126", "#57606a", "#d5d9dd"
GOOD, WARNING, BAD = "#00694b", "#8a5a00", "#b23a00"
AXES = ("#d55e00", "#009e73", "#0072b2")  # x, y, z: vermilion, green, blue
INKS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#57606a", "#000000")
MARKERS = "o^sDvP<>"
WIDTH_IN = 7.0
SYMBOLS = {"uT": "µT", "deg": "°", "arcmin": "′", "arcsec": "″"}
NOTHING = "–"
NOT_MEASURED = "not measured"
ROUNDING = 1e-12  # of a value
LONGEST_LABEL = 24

_RC: Any = {
    "font.family": "DejaVu Sans",
    "font.size": 8.0,
    "axes.edgecolor": MUTED,
    "axes.labelcolor": TEXT,
    "axes.linewidth": 0.6,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.titlesize": 8.5,
    "axes.titlelocation": "left",
    "axes.titlecolor": TEXT,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": LINE,
    "grid.linewidth": 0.5,
    "xtick.color": MUTED,
    "ytick.color": MUTED,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "legend.frameon": False,
    "lines.linewidth": 1.0,
    "svg.hashsalt": "labcal",
    "pdf.fonttype": 42,
    "text.parse_math": False,  # a dollar in somebody's segment id is a dollar
}


@contextmanager
def plot_style() -> Iterator[None]:
    """Draw in the house's style; the same input gives the same bytes.

    A letter that the font lacks is drawn as an empty box, without a word on stderr.
    """
    from matplotlib import rc_context

    with rc_context(_RC), warnings.catch_warnings():
        warnings.filterwarnings("ignore", message="Glyph .* missing from font")
        yield


def short(name: str) -> str:
    """`name` as it fits beside a drawing: its first LONGEST_LABEL letters."""
    return name if len(name) <= LONGEST_LABEL else f"{name[: LONGEST_LABEL - 1]}…"


def ink(index: int) -> tuple[str, str]:
    """Colour and marker of the series `index`: no two of 56 share both."""
    return INKS[index % len(INKS)], MARKERS[(index + index // len(INKS)) % len(MARKERS)]


def number(value: float | None, decimals: int = 1) -> str:
    """`value` with fixed decimals, a true minus and thin groups of three; a dash for None."""
    if value is None or not math.isfinite(value):
        return NOTHING
    text = f"{value:,.{decimals}f}"
    if not text.strip("-0.,"):
        text = text.lstrip("-")
    return text.replace(",", "\u202f").replace("-", "\u2212")


def with_unit(text: str, unit: str) -> str:
    """A number with its unit, as it stands in a sentence: of a ratio, whose unit is 1, the number alone."""
    return text if unit == "1" else f"{text} {printed_unit(unit)}"


def printed_unit(unit: str) -> str:
    """A unit with its symbol of the SI, where a file has letters for it."""
    return SYMBOLS.get(unit, unit.replace("degC", "°C"))


def sentence(text: str) -> str:
    """`text` with a capital and a full stop, as it stands on paper."""
    text = text.strip()
    return text and text[0].upper() + text[1:] + ("" if text.endswith((".", "!", "?")) else ".")


def two_digits(U: float) -> str:
    """An expanded uncertainty with two significant digits (GUM, 7.2.6; ILAC P14:09/2020, 5)."""
    return with_uncertainty(U, U)[1]


def with_uncertainty(value: float, U: float, most: int = 9) -> tuple[str, str]:
    """A value and its expanded uncertainty, U with two significant digits and the value to the same place.

    At most `most` decimals; of an uncertainty that is zero or not known, three decimals and a dash.
    """
    if not (math.isfinite(U) and U > 0):
        return number(value, 3), number(U, 3)
    place = 1 - math.floor(math.log10(U))
    if round(U, place) >= 10.0 ** (2 - place):  # 0.0996 is 0.10
        place -= 1
    place = min(place, most)
    return number(round(value, place), max(0, place)), number(round(U, place), max(0, place))


def of_the_map(value: float, U: float, most: int = 9) -> tuple[str, str]:
    """The same of a figure of the map: what has no uncertainty at all was held as it stands."""
    written, spread = with_uncertainty(value, U, most)
    rounding = ROUNDING * max(abs(value), 1.0)
    return written, spread if rounding < U else NOT_MEASURED


def decimals_for(uncertainties: Iterable[float], most: int = 9) -> int:
    """Decimals that show the smallest of the uncertainties with two digits (GUM, 7.2.6)."""
    real = [u for u in uncertainties if u > 0 and math.isfinite(u)]
    return min(most, max(0, 1 - math.floor(math.log10(min(real))))) if real else 3
