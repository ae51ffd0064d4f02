"""Lines of text: the column map, cut lines, noise, and the DUT's own clock."""

from __future__ import annotations

import os
import pty
import sys
from datetime import UTC, datetime

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from listening import Sender

from drivers.csv_line import CsvLine, Settings
from labcal.bench.clock import RealClock, VirtualClock
from labcal.bench.links import EmulatedLink, open_link
from labcal.errors import InstrumentError
from labcal.record.stream import Block


def heard(pieces: list[tuple[float, bytes]], **settings: object) -> tuple[list[Block], CsvLine]:
    clock = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
    dut = CsvLine("dut", EmulatedLink("emulated://dut", Sender(pieces), clock), clock, Settings(**settings))
    dut.start()
    return dut.read_until(10.0), dut


def test_a_line_in_pieces_is_stamped_at_its_first_byte() -> None:
    blocks, _ = heard([(0.5, b"cut,line\n"), (1.0, b"0.1,1,"), (1.2, b"-2,3\n0.2,4,5,6\n")])
    np.testing.assert_array_equal(blocks[0].values, [[1, -2, 3], [4, 5, 6]])
    np.testing.assert_array_equal(blocks[0].t_s, [1.0, 1.2])


def test_housekeeping_goes_by_its_name_with_its_unit() -> None:
    blocks, dut = heard(
        [(1, b"\n1;2;3;99;25.5;0.4\r\n")], columns=("x", "y", "z", "-", "temp_dut", "i_eps"), delimiter=";", scale=2.0
    )
    np.testing.assert_array_equal(blocks[0].values, [[2, 4, 6]])
    np.testing.assert_array_equal(blocks[1].values, [[25.5, 0.4]])
    assert [(c.name, c.unit, c.quantity) for c in dut.channels] == [
        ("temp_dut", "degC", "temperature"),
        ("i_eps", "A", "current"),
    ]


@pytest.mark.parametrize(
    "bad", [b"0,1,2\n", b"0,1,2,nan\n", b"0,1,2,3,4\n", b"t,x,y,z\n", b"\xff\xfe\n", b"0,1,2,1e999\n"]
)
def test_what_is_no_good_line_is_dropped_and_counted(bad: bytes) -> None:
    blocks, dut = heard([(1, b"\n" + bad + b"0,7,8,9\n")])
    np.testing.assert_array_equal(blocks[0].values, [[7, 8, 9]])
    assert [(e.kind, e.data["fault"], e.data["lost"]) for e in dut.events()] == [("stream", "bad frame", 1)]
    assert dut.events() == []


def test_comments_are_not_counted() -> None:
    assert heard([(1, b"\n# boot\n\n0,7,8,9\n")])[1].events() == []


def test_the_devices_own_clock_takes_out_the_lines_jitter() -> None:
    pieces = [
        (k * 0.1 + jitter, f"{5000 + 100 * k},1,2,3\n".encode()) for k, jitter in enumerate([0.05, 0.0, 0.03, 0.01])
    ]
    blocks, _ = heard([(0.01, b"\n"), *pieces], stamp="device", t_unit="ms", delay_s=0.02)
    np.testing.assert_allclose(blocks[0].t_s, [-0.02, 0.08, 0.18, 0.28])


@pytest.mark.parametrize(
    "settings",
    [
        {"columns": ("x", "y")},
        {"columns": ("x", "y", "z", "x")},
        {"columns": ("x", "y", "z"), "stamp": "device"},
        {"columns": ("x", "y", "z", "flux")},
    ],
)
def test_a_column_map_that_makes_no_sense_is_refused(settings: dict[str, object]) -> None:
    with pytest.raises(ValueError, match=r"columns|quantities"):
        Settings(**settings)


@given(st.lists(st.binary(max_size=60), max_size=6))
def test_no_bytes_crash_the_parser_and_only_finite_numbers_come_out(pieces: list[bytes]) -> None:
    blocks, _ = heard([(float(k), data) for k, data in enumerate(pieces)])
    assert all(np.isfinite(b.values).all() for b in blocks)


def test_units_become_nanotesla_and_a_decimal_comma_is_read_where_it_is_stated() -> None:
    blocks, _ = heard([(1, b"\n0,5;1,5;-2;3\n")], unit="uT", scale=2.0, decimal=",", delimiter=";")
    np.testing.assert_allclose(blocks[0].values, [[3000, -4000, 6000]])


@pytest.mark.parametrize("line", [b"0,1_0,2,3\n", b"0,0x1,2,3\n", b"0,1 1,2,3\n", b"0,1;5,2,3\n", b"0,inf,2,3\n"])
def test_what_python_would_read_but_no_instrument_means_gives_no_value(line: bytes) -> None:
    assert heard([(1, b"\n" + line)])[0] == []


def test_an_empty_cell_of_housekeeping_costs_that_cell_alone() -> None:
    columns = ("x", "y", "z", "temp_dut", "i_eps")
    blocks, _ = heard([(1, b"\n1,2,3,20,0.1\n4,5,6,,0.2\n7,8,9,nan,0.3\n")], columns=columns)
    assert len(blocks[0]) == 3
    np.testing.assert_array_equal(blocks[1].values, [[20]])
    np.testing.assert_array_equal(blocks[2].values, [[0.1], [0.2], [0.3]])


def test_a_clock_that_begins_again_is_tied_anew_and_reported() -> None:
    lines = [(1.0, b"\n"), (2.0, b"100,1,2,3\n"), (3.1, b"101,1,2,3\n"), (8.0, b"0.5,1,2,3\n"), (9.2, b"1.5,1,2,3\n")]
    blocks, dut = heard(lines, stamp="device")
    np.testing.assert_allclose(blocks[0].t_s, [2.0, 3.0, 8.0, 9.0])
    assert [e.data["fault"] for e in dut.events()] == ["restart"]


def test_iso_time() -> None:
    lines = [(1.0, b"\n"), (2.0, b"2026-11-21T12:00:00Z,1,2,3\n"), (3.3, b"2026-11-21T12:00:01Z,1,2,3\n")]
    np.testing.assert_allclose(heard(lines, stamp="device", t_unit="iso")[0][0].t_s, [2.0, 3.0])


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no ptys")
def test_a_dut_that_is_unplugged_is_a_link_lost() -> None:
    master, slave = pty.openpty()
    clock = RealClock()
    dut = CsvLine("dut", open_link(f"serial://{os.ttyname(slave)}", clock), clock, Settings())
    dut.start()
    os.write(master, b"cut\n0,1,2,3\n")
    while not (blocks := dut.read_until(clock.now() + 0.2)):
        assert clock.now() < 60.0
    assert len(blocks[0]) == 1
    os.close(master)
    os.close(slave)
    with pytest.raises(InstrumentError) as caught:
        dut.read_until(clock.now() + 0.2)
    assert caught.value.fault == "link lost"
    dut.close()
