"""Links that cannot be, refused in a sentence before any port is opened or any guardian is started."""

from __future__ import annotations

from pathlib import Path

import pytest
from served_lab import EXAMPLE

from labcal.bench.links import urls
from labcal.bench.loading import load_bench
from labcal.errors import InputError

WRONG = {
    "gpib://7": "gpib:// is none of serial://",
    "tcp://192.168.0.5": "states no port",
    "tcp://192.168.0.5:99999": "its port is no number from 1 to 65535",
    "tcp://192.168.0.5:x": "its port is no number from 1 to 65535",
    "tcp://192.168.0.5:9?buad=1": "buad is none of baud, ",
    "serial:///dev/ttyUSB0?baud=fast": "baud=fast is no baud rate",
    "serial:///dev/ttyUSB0?baud=0": "baud=0 is no baud rate",
    "serial:///dev/ttyUSB0?baud=\u0662": "is no baud rate",
    "serial:///dev/ttyUSB0?parity=Q": "parity=Q is none of N, E, O, M, S",
    "serial:///dev/ttyUSB0?stopbits=7": "stopbits=7 is none of 1, 1.5, 2",
    "serial:///dev/ttyUSB0?bytesize=": "bytesize= is none of 5, 6, 7, 8",
    "serial:///dev/ttyUSB0?echo=yes": "echo=yes is none of 0, 1",
    "serial://spy:///dev/ttyUSB0?file=/home/a/store.sqlite": "spy:// is none of socket://",
    "modbus-rtu://SPY://loop://?file=x": "SPY:// is none of socket://",
    "serial://alt://COM3?class=PosixPollSerial": "alt:// is none of",
    "serial://cp2110://0": "cp2110:// is none of",
    "serial://loop://?file=x": "file is none of baud, ",
    "serial://socket://host:1?loging=debug": "loging is none of baud, ",
    "modbus-rtu:///dev/ttyUSB0?timeout_ms=0": "timeout_ms=0 is no number of milliseconds",
    "modbus-rtu:///dev/ttyUSB0?gap_ms=-1": "gap_ms=-1 is no number of milliseconds",
}


@pytest.mark.parametrize("url", WRONG)
def test_a_link_that_cannot_be_is_refused(url: str) -> None:
    with pytest.raises(InputError) as caught:
        urls.split(url)
    assert WRONG[url] in str(caught.value)


def test_what_belongs_to_pyserial_is_left_to_it() -> None:
    scheme, address, options = urls.split("serial://rfc2217://host:1?logging=debug&baud=19200")
    assert (scheme, address, options) == ("serial", "rfc2217://host:1?logging=debug", {"baud": "19200"})
    assert urls.place("modbus-tcp://[::1]", "modbus-tcp", "[::1]") == ("::1", 502)


@pytest.mark.parametrize("role", ["coil-y", "platform"])
def test_the_file_is_named_with_line_and_key_and_no_guardian_is_asked(
    role: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("labcal.bench.loading.GuardianClient", None)
    text = EXAMPLE.read_text(encoding="utf-8")
    text = text[: text.rindex("[twin]")].replace(f'"emulated://"\nrole = "{role}"', f'"tcp://host"\nrole = "{role}"')
    text = text.replace('"emulated://"\nrole = "coil-x"', '"tcp://host:1"\nrole = "coil-x"')
    file = tmp_path / "bench.toml"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match="states no port") as caught:
        load_bench(file, None, 1)
    assert caught.value.line == text[: text.index('"tcp://host"')].count("\n") + 1
