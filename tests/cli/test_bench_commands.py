"""`labcal bench`: what a technician sees, and the exit codes that scripts see."""

from __future__ import annotations

import os
import socket
import threading
from contextlib import closing, suppress
from pathlib import Path

import pytest

from labcal.bench.links.ports import claim
from labcal.cli import execute

EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"


def test_check_identifies_every_instrument_by_name(capsys: pytest.CaptureFixture[str]) -> None:
    assert execute(["bench", "check", str(EXAMPLE)]) == 0
    said = capsys.readouterr().out
    for name in ("supply_x", "supply_y", "supply_z", "reversers", "stage", "reference", "dut"):
        assert name in said


def test_one_that_is_not_there_hides_no_other_and_ends_with_3(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, text = tmp_path / "bench.toml", EXAMPLE.read_text()
    path.write_text(text[: text.rindex("[twin]")].replace('link = "emulated://"', 'link = "serial:///dev/none"', 1))
    assert execute(["bench", "check", str(path)]) == 3
    said = capsys.readouterr().out
    assert "lost" in said
    assert "HMR2300" in said


def test_off_says_how_every_coil_ended(capsys: pytest.CaptureFixture[str]) -> None:
    assert execute(["bench", "off", str(EXAMPLE)]) == 0
    assert capsys.readouterr().out.count("zero, open") == 3


def test_a_wrong_file_is_one_sentence_and_2(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "bench.toml"
    path.write_text("nme = 1\n")
    assert execute(["bench", "check", str(path)]) == 2
    assert capsys.readouterr().err.count("\n") == 1
    assert execute(["bench", "off", str(tmp_path / "absent.toml")]) == 2


class Stranger:
    """A TCP port where something answers every line with `reply`."""

    def __init__(self, reply: bytes) -> None:
        self._server, self._reply = socket.create_server(("127.0.0.1", 0)), reply
        self.link = f"tcp://127.0.0.1:{self._server.getsockname()[1]}"
        self._thread = threading.Thread(target=self._answer, daemon=True)
        self._thread.start()

    def _answer(self) -> None:
        with suppress(OSError), self._server.accept()[0] as host:
            while host.recv(4096):
                host.sendall(self._reply)

    def close(self) -> None:
        self._thread.join(60)
        self._server.close()


def changed(folder: Path, old: str, new: str) -> Path:
    """The example bench on a real clock, with its first `old` changed."""
    text = EXAMPLE.read_text()
    path = folder / "bench.toml"
    path.write_text(text[: text.rindex("[twin]")].replace(old, new, 1))
    return path


@pytest.mark.parametrize(
    ("reply", "says"),
    [
        (b"RIGOL TECHNOLOGIES,DP832,DP8A000001,00.01.14\n", "not an Aim-TTi supply"),
        (b"\xf8\x00\xe6\x98\x1e\n", "not an Aim-TTi supply"),  # what a wrong baud rate makes of it
    ],
)
def test_another_instrument_and_a_wrong_baud_rate_are_told_with_3(
    reply: bytes, says: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "400")
    with closing(Stranger(reply)) as stranger:
        patient = f'link = "{stranger.link}"\nsettings = {{ timeout_s = 60.0 }}'
        path = changed(tmp_path, 'link = "emulated://"', patient)
        assert execute(["bench", "check", str(path)]) == 3
    assert says in capsys.readouterr().out


def test_a_wrong_port_and_one_that_is_in_use_are_told_with_3(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "4000")
    with socket.create_server(("127.0.0.1", 0)) as server:
        link = f"tcp://127.0.0.1:{server.getsockname()[1]}"
        path = changed(tmp_path, 'link = "emulated://"', f'link = "{link}"')
        give_back = claim(link)
        assert execute(["bench", "check", str(path)]) == 3
        assert f"(process {os.getpid()}) holds this port" in capsys.readouterr().out
        give_back()
    assert execute(["bench", "check", str(path)]) == 3
    assert "the link was lost" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ('driver = "tti-pl"', 'driver = "tti"', "there is no driver 'tti'"),
        ('link = "emulated://"', 'link = "gpib://3"', "gpib:// is none of"),
        ('link = "emulated://"', 'link = "serial:///dev/ttyUSB0?baud=fast"', "baud"),
        ('link = "emulated://"', 'link = "tcp://192.168.0.9"', "states no port"),
        ('link = "emulated://"', 'link = "tcp://192.168.0.9:1?gap_ms=long"', "gap_ms=long"),
        ('link = "emulated://"', 'link = "serial:///dev/ttyUSB0?parity=X"', "parity"),
    ],
)
def test_what_is_wrong_in_the_file_is_one_sentence_with_its_line_and_2(
    old: str, new: str, says: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = changed(tmp_path, old, new)
    assert execute(["bench", "check", str(path)]) == 2
    said = capsys.readouterr().err
    assert says in said
    assert "line" in said
    assert said.count("\n") == 1
