"""The bench file is overwritten, cut off or deleted while a session runs: zero reaches the coils that are energised."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import pytest
from served_lab import (
    EXAMPLE,
    LABCAL,
    LONG_S,
    Served,
    Sessions,
    at_zero,
    children_of,
    example,
    guardians,
    kill_all,
    log,
    of_bench,
    until,
)

from labcal.bench.guardian.standbys import HOW_MANY

pytestmark = [
    pytest.mark.skipif(sys.platform != "linux", reason="needs SIGKILL and ptys"),
    pytest.mark.parametrize("bench_text", [example()], ids=["tti"]),
]


def another_lab(file: Path) -> None:
    """As a copy of the wrong file leaves it: the same names, at ports where nobody listens."""
    before, _, _ = EXAMPLE.read_text().partition("\n[twin]")
    for k in range(before.count("emulated://")):
        before = before.replace("emulated://", f"tcp://127.0.0.1:{k + 1}", 1)
    file.write_text(before)


def cut_off(file: Path) -> None:
    """As a full disk leaves it."""
    file.write_bytes(file.read_bytes()[:700])


def cut_between_tables(file: Path) -> None:
    """Likewise, and by chance it is TOML still."""
    head, named, _ = file.read_text().partition('["instruments"')
    assert named
    file.write_text(head)


def coil_misspelt(file: Path) -> None:
    """A coil's role is misspelt, and its supply stands at another's link."""
    text = file.read_text()
    links = re.findall(r'"link" = "(tcp[^"]*)"', text)
    file.write_text(text.replace(links[1], links[0]).replace('"coil-x"', '"coil-q"'))


def garbage(file: Path) -> None:
    file.write_bytes(b"\xff\xfe\0\0")


def deleted(file: Path) -> None:
    file.unlink()


def untouched(file: Path) -> None:
    """As it was."""


SPOILT = [another_lab, cut_off, cut_between_tables, garbage, deleted, untouched]


def ways(*always: Callable[[Path], None], without: Sequence[Callable[[Path], None]] = ()) -> list[Any]:
    """Every way to spoil the file; each is tried always by one of the tests here at least."""
    left = [spoil for spoil in SPOILT if spoil not in without]
    return [spoil if spoil in always else pytest.param(spoil, marks=pytest.mark.slow) for spoil in left]


def said_off(file: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run([*LABCAL, "bench", "off", str(file)], capture_output=True, text=True, timeout=LONG_S)


@pytest.mark.parametrize("spoil", ways(another_lab, garbage, without=[untouched]), ids=lambda spoil: spoil.__name__)
def test_off_reaches_what_the_guardian_drives(lab: Served, session: Sessions, spoil) -> None:
    session("idle")
    spoil(lab.file)
    said = said_off(lab.file)
    assert at_zero(lab), said
    assert said.stdout.count("zero, open") == 3, said
    assert said.returncode == (3 if spoil is another_lab else 0), said


@pytest.mark.parametrize("spoil", ways(cut_off, without=[untouched]), ids=lambda spoil: spoil.__name__)
def test_who_takes_the_guardian_s_place_knows_the_coils(lab: Served, session: Sessions, spoil) -> None:
    session("idle")
    (first,) = guardians()
    until(lambda: len(children_of(first)) == HOW_MANY)
    spoil(lab.file)
    os.kill(first, signal.SIGKILL)
    until(lambda: at_zero(lab))


@pytest.mark.parametrize("spoil", ways(deleted, cut_between_tables), ids=lambda spoil: spoil.__name__)
def test_off_reaches_what_was_driven_where_nobody_is_left(lab: Served, session: Sessions, spoil) -> None:
    child = session("idle")
    kill_all(child)
    until(lambda: not of_bench(lab.file))
    assert not at_zero(lab)
    spoil(lab.file)
    said = said_off(lab.file)
    assert at_zero(lab), said
    assert said.stdout.count("zero, open") == 3, said
    assert log().count("to zero: labcal bench off") == (2 if spoil is another_lab else 1)
    assert ("Reported above is what was driven under this name" in said.stderr) == (
        spoil in (garbage, cut_off, cut_between_tables, deleted)
    )
    if spoil is another_lab:  # which was asked for as well, and does not answer
        assert said.stdout.count("coil x: unknown") == 1
        assert said.stdout.count("coil x at 127.0.0.1:") == 1
        assert said.returncode == 3
    else:
        assert said.returncode == 0, said


def test_a_coil_that_is_misspelt_keeps_zero_from_no_supply(lab: Served, session: Sessions) -> None:
    child = session("idle")
    kill_all(child)
    until(lambda: not of_bench(lab.file))
    coil_misspelt(lab.file)
    said = said_off(lab.file)
    assert at_zero(lab), said
    assert (said.returncode, "fault of labcal's own" in said.stderr) == (3, False), said


def test_two_of_another_role_keep_nothing_from_zero(lab: Served) -> None:
    lab.file.write_text(lab.file.read_text().replace('"role" = "reference"', '"role" = "dut"'))
    said = said_off(lab.file)
    assert said.returncode == 0, said
    assert said.stdout.count("zero, open") == 3, said


def last_line_cut(file: Path) -> None:
    """As an editor leaves it that was closed too early: no TOML, and nobody has driven anything under this name."""
    file.write_text(file.read_text().rstrip() + '\n"note" = "not to be\n')


def line_within_broken(file: Path) -> None:
    """The link of one coil has lost its closing quote."""
    file.write_text(re.sub(r'("link" = "tcp[^"]*)"', r"\1", file.read_text(), count=1))


def coil_named_twice(file: Path) -> None:
    """Copied and pasted, the link changed, the axis not: two supplies of x, none of y."""
    file.write_text(file.read_text().replace('"coil-y"', '"coil-x"'))


def table_twice(file: Path) -> None:
    """As above, and the name of the instrument as well."""
    text = file.read_text()
    first, second = re.findall(r'\["instruments"\.("[^"]*")\]\n(?:"[^\n]*\n)*?"role" = "coil-[xy]"', text)
    file.write_text(text.replace(f'["instruments".{second}', f'["instruments".{first}').replace('"coil-y"', '"coil-x"'))


@pytest.mark.parametrize(
    ("spoil", "reached", "code"),
    [(last_line_cut, 3, 0), (line_within_broken, 2, 3), (coil_named_twice, 3, 3), (table_twice, 3, 3)],
    ids=lambda value: getattr(value, "__name__", None),
)
def test_what_can_be_read_of_a_broken_file_comes_to_zero(lab: Served, spoil, reached: int, code: int) -> None:
    spoil(lab.file)
    said = said_off(lab.file)
    assert said.stdout.count("zero, open") == reached, said
    assert ("unknown" in said.stdout, said.returncode) == (code == 3, code), said
    assert f"! {lab.file}" in said.stderr, said
    assert "what the file still says of its supplies" in said.stderr, said
