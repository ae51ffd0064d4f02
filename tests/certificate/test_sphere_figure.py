"""The residual on the sphere in a run's report: drawn after a sphere, left out where the fields do not go all round."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from labcal.certificate.report import run_page
from labcal.certificate.report.harmonics import CAPTION, on_the_sphere
from labcal.certificate.report.html import html
from labcal.fit import Fit
from labcal.model import AffineMap
from labcal.record import Dut, Reference, Run, Segment
from procedures.field_sphere import lattice


def a_sphere(fields: np.ndarray, *, cubic_nT: float = 0.0) -> tuple[Run, np.ndarray]:
    """A run at rest in `fields` (n, 3), five rows in each, and a residual with a cubic of this size on each axis."""
    rows, each = np.repeat(fields, 5, axis=0), len(fields)
    direction = rows / np.linalg.norm(rows, axis=1, keepdims=True)
    residual = cubic_nT * direction**3 + np.random.default_rng(1).normal(0, 2.0, rows.shape)
    body = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    run = Run(
        run_id="S", started_utc="2026-01-01T00:00:00Z", simulated=True, operator="", dut=Dut("D"),
        reference=Reference("vector"),
        segments=tuple(Segment(f"{k}", "static", body_from_cage=body) for k in range(each)),
        t_s=np.arange(len(rows), dtype=float), segment_index=np.repeat(np.arange(each), 5),
        reading=rows + residual, reference_vector=rows,
    )  # fmt: skip
    return run, residual


def heights(run: Run, residual: np.ndarray) -> list[float]:
    """Of the bars that are drawn, degree by degree."""
    plot, figure = on_the_sphere(run, residual), Figure()
    assert plot is not None
    plot.draw(figure)
    return [bar.get_height() for bar in figure.axes[0].patches]


def test_a_cubic_is_drawn_at_degrees_one_and_three() -> None:
    bars = heights(*a_sphere(50e3 * lattice(48), cubic_nT=1000.0))
    assert np.abs(np.array(bars) - [0, 600.0, 0, 1000 * np.sqrt(12 / 175)]).max() < 5


def test_the_report_of_a_sphere_has_it_and_of_half_a_sphere_has_not() -> None:
    fit = Fit("ml", True, affine=AffineMap(np.eye(3), np.zeros(3)), phase_rad=np.zeros(0))
    shown = "by degree of spherical harmonics"
    assert shown in CAPTION
    assert shown in html(run_page(a_sphere(50e3 * lattice(48))[0], "ab" * 32, fit))
    half, residual = a_sphere(50e3 * lattice(96)[:48])
    assert on_the_sphere(half, residual) is None
    assert shown not in html(run_page(half, "ab" * 32, fit))
