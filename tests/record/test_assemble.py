"""Streams to rows: interpolated between near neighbours, never held, never across a gap."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from labcal.record import ChannelSpec, Dut, Reference, Run, RunHeader, Segment
from labcal.record.assemble import assemble
from labcal.record.stream import RESUMED, Block, Event, Item, ModeChanged, SegmentClosed, SegmentOpened

HEADER = RunHeader(
    "r", "2026-03-02T08:15:00Z", True, "", Dut("S"), Reference("vector"), (ChannelSpec("temp", "degC", "temperature"),)
)
X = Segment("x", "rotation", "nominal")


def dut(t: np.ndarray) -> Block:
    return Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), t, np.outer(t, [1, 10, 100]))


def reference(t: np.ndarray, of: Callable[[np.ndarray], np.ndarray] = lambda t: np.outer(t, [1, 2, 3])) -> Block:
    return Block("reference", "ref", ("ref_x", "ref_y", "ref_z"), t, of(t))


def angle(t: np.ndarray, values: np.ndarray) -> Block:
    return Block("angle", "stage", ("angle_deg",), t, values[:, None])


def temperature(t: np.ndarray, values: np.ndarray) -> Block:
    return Block("channel", "dut", ("temp",), t, np.asarray(values, dtype=float)[:, None])


def in_one_segment(*items: Item) -> Run:
    return assemble(HEADER, [SegmentOpened(0.0, X), *items, SegmentClosed(1e9)])


def test_a_row_is_a_sample_of_the_dut_and_the_reference_is_between_its_neighbours() -> None:
    t = np.arange(1.0, 5.0, 0.25)
    run = in_one_segment(dut(t), reference(np.arange(0.0, 6.0, 0.1)))
    np.testing.assert_array_equal(run.t_s, t)
    np.testing.assert_array_equal(run.reading, np.outer(t, [1, 10, 100]))
    assert run.reference_vector is not None
    np.testing.assert_allclose(run.reference_vector, np.outer(t, [1, 2, 3]), rtol=1e-12)


def test_samples_that_came_in_one_piece_are_all_kept_and_put_apart_in_their_order() -> None:
    sent = np.arange(1.0, 9.0, 0.001)  # a thousand a second, taken in every 5 ms
    came = np.floor(sent * 200 + 1e-9) / 200
    values = np.outer(np.arange(len(sent)), [1.0, 2.0, 3.0])
    run = in_one_segment(Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), came, values), reference(came))
    np.testing.assert_array_equal(run.reading, values)
    assert (np.diff(run.t_s) > 0).all()
    np.testing.assert_allclose(run.t_s, sent, atol=1e-5)  # a hundredth of their period


def test_beyond_two_periods_and_beyond_the_ends_nothing_is_held() -> None:
    stamps = np.array([0, 1, 2, 3, 4, 5, 9, 10, 11, 12, 13, 21, 22, 23], dtype=float)  # period 1, gaps of 4 and 8
    when = np.array([-0.5, 0.0, 0.5, 5.0, 6.5, 7.0, 7.5, 9.0, 13.0, 14.9, 17.0, 21.0, 23.0, 23.1]) + 1.0
    run = in_one_segment(dut(when), reference(stamps + 1.0))
    assert run.reference_vector is not None
    there = np.isfinite(run.reference_vector[:, 0])
    # in the gap of 4 only its middle lies within two periods of both neighbours
    expected = [False, True, True, True, False, True, False, True, True, False, False, True, True, False]
    np.testing.assert_array_equal(there, expected)
    np.testing.assert_allclose(run.reference_vector[there, 1], 2 * run.t_s[there])


@given(st.floats(-2000, 2000), st.floats(-90, 90).filter(lambda rate: abs(rate) > 1e-3), st.booleans())
def test_the_angle_goes_through_the_wrap(start: float, rate: float, wrapped: bool) -> None:
    stamps, when = np.arange(0.0, 20.0), np.arange(0.25, 18.0, 0.5)
    truth = start + rate * stamps
    run = in_one_segment(dut(when), angle(stamps, truth % 360 if wrapped else truth))
    assert run.angle_deg is not None
    error = (run.angle_deg - (start + rate * when) + 180) % 360 - 180
    np.testing.assert_allclose(error, 0, atol=1e-9)


def test_a_missing_cell_is_bridged_by_its_own_neighbours_only() -> None:
    stamps = np.arange(0.0, 10.0)
    values = np.where(np.isin(stamps, [3.0, 6.0, 7.0, 8.0]), np.nan, stamps)
    run = in_one_segment(dut(np.array([2.5, 3.0, 6.0, 7.0, 9.0])), temperature(stamps, values))
    np.testing.assert_allclose(run.channel("temp").values, [2.5, 3.0, np.nan, 7.0, 9.0])


def test_samples_between_segments_belong_to_none_and_a_segment_opened_again_is_another() -> None:
    t = np.arange(0.0, 10.0)
    still = Segment("still", "static")
    items = [
        SegmentOpened(1.0, X),
        SegmentClosed(3.0),
        SegmentOpened(5.0, still),
        SegmentOpened(6.0, X),  # opened without closing the one before
        dut(t),
    ]
    run = assemble(HEADER, items)
    assert [segment.id for segment in run.segments] == ["x", "still", "x-2"]
    np.testing.assert_array_equal(run.t_s, [1, 2, 5, 6, 7, 8, 9])
    np.testing.assert_array_equal(run.segment_index, [0, 0, 1, 2, 2, 2, 2])


def test_modes_are_the_last_known_and_before_the_first_the_segments() -> None:
    run = in_one_segment(dut(np.arange(5.0)), ModeChanged(1.5, "full"), ModeChanged(3.0, "nominal"))
    assert list(run.mode) == ["nominal", "nominal", "full", "nominal", "nominal"]
    assert run.row_mode is not None
    assert run.row_mode[0] == ""


def test_blocks_in_any_order_make_one_run_and_a_stamp_counts_once() -> None:
    t = np.arange(0.0, 4.0, 0.5)
    run = in_one_segment(dut(t[4:]), dut(t[:5]))
    np.testing.assert_array_equal(run.t_s, t)


def test_a_scalar_reference_is_a_magnitude() -> None:
    header = RunHeader("r", "2026-03-02T08:15:00Z", True, "", Dut("S"), Reference("scalar"))
    t = np.arange(3.0)
    block = Block("reference", "pm", ("ref_f",), t, 48000 + t[:, None])
    run = assemble(header, [SegmentOpened(0.0, X), dut(t), block])
    assert run.reference_vector is None
    np.testing.assert_array_equal(run.magnitude_nT, 48000 + t)


@pytest.mark.parametrize("items", [[], [SegmentOpened(0.0, X)], [dut(np.arange(3.0))], [reference(np.arange(3.0))]])
def test_a_run_that_was_cut_short_has_no_rows_and_is_no_error(items: list[Item]) -> None:
    run = assemble(HEADER, items)
    assert len(run) == 0
    assert run.reference_vector is not None
    assert run.reference_vector.shape == (0, 3)


def test_a_segment_that_is_not_used_leaves_the_rows_and_its_second_try_keeps_a_name_of_its_own() -> None:
    t = np.arange(0.0, 8.0, 0.5)
    refused = Event(3.0, "not-used", "lift moved", {"segments": ["x"]})
    first = [SegmentOpened(0.0, X), SegmentClosed(2.0), refused]
    run = assemble(HEADER, [dut(t), *first, SegmentOpened(4.0, X), SegmentClosed(6.0)])
    assert [segment.id for segment in run.segments] == ["x-2"]
    np.testing.assert_array_equal(run.t_s, [4.0, 4.5, 5.0, 5.5])


def test_a_turn_that_broke_off_ends_where_the_run_is_gone_on_with():
    """A stop, a crash or a power cut closes no segment; what is recorded after it is of other steps, or of hands."""
    t = np.arange(0.0, 10.0, 0.1)
    broken = [SegmentOpened(0.0, X), Event(4.0, RESUMED, "goes on after an interruption")]
    run = assemble(HEADER, [dut(t), *broken, SegmentOpened(8.0, X), SegmentClosed(9.0)])
    assert [segment.id for segment in run.segments] == ["x", "x-2"]
    first, again = run.t_s[run.rows(0)], run.t_s[run.rows(1)]
    assert (first.max() < 4.0, again.min() >= 8.0) == (True, True)
    assert len(run) == len(first) + len(again)
