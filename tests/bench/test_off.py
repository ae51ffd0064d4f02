"""`labcal bench off` where no guardian lives, and where the file can no longer be read."""

from __future__ import annotations

import socket
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from served_lab import EXAMPLE, LONG_S, Served, at_zero, example, guardians, log, until
from test_guardian_ear import Ear

from labcal.bench import open_bench
from labcal.bench.config import read_config
from labcal.bench.guardian import wire
from labcal.bench.links import ports
from labcal.bench.shutdown import coils_off
from labcal.cli import execute
from labcal.errors import InstrumentError

POSIX = pytest.mark.skipif(sys.platform == "win32", reason="needs Unix sockets and ptys, which Windows lacks")


def left_on(lab: Served) -> None:
    """Currents that some other program has set and left, without any guardian."""
    config = read_config(lab.file)
    for axis, amperes in (("x", "0.4"), ("y", "0.2"), ("z", "0.1")):
        place = urlsplit(config.instruments[f"supply_{axis}"].link)
        with socket.create_connection((place.hostname, place.port), LONG_S) as supply:
            supply.sendall(f"V1 20\nI1 {amperes}\nOP1 1\nI1?\n".encode())
            assert supply.recv(64).startswith(b"I1 ")
        until(lambda axis=axis: not at_zero(lab, axis))


@POSIX
@pytest.mark.parametrize("bench_text", [example().replace("interface_lock = true, ", "")], ids=["unlocked"])
def test_without_a_guardian_it_opens_the_ports_itself_and_gives_them_back(lab: Served) -> None:
    left_on(lab)
    ended = coils_off(lab.file)
    assert [(end.axis, end.words) for end in ended] == [(axis, "zero, open") for axis in "xyz"]
    assert at_zero(lab)
    assert not guardians()
    links = read_config(lab.file).guarded_links
    assert ports.hold(links)
    ports.let_go()


OFF_AND_A_SIGNAL = """
import os, signal, sys
from labcal.bench import shutdown
from labcal.cli import execute
sought = shutdown.guarding
def interrupted(path, asked):
    os.kill(os.getpid(), getattr(signal, sys.argv[1]))
    return sought(path, asked)
shutdown.guarding = interrupted
sys.exit(execute(["bench", "off", sys.argv[2]]))
"""


@POSIX
@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM", "SIGHUP", "SIGTSTP"])
def test_neither_ctrl_c_nor_a_closed_terminal_breaks_off_the_way_to_zero(name: str) -> None:
    words = [sys.executable, "-c", OFF_AND_A_SIGNAL, name, str(EXAMPLE)]
    told = subprocess.run(words, capture_output=True, text=True, check=False, timeout=LONG_S)
    assert told.returncode == 0, told
    assert told.stdout.count("zero, open") == 3


WITH_FEW_THREADS = """
import sys, threading
from labcal.start import main
left, start = [int(sys.argv.pop(1))], threading.Thread.start
def begin(thread):
    if not left[0]:
        raise RuntimeError("can't start new thread")
    left[0] -= 1
    start(thread)
threading.Thread.start = begin
main()
"""


@POSIX
@pytest.mark.parametrize("bench_text", [example().replace("interface_lock = true, ", "")], ids=["unlocked"])
@pytest.mark.parametrize("threads", ["1", *(pytest.param(n, marks=pytest.mark.slow) for n in "023")])
def test_a_user_who_may_begin_no_further_process_brings_the_coils_down(lab: Served, threads: str) -> None:
    left_on(lab)
    words = [sys.executable, "-c", WITH_FEW_THREADS, threads, "bench", "off", str(lab.file)]
    told = subprocess.run(words, capture_output=True, text=True, check=False, timeout=LONG_S)
    assert at_zero(lab), told
    assert (told.returncode, told.stdout.count("zero, open")) == (0, 3), told
    assert log().count("read back: coil x") == 1


def test_what_is_wrong_with_one_supply_keeps_no_other_from_zero(tmp_path: Path) -> None:
    of_y = 'driver = "tti-pl"\nlink = "emulated://"\nrole = "coil-y"'
    file = tmp_path / "bench.toml"
    file.write_text(EXAMPLE.read_text().replace(of_y, of_y.replace("tti-pl", "tti-pll")))
    ended = {end.axis: end for end in coils_off(file)}
    assert [ended[axis].words for axis in "xz"] == ["zero, open"] * 2
    assert "there is no driver 'tti-pll'" in ended["y"].words
    assert "switch this supply off by hand" in ended["y"].words


@pytest.fixture
def ear() -> Iterator[Ear]:
    """A guardian without supplies."""
    ear = Ear()
    yield ear
    wire.unlisten(ear.listener, ear.card)


@POSIX
@pytest.mark.parametrize("says", [b"name = ", b"\xff\xfe", None], ids=["broken", "no text", "gone"])
def test_a_file_that_cannot_be_read_keeps_nobody_from_its_guardian(
    ear: Ear, tmp_path: Path, says: bytes | None
) -> None:
    file = tmp_path / "bench.toml"
    if says is not None:
        file.write_bytes(says)
    assert ports.hold([f"tcp://{'-'.join(tmp_path.parts[-3:])}:1"])  # nobody else tests with it
    ports.announce(ear.card | {"bench": str(file.resolve())})
    try:
        assert coils_off(file) == []
    finally:
        ports.let_go()
    ((order, why, by_session),) = ear.coils.heard
    assert (order, by_session) == ("zero", False)
    assert why.startswith("labcal bench off")


def test_without_both_it_says_what_stands_there_and_that_nothing_was_touched(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "bench.toml"
    file.write_text("name = 'a'\n[cage\n")
    assert execute(["bench", "off", str(file)]) == 2
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    assert "line 2, column 6: is not TOML" in said
    assert "no coil was touched" in said
    assert "switch the supplies off by hand" in said


def doubled(text: str, *, of: str = "y", to: str = "x") -> str:
    """A bench file in which one supply's link was copied to another."""
    of_lines = text.index(f'["instruments"."supply_{of}"]'), text.index(f'["instruments"."supply_{to}"]')
    links = [text[at:].split('"link" = "')[1].split('"')[0] for at in of_lines]
    return text.replace(links[0], links[1])


@POSIX
def test_two_coils_at_one_output_are_one_that_is_brought_to_zero_and_one_that_is_not_reached(
    lab: Served, capsys: pytest.CaptureFixture[str]
) -> None:
    left_on(lab)
    lab.file.write_text(doubled(lab.file.read_text()))
    assert execute(["bench", "off", str(lab.file)]) == 3
    said = dict(line.split(": ", 1) for line in capsys.readouterr().out.splitlines() if line.startswith("coil "))
    assert said["coil x"].endswith("zero, open")
    assert said["coil z"].endswith("zero, open")
    assert said["coil y"].startswith("unknown  not reached: ")
    assert "supply_x has the same link, address and output" in said["coil y"]
    assert "zero" not in said["coil y"]
    assert at_zero(lab, "xz")
    assert not at_zero(lab, "y")


def test_check_refuses_two_coils_at_one_output_as_a_run_does(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "bench.toml"
    text = EXAMPLE.read_text()
    for axis in "xy":
        of = f'link = "emulated://"\nrole = "coil-{axis}"'
        assert of in text
        text = text.replace(of, of.replace("emulated://", "emulated://one"))
    file.write_text(text)
    assert execute(["bench", "check", str(file)]) == 2
    assert "supply_x has the same link, address and output" in capsys.readouterr().err


@POSIX
def test_a_port_that_the_file_spells_in_two_ways_is_refused(lab: Served, capsys: pytest.CaptureFixture[str]) -> None:
    text = doubled(lab.file.read_text())
    head, y = text.split('["instruments"."supply_y"]')
    lab.file.write_text(head + '["instruments"."supply_y"]' + y.replace("127.0.0.1", "LocalHost.", 1))
    assert execute(["bench", "check", str(lab.file)]) == 2
    assert "supply_x has the same link, address and output" in capsys.readouterr().err
    settings = '["instruments"."supply_y"."settings"]\n'
    assert settings in y
    y = y.replace("127.0.0.1", "LocalHost.", 1).replace(settings, settings + '"output" = 2\n')
    lab.file.write_text(head + '["instruments"."supply_y"]' + y)
    assert execute(["bench", "check", str(lab.file)]) == 2
    assert "supply_x has this port too, and spells it otherwise" in capsys.readouterr().err


@POSIX
@pytest.mark.parametrize("bench_text", [example().replace("interface_lock = true, ", "")], ids=["unlocked"])
def test_check_names_one_supply_that_answers_at_two_links(
    lab: Served, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "200")
    lab.emulator("supply_y").words.who = lab.emulator("supply_x").words.who
    assert execute(["bench", "check", str(lab.file)]) == 3
    said = " ".join(capsys.readouterr().out.split())
    assert said.count("the same instrument") == 2
    with pytest.raises(InstrumentError, match="the same instrument answers on both links"), open_bench(lab.file):
        pass
