"""`labcal bench off` where others hold some of the ports: what they have not told of is never said to be at zero."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from served_lab import LABCAL, LONG_S, Served, Sessions, at_zero, example, until
from test_guardian_ear import Ear
from test_off import left_on

from labcal.bench.coils.at_zero import AtZero
from labcal.bench.config import read_config
from labcal.bench.guardian import wire
from labcal.bench.guardian.supplies import supplies_of
from labcal.bench.links import ports
from labcal.errors import InstrumentError

pytestmark = [
    pytest.mark.skipif(sys.platform != "linux", reason="needs Unix sockets and ptys"),
    pytest.mark.parametrize("bench_text", [example().replace("interface_lock = true, ", "")], ids=["unlocked"]),
]


def off(bench: Path) -> tuple[int, dict[str, str]]:
    """The exit code, and what is said of each axis."""
    said = subprocess.run([*LABCAL, "bench", "off", str(bench)], capture_output=True, text=True, timeout=LONG_S)
    of_axes = [line.removeprefix("coil ").split(": ", 1) for line in said.stdout.splitlines() if line[:5] == "coil "]
    assert [axis for axis, _ in of_axes] == ["x", "y", "z"], said
    return said.returncode, {axis: words.strip() for axis, words in of_axes}


@pytest.fixture
def other(monkeypatch: pytest.MonkeyPatch) -> Iterator[Ear]:
    """The guardian of another bench file, without supplies; its axis z is at zero."""
    ear = Ear()
    monkeypatch.setattr(ear.coils, "zero", lambda *_, **__: [AtZero("z", 0.0, True)])
    yield ear
    ports.let_go()
    wire.unlisten(ear.listener, ear.card)


def has_coil_x(other: Ear, lab: Served, **card: object) -> None:
    """From now on that guardian holds the port of this lab's supply x."""
    assert ports.hold([read_config(lab.file).instruments["supply_x"].link])
    ports.announce(other.card | {"bench": "/another/bench.toml"} | card)


def test_what_the_guardian_of_another_file_does_not_hold_is_brought_to_zero_from_here(lab: Served, other: Ear) -> None:
    left_on(lab)
    has_coil_x(other, lab, supplies={"z": supplies_of(read_config(lab.file))["x"]})
    code, said = off(lab.file)
    assert at_zero(lab, "yz")
    assert (code, {words.endswith("zero, open") for words in said.values()}) == (0, {True})


def test_of_a_port_whose_guardian_knows_another_supply_there_nothing_is_claimed(lab: Served, other: Ear) -> None:
    left_on(lab)
    has_coil_x(other, lab, supplies={"z": "another"})
    code, said = off(lab.file)
    assert at_zero(lab, "yz")
    assert (code, said["x"].split(" ")[0]) == (3, "unknown")
    assert "a guardian (process " in said["x"]
    assert "zero, open" not in said["x"]


def test_a_guardian_that_fails_keeps_nobody_from_the_other_coils(
    lab: Served, other: Ear, monkeypatch: pytest.MonkeyPatch
) -> None:
    def hangs(*_: object, **__: object) -> list[AtZero]:
        raise InstrumentError("it hangs.", fault="guardian lost")

    monkeypatch.setattr(other.coils, "zero", hangs)
    left_on(lab)
    has_coil_x(other, lab, supplies={"z": supplies_of(read_config(lab.file))["x"]})
    code, said = off(lab.file)
    assert at_zero(lab, "yz")
    assert (code, said["x"]) == (3, "unknown  it hangs.")


def test_a_program_that_holds_one_port_keeps_no_other_coil_on(lab: Served) -> None:
    left_on(lab)
    let_go = ports.claim(read_config(lab.file).instruments["supply_x"].link)
    try:
        code, said = off(lab.file)
    finally:
        let_go()
    assert at_zero(lab, "yz")
    assert (code, said["x"].split(" ")[0]) == (3, "unknown")
    assert "holds this port" in said["x"]
    assert said["x"].endswith("End it, then try again.")


def test_a_session_s_guardian_tells_which_supplies_are_its_own(lab: Served, session: Sessions, tmp_path: Path) -> None:
    session("wait")
    shares_x = tmp_path / "shares-x.toml"
    text, links = lab.file.read_text(), read_config(lab.file).instruments
    text = text.replace(links["supply_y"].link, "tcp://127.0.0.1:1").replace(
        links["supply_z"].link, "tcp://127.0.0.1:2"
    )
    shares_x.write_text(text)
    code, said = off(shares_x)
    until(lambda: at_zero(lab))
    assert (code, said["x"].endswith("zero, open")) == (3, True)
    assert [said[axis].split(" ")[0] for axis in "yz"] == ["unknown"] * 2
