"""Runs of one DUT taken together."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from labcal.record import Dut, Reference, Run, Segment
from labcal.record.join import GAP_S, joined
from labcal.record.run import Channel


@pytest.fixture
def first() -> Run:
    return Run(
        "a", "2026-05-01T00:00:00Z", True, "", Dut("S1"), Reference("vector"),
        (Segment("turn", "rotation", mode="nominal", mounting="z", axis_body=(0, 0, 1), axis_cage=(0, 0, 1)),),
        t_s=np.arange(5.0), segment_index=np.zeros(5, dtype=np.intp), reading=np.ones((5, 3)),
        reference_vector=np.full((5, 3), 2.0), angle_deg=np.arange(5.0),
        channels=(Channel("temp", "degC", "temperature", np.arange(5.0)),),
    )  # fmt: skip


def test_a_second_run_goes_on_after_the_first_with_segments_of_its_own(first: Run) -> None:
    second = replace(first, run_id="b", t_s=np.arange(5.0) + 70, started_utc="2026-05-01T01:00:00Z")
    both = joined([first, second, second], "all")
    assert both.run_id == "all"
    assert [s.id for s in both.segments] == ["turn", "turn#2", "turn#3"]
    assert [s.mounting for s in both.segments] == ["z", "z#2", "z#3"]
    assert (np.diff(both.t_s) > 0).all()
    assert both.t_s[5] == 3600.0  # an hour after the first began
    assert both.t_s[10] - both.t_s[9] >= GAP_S
    assert both.segment_index.tolist() == [0] * 5 + [1] * 5 + [2] * 5


def test_what_one_of_them_lacks_is_missing_there(first: Run) -> None:
    second = replace(first, angle_deg=None, channels=(Channel("i", "A", "current", np.ones(5)),))
    both = joined([first, second], "all")
    assert np.isnan(both.angle_deg[5:]).all()
    assert {c.name: np.isnan(c.values).tolist() for c in both.channels} == {
        "temp": [False] * 5 + [True] * 5,
        "i": [True] * 5 + [False] * 5,
    }


def test_another_dut_or_reference_is_refused(first: Run) -> None:
    with pytest.raises(ValueError, match="S2"):
        joined([first, replace(first, dut=Dut("S2"))], "all")
    with pytest.raises(ValueError, match="scalar"):
        joined([first, replace(first, reference=Reference("scalar"))], "all")
