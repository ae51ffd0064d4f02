"""Where no answer comes, or bytes that make no sense: how the line is set, and how it should be."""

from __future__ import annotations

import os
import re
import socket
import sys
from contextlib import suppress
from importlib.metadata import entry_points
from pathlib import Path

import pytest

from labcal.bench.clock import RealClock
from labcal.bench.config import InstrumentConfig
from labcal.bench.line_advice import USUAL, advice, advised
from labcal.bench.links import Link, open_link
from labcal.bench.links.heard_before import LINE, PLUG
from labcal.cli import execute
from labcal.errors import InstrumentError

ROOT = Path(__file__).parents[2]
DEV = "serial:///dev/ttyUSB0"


@pytest.mark.parametrize(
    ("driver", "link", "says"),
    [
        ("zaber", f"{DEV}?baud=9600", "set to 9600 baud, 8N1; zaber has 115200 baud, 8N1 as a rule."),
        ("zaber", f"{DEV}?baud=115200", "set to 115200 baud, 8N1, as zaber has it as a rule; its panel may say"),
        ("ea-ps2000b", f"{DEV}?baud=115200", "8N1; ea-ps2000b has 115200 baud, 8O1 as a rule."),
        ("oriental-az", "modbus-rtu:///dev/ttyUSB0?baud=19200", "8N1; oriental-az has 19200 baud, 8E1 as a rule."),
        ("newport-smc100", f"{DEV}?baud=57600", "; newport-smc100 has 57600 baud, 8N1 (xonxoff=1) as a rule."),
        ("tti-pl", DEV, "This line is set to 9600 baud, 8N1: the instrument must be too."),
    ],
)
def test_a_serial_line_is_compared_with_what_the_instrument_has(driver: str, link: str, says: str) -> None:
    assert says in advice(driver, link)


@pytest.mark.parametrize("link", ["tcp://h:1", "serial://socket://h:1", "visa://GPIB0::5", "emulated://", "zebra://"])
def test_of_another_link_nothing_is_said(link: str) -> None:
    assert advice("zaber", link) == ""


@pytest.mark.parametrize(
    ("came", "says"),
    [
        ("x: 'ø\\x00æ\\x98\\x1e' answered, not a Kepco.", "another baud rate or parity"),
        (f"{DEV}: no reply in 0.5 s, only b'42\\r' came.", "another line end (terminator)"),
        (f"{DEV}: no reply in 0.5 s, only b'\\xf8\\x00' came.", "another baud rate or parity"),
    ],
)
def test_what_came_is_told_apart(came: str, says: str) -> None:
    assert says in advice("kepco-bop", DEV, came)


def test_only_where_bytes_look_wrong() -> None:
    entry = InstrumentConfig(driver="zaber", link=DEV, role="platform")
    trip = InstrumentError("it tripped.", fault="tripped")
    assert advised(trip, entry) is trip
    silent = advised(InstrumentError("no reply.", fault="silent", remedy="Is it on?"), entry)
    assert str(silent).startswith("no reply. Is it on? This line is set to 9600 baud")
    assert silent.fault == "silent"


def test_the_usual_settings_are_those_of_the_page_and_of_the_emulators() -> None:
    page = (ROOT / "docs" / "bench.md").read_text(encoding="utf-8")
    emulators = {entry.name: entry for entry in entry_points(group="labcal.emulators")}
    for driver, usual in USUAL.items():
        (row,) = re.findall(rf"^\| `{driver}` .*|^\| `[^|]*`{driver}`.*", page, re.MULTILINE) or [""]
        if stated := re.search(r"(?:serial|modbus-rtu)://[^`]*\?([^`]*)", row):
            assert stated[1] == usual, driver
        baud = getattr(emulators[driver].load(), "baud", None)
        assert baud is None or "baud" not in usual or f"baud={baud}" in usual, driver


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no ptys")
def test_bench_check_says_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "500")
    nobody, line = os.openpty()
    text = (ROOT / "examples" / "simulated.toml").read_text(encoding="utf-8")
    stated = f'driver = "zaber"\nlink = "serial://{os.ttyname(line)}?baud=9600"'
    path = tmp_path / "bench.toml"
    path.write_text(text[: text.rindex("[twin]")].replace('driver = "zaber"\nlink = "emulated://"', stated))
    assert stated in path.read_text()
    assert execute(["bench", "check", str(path)]) == 3
    said = capsys.readouterr().out
    assert "This line is set to 9600 baud, 8N1; zaber has 115200 baud, 8N1 as a rule." in said
    for end in (nobody, line):
        with suppress(OSError):
            os.close(end)


def test_who_has_answered_there_before_is_looked_for_at_its_plug_and_not_in_the_file() -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        url = f"tcp://127.0.0.1:{server.getsockname()[1]}"
        link = open_link(url, RealClock())
        other, _ = server.accept()
        with other:
            assert silence(link).remedy == LINE
            other.sendall(b"here\n")
            assert link.ask(b"?\n", end=b"\n", timeout_s=20.0) == b"here\n"
            lost = silence(link)
        link.close()
    assert lost.remedy == PLUG
    entry = InstrumentConfig(driver="zaber", link=f"{DEV}?baud=9600", role="platform")
    assert advised(lost, entry) is lost, "how the line is set was right before"


def silence(link: Link) -> InstrumentError:
    with pytest.raises(InstrumentError) as caught:
        link.ask(b"?\n", end=b"\n", timeout_s=0.05)
    assert caught.value.fault == "silent"
    return caught.value
