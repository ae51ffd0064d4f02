"""file:// follows what another program puts at the end of a file, over midnight too."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from labcal.bench.clock import RealClock
from labcal.bench.links import Link, open_link
from labcal.errors import InstrumentError

PATIENCE_S, QUIET_S = 30.0, 0.2
Come = Callable[[bytes], bytes]


def put(path: Path, data: bytes) -> None:
    with path.open("ab") as file:
        file.write(data)


@pytest.fixture
def clock() -> RealClock:
    return RealClock()


@pytest.fixture
def link(tmp_path: Path, clock: RealClock) -> Iterator[Link]:
    put(tmp_path / "abc20260301.sec", b"of before\n")
    line = open_link(f"file://{tmp_path}/abc*.sec", clock)
    yield line
    line.close()


@pytest.fixture
def come(link: Link, clock: RealClock) -> Come:
    """What comes until it has all of `expected`, and a little longer."""

    def until(expected: bytes) -> bytes:
        came, deadline = b"", clock.now() + PATIENCE_S
        while len(came) < len(expected) and clock.now() < deadline:
            came += b"".join(data for _, data in link.receive(clock.now() + 0.05))
        return came + b"".join(data for _, data in link.receive(clock.now() + QUIET_S))

    return until


def test_what_is_put_at_the_end_comes_and_what_stood_there_does_not(tmp_path: Path, come: Come) -> None:
    for line in (b"first\n", b"second\n" * 20_000):
        put(tmp_path / "abc20260301.sec", line)
        assert come(line) == line


def test_the_next_day_s_file_is_read_from_its_beginning_once_the_old_one_is(tmp_path: Path, come: Come) -> None:
    put(tmp_path / "abc20260301.sec", b"last of the day\n")
    put(tmp_path / "abc20260302.sec", b"head\nfirst of the next\n")
    expected = b"last of the day\nhead\nfirst of the next\n"
    assert come(expected) == expected


def test_a_file_that_is_written_whole_again_goes_on_and_one_begun_anew_begins(tmp_path: Path, come: Come) -> None:
    path, other = tmp_path / "abc20260301.sec", tmp_path / "new"
    other.write_bytes(b"of before\nadded\n")
    other.rename(path)
    assert come(b"added\n") == b"added\n"
    other.write_bytes(b"anew\n")
    other.rename(path)
    assert come(b"anew\n") == b"anew\n"


def test_nothing_can_be_written_to_it(tmp_path: Path, link: Link) -> None:
    with pytest.raises(InstrumentError, match="never written to"):
        link.send(b"x")
    assert (tmp_path / "abc20260301.sec").read_bytes() == b"of before\n"


def test_a_file_that_is_not_there_or_goes_is_a_lost_link(tmp_path: Path, link: Link, clock: RealClock) -> None:
    with pytest.raises(InstrumentError, match="link was lost") as caught:
        open_link(f"file://{tmp_path}/none.sec", clock)
    assert caught.value.fault == "link lost"
    (tmp_path / "abc20260301.sec").unlink()
    with pytest.raises(InstrumentError, match="link was lost"):
        link.receive(clock.now() + 1.0)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such files")
def test_what_is_no_plain_file_is_neither_waited_for_nor_read(tmp_path: Path, come: Come, clock: RealClock) -> None:
    os.mkfifo(tmp_path / "abc20260302.sec")
    for name in ("/dev/zero", str(tmp_path), f"{tmp_path}/abc20260302.sec"):
        with pytest.raises(InstrumentError, match=r"does not open|link is lost"):
            open_link(f"file://{name}", clock)
    with pytest.raises(InstrumentError, match="no plain file"):  # it has come after the file that was followed
        come(b"more than ever comes")
