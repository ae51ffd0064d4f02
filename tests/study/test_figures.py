"""The figures of a study are drawn: what they show is what the summary says."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from labcal.certificate.report.style import INKS, WARNING
from labcal.study.figures import FOUND, draw_blind, draw_design, draw_fleet, draw_monte_carlo
from labcal.study.job import Row
from labcal.study.summary import Summary


def summary(*lines: Row) -> Summary:
    return Summary(lines, "", True)


def bars_of(figure: Figure) -> list[Rectangle]:
    return [bar for bar in figure.axes[0].patches if isinstance(bar, Rectangle)]


def marks(figure: Figure) -> set[tuple[float, float]]:
    """Every point that stands by itself."""
    [axes] = figure.axes
    return {(float(np.ravel(line.get_xdata())[0]), float(np.ravel(line.get_ydata())[0]))
            for line in axes.lines if np.size(line.get_xdata()) == 1}  # fmt: skip


def test_a_monte_carlo_has_error_and_U_over_lab_time_and_what_is_wanted() -> None:
    line: Row = {"noise": "loud", "jobs": 4, "lab_min": 5.0, "direction_error_95_deg": 0.04,
                 "direction_U_median_deg": 0.05}  # fmt: skip
    without: Row = {**line, "noise": "none", "direction_error_95_deg": None, "direction_U_median_deg": None}
    draw_monte_carlo(figure := Figure(), summary(line, without), 0.1)
    assert marks(figure) == {(5.0, 0.04), (5.0, 0.05)}
    assert [float(np.ravel(line.get_ydata())[0]) for line in figure.axes[0].lines if line.get_linestyle() == "--"] == [
        0.1
    ]
    assert [text.get_text() for text in figure.legends[0].get_texts()] == ["noise loud"]


def test_a_design_has_the_choice_and_all_rotations() -> None:
    line: Row = {"accuracy_deg": 0.1, "jobs": 2, "lab_min": 9.5, "direction_U_deg": 0.05, "all_lab_min": 14.7,
                 "all_U_deg": 0.04}  # fmt: skip
    draw_design(figure := Figure(), summary(line))
    assert marks(figure) == {(9.5, 0.05), (14.7, 0.04)}


def test_blind_trials_are_bars_as_long_as_there_are_trials() -> None:
    line: Row = {"jobs": 6, **dict.fromkeys(FOUND, 0), "right": 4, "wrong": 2}
    draw_blind(figure := Figure(), summary(line))
    bars = {(bar.get_x(), bar.get_width()) for bar in bars_of(figure) if bar.get_width()}
    assert bars == {(0.0, 4.0), (4.0, 2.0)}


@pytest.mark.parametrize("worst", [lambda U: U, lambda U: -U])
def test_a_fleet_s_bars_fall_and_those_beyond_U_are_marked(worst: Callable[[float], float]) -> None:
    rows: list[Row] = [{"worst_change_U": worst(U)} for U in (0.5, 3.6, 1.2)]
    draw_fleet(figure := Figure(), [*rows, {"why_not": "gone"}])
    bars = bars_of(figure)
    assert [bar.get_height() for bar in bars] == [3.6, 1.2, 0.5]
    assert [to_hex(bar.get_facecolor()) for bar in bars] == [to_hex(c) for c in (WARNING, WARNING, INKS[0])]
