"""Supplies of an earlier session at other links are no coils of this bench; a person says that they are gone."""

from __future__ import annotations

import os
import socket
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from served_lab import Served, example

from labcal import audit, session
from labcal.bench.coils.at_zero import of_this_bench
from labcal.bench.coils.doubt import left_so
from labcal.bench.config import read_config
from labcal.bench.essentials import as_table
from labcal.bench.guardian.client import driven_before
from labcal.bench.links import ports
from labcal.bench.shutdown import coils_off
from labcal.errors import InputError
from labcal.files.home import home

pytestmark = [
    pytest.mark.skipif(sys.platform == "win32", reason="needs Unix sockets and ptys, which Windows lacks"),
    pytest.mark.parametrize("bench_text", [example().replace("interface_lock = true, ", "")], ids=["unlocked"]),
]


def left_behind(file: Path, links: list[str], bench: Path | None = None) -> None:
    """As a guardian of `bench` leaves it that is killed with the coils on: its supplies were at `links`."""
    table = as_table(read_config(file))
    table["instruments"] = {
        f"supply_{axis}": table["instruments"][f"supply_{axis}"] | {"link": link}
        for axis, link in zip("xyz", links, strict=True)
    }
    assert ports.hold(links)
    ports.announce({"pid": os.getpid(), "bench": str(bench or file), ports.DRIVEN: table})
    ports.let_go(in_doubt=True)


@pytest.fixture
def earlier() -> Iterator[list[str]]:
    """Three ports at which nobody listens any more."""
    taken = [socket.create_server(("127.0.0.1", 0)) for _ in "xyz"]
    links = [f"tcp://127.0.0.1:{one.getsockname()[1]}" for one in taken]
    for one in taken:
        one.close()
    yield links
    ports.amend_left_behind(lambda card: {})


def test_they_are_no_coils_of_this_bench_and_hold_no_zero_of_it(lab: Served, earlier: list[str]) -> None:
    left_behind(lab.file, earlier)
    ended = coils_off(lab.file)
    assert [(end.axis, end.words) for end in of_this_bench(ended)] == [(axis, "zero, open") for axis in "xyz"]
    others = [end for end in ended if end.earlier_at]
    assert [f"tcp://{end.earlier_at}" for end in others] == earlier
    assert [end.current_A for end in others] == [None] * 3
    assert all(end.link_is_gone for end in others)
    assert left_so(lab.file, ended).startswith("zero by the supply's word only")


def test_who_says_that_they_are_gone_is_named_in_the_audit_log(lab: Served, earlier: list[str]) -> None:
    another = lab.file.with_name("another.toml")
    elsewhere = [link.replace("127.0.0.1", "127.0.0.2") for link in earlier]
    left_behind(lab.file, earlier)
    left_behind(lab.file, elsewhere, another)
    gone = [link.removeprefix("tcp://") for link in earlier]
    with pytest.raises(InputError, match="nobody was named"):
        session.earlier_supplies_are_gone(lab.file, gone, "")
    session.earlier_supplies_are_gone(lab.file, gone[:2], "A. Lee")
    (left,) = driven_before(lab.file)
    assert left.axes == ["z"]
    session.earlier_supplies_are_gone(lab.file, gone[2:], "A. Lee")
    assert driven_before(lab.file) == []
    assert len(driven_before(another)) == 1  # of another bench file nobody said anything
    assert [end.axis for end in coils_off(lab.file)] == ["x", "y", "z"]
    *_, entry = audit.read(home()).entries
    assert (entry.deed, entry.who, entry.about) == ("gone", "A. Lee", {"bench": lab.file.name, "supplies": gone[2]})
