from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from labcal.certificate.report.closed_loop import closed_loop_page
from labcal.certificate.report.html import html
from labcal.certificate.report.page import Headline
from labcal.loop.result import ClosedLoop, Errors, NextExperiment, Pictures
from labcal.model import AffineMap, Calibration
from labcal.record import Dut, Reference, Run, Segment
from labcal.uncertainty.conformity import Assessment, Judged


@pytest.fixture
def run() -> Run:
    return Run(
        run_id="r-1",
        started_utc="2026-11-21T08:00:00Z",
        simulated=True,
        operator="Grace",
        dut=Dut("FM-07", noise_nT=20.0),
        reference=Reference("vector"),
        segments=(Segment("a", "rotation", axis_body=(1.0, 0.0, 0.0)), Segment("b", "static")),
        t_s=np.arange(100.0),
        segment_index=np.repeat([0, 1], 50),
        reading=np.zeros((100, 3)),
        reference_vector=np.zeros((100, 3)),
    )


@pytest.fixture
def result(calibration: Calibration, run: Run) -> ClosedLoop:
    rng = np.random.default_rng(0)
    after = rng.normal(0, 20, (100, 3))
    before = after + 80 * np.sin(run.t_s / 5)[:, None]
    rejected = replace(calibration.effects[0], effect="offset-temperature", why="It helps less than the current does.")
    return ClosedLoop(
        run_id="r-1",
        residual_kind="vector",
        base="affine",
        noise_floor_nT=35.0,
        noise_floor_source="declared",
        before=Errors(90.0, 101.25),
        after=Errors(34.0, 36.5),
        set_aside={"outliers": 3, "saturation": 0},
        accepted=calibration.effects,
        rejected=(rejected,),
        verdict="partly-explained",
        summary="The current of the power supply explains most of it.",
        next_experiment=NextExperiment(
            "They rise together here.", "Switch the load at a constant temperature.", "load_steps"
        ),
        affine=AffineMap.nominal(),
        covariance=None,
        noise_nT=20.0,
        frame_known=True,
        pictures=Pictures(run.t_s, run.segment_index, before, after),
        remarks=("Declared and measured floors agree.",),
    )


def test_the_page_says_what_the_loop_found(result: ClosedLoop, run: Run):
    page = closed_loop_page(result, run)
    assert page.headline == Headline("101.2", "36.5", "nT", page.headline.caption)
    assert page.marks[0].tone == "warning"
    text = html(page)
    for said in (
        "PARTLY EXPLAINED",
        "SIMULATED",
        "explains most of it",
        "3 outliers",
        "offset-current · i_eps",
        "offset-temperature · i_eps",
        "It helps less",
        "Switch the load",
        "procedure load_steps",
        "noise alone would leave 35.0 nT (declared)",
        "mounting uncertainty not included",
    ):
        assert said in text, said
    assert text.count("<svg") == 2
    assert "Rms in each segment, in sample" in text


def test_the_segments_are_told_held_out_where_blocks_were(result: ClosedLoop, run: Run):
    both = np.full((100, 2), np.nan)
    both[10:90] = 90.0, 30.0
    text = html(closed_loop_page(replace(result, pictures=replace(result.pictures, held_out_nT=both)), run))
    assert "Rms in each segment, on held-out blocks" in text


def test_an_accepted_effect_says_what_it_is_and_how_much_it_gains(result: ClosedLoop, run: Run):
    sure = replace(result.accepted[0], improvement_ci95_nT=(58.0, 71.5))
    text = html(closed_loop_page(replace(result, accepted=(sure,)), run))
    assert "Sensor offset in proportion to a housekeeping current" in text
    assert "between 58.0 and 71.5 nT" in text
    assert "Not tried" in text


def test_the_file_is_told_whether_a_vector_or_a_magnitude_was_held_out(result: ClosedLoop):
    """Else a file that knows the frame takes a magnitude's residual for the length of three components."""
    assert result.metrics()["after"]["holdout_components"] == 3
    assert replace(result, residual_kind="scalar").metrics()["after"]["holdout_components"] == 1


def test_a_clean_scalar_result_needs_no_more(result: ClosedLoop, run: Run):
    one = result.pictures.before_nT[:, :1]
    bare = replace(
        result,
        residual_kind="scalar",
        verdict="clean",
        accepted=(),
        rejected=(),
        next_experiment=None,
        remarks=(),
        set_aside={},
        pictures=Pictures(run.t_s, run.segment_index, one, one),
    )
    text = html(closed_loop_page(bare, run))
    assert "CLEAN" in text
    assert "Rows set aside" in text
    for absent in ("Accepted", "Tried and not accepted", "What to measure next", "Remarks"):
        assert absent not in text


def test_a_specification_s_lines_stand_on_the_page_and_in_the_json(result: ClosedLoop, run: Run):
    line = Judged("scale y", 0.49, 0.02, 0.5, "%", "guard band w = 1 U, k = 2", "conditional-pass", 0.1587, 25.0)
    judged = replace(result, conformity=Assessment((line,), ("Of the specification: noise, which nothing shows.",)))
    text = html(closed_loop_page(judged, run))
    for said in (
        "Is it in specification?",
        "conditional pass",
        "16 %",
        "guard band w = 1 U",
        "noise, which nothing shows",
    ):
        assert said in text, said
    assert judged.to_json()["specification"][0]["result"] == "conditional-pass"
    assert "Is it in specification?" not in html(closed_loop_page(result, run))
    assert result.to_json()["specification"] == []
