"""The residual on the sphere in the window: what the report has after a sphere, degree by degree."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pyqtgraph as pg
import pytest

from labcal.gui.ipc import study_commands
from labcal.gui.ipc.answers import FitFigures, Fitted
from labcal.gui.ipc.messages import FitRun, LookAt
from labcal.gui.theming.theme import DARK
from labcal.gui.widgets.fit_views import FACES, FitViews
from labcal.record import Channel as Housekeeping
from labcal.record import Dut, Reference, Run, Segment
from labcal.store import write_bundle
from procedures.field_sphere import lattice

CUBIC_nT = 1000.0


def sphere(path: Path) -> Path:
    """A run at rest in 48 fields of 50 µT, its sensor with a cubic on each axis."""
    fields = np.repeat(50e3 * lattice(48), 5, axis=0)
    body = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    run = Run(
        run_id="S", started_utc="2026-01-01T00:00:00Z", simulated=True, operator="", dut=Dut("D", noise_nT=2.0),
        reference=Reference("vector", noise_nT=2.0),
        segments=tuple(Segment(f"{k}", "static", body_from_cage=body) for k in range(48)),
        t_s=np.arange(len(fields), dtype=float), segment_index=np.repeat(np.arange(48), 5),
        reading=fields + CUBIC_nT * (fields / 50e3) ** 3 + np.random.default_rng(1).normal(0, 2.0, fields.shape),
        reference_vector=fields, channels=(Housekeeping("i", "A", "current", np.zeros(len(fields))),),
    )  # fmt: skip
    write_bundle(run, path)
    return path


@pytest.fixture
def views(qtbot) -> FitViews:
    made = FitViews(DARK)
    qtbot.addWidget(made)
    made.view.setCurrentIndex(FACES.index("degrees"))
    made.view.activated.emit(FACES.index("degrees"))
    return made


def bars(views: FitViews) -> list[float]:
    items = views.degrees.getPlotItem().items
    return [h for item in items if isinstance(item, pg.BarGraphItem) for h in item.opts["height"]]


def test_a_cubic_stands_at_degree_three(views: FitViews, tmp_path: Path) -> None:
    told = study_commands.fit(None, FitRun(str(sphere(tmp_path / "s.zip")), "ml"))
    assert told.shells[0].magnitude_nT == pytest.approx(50e3)
    views.show_fit(None, "ml", told)
    assert np.abs(np.array(bars(views)) - [0, 0, 0, CUBIC_nT * np.sqrt(12 / 175)]).max() < 5
    assert "50 µT" in views.degrees.getPlotItem().titleLabel.text


def test_a_look_says_of_which_segment_each_reading_is(tmp_path: Path) -> None:
    told = study_commands.look(None, LookAt(str(sphere(tmp_path / "s.zip"))))
    assert len(told.segment_index) == len(told.before)
    assert {int(one) for one in told.segment_index} == set(range(len(told.segments)))
    assert all(told.segments)


def test_a_run_without_a_sphere_says_what_would_show_one(views: FitViews) -> None:
    views.show_fit(None, "ml", Fitted(FitFigures(True)))
    assert not bars(views)
    assert "field-sphere" in views.degrees.getPlotItem().titleLabel.text
