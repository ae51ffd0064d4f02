"""POS-1: its words end with a zero byte, its readings are picotesla with a code."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import pytest

from drivers.pos1 import Pos1
from labcal.bench.driver_kit.testing import Exchange, scripted
from labcal.errors import InstrumentError

OK: Exchange = (b"mode text\0", b"ok\0")
GOOD = b"48607938 +- 0021 [80] 07-25-13 12:23:22.12\0"


def taken(*replies: bytes | Sequence[bytes] | None, **stated: Any) -> tuple[list[float], list[str]]:
    """The values and the mishaps of a driver whose `run` is answered so, one after another."""
    with scripted(Pos1, [OK, *((b"run\0", reply) for reply in replies)], **stated) as driver:
        driver.start()
        blocks = driver.read_until(driver._clock.now() + 3.0 * len(replies) - 0.1)
        return [float(v) for block in blocks for v in block.values[:, 0]], [e.data["fault"] for e in driver.events()]


def test_a_reading_is_nanotesla_of_picotesla() -> None:
    assert taken(GOOD, [GOOD[:10], GOOD[10:]]) == ([48607.938, 48607.938], [])


def test_a_reading_is_as_old_as_is_stated() -> None:
    with scripted(Pos1, [OK, (b"run\0", GOOD)], delay_s=0.7) as driver:
        driver.start()
        asked_s = driver._clock.now()
        (block,) = driver.read_until(asked_s + 1.0)
    assert block.stream == "reference"
    assert block.columns == ("ref_f",)
    assert block.t_s[0] == pytest.approx(asked_s - 0.7, abs=0.02)
    assert block.raw == GOOD[:-1]


@pytest.mark.parametrize(
    "reply",
    [
        GOOD.replace(b"0021", b"10021"),  # a scatter of 10 nT
        GOOD[1:12] + b"\0",
        GOOD.replace(b"[80]", b"[x0]"),
        GOOD.replace(b"48607938", b"4860793x"),
        b"\0",
        b"ok\0",
    ],
)
def test_what_is_no_reading_gives_no_value_and_is_noted(reply: bytes) -> None:
    assert taken(reply, GOOD) == ([48607.938], ["bad frame"])


@pytest.mark.parametrize(
    ("code", "why", "fault"),
    [
        (b"[10]", "out of its range", "overloaded"),
        (b"[20]", "no signal", "no signal"),
        (b"[44]", "low power", "no signal"),
        (b"[30]", "out of its range and no signal", "overloaded"),
    ],
)
def test_its_own_error_is_said_and_gives_no_value(code: bytes, why: str, fault: str) -> None:
    with pytest.raises(InstrumentError, match=why) as caught:
        taken(GOOD.replace(b"[80]", code))
    assert caught.value.fault == fault
    assert caught.value.remedy


def test_a_warning_is_no_error() -> None:
    assert taken(GOOD.replace(b"[80]", b"[84]")) == ([48607.938], [])


def test_silence_gives_nothing_and_the_next_reading_is_its_own() -> None:
    assert taken(None, GOOD) == ([48607.938], [])


def test_who_it_is() -> None:
    with scripted(Pos1, [OK, (b"about\0", b"POS-1 QMLab N 117\0")]) as driver:
        assert (driver.identify().model, driver._link.never is not None) == ("POS-1", True)


def test_another_instrument_is_refused() -> None:
    with scripted(Pos1, [OK, (b"about\0", b"Re-enter\0")]) as driver, pytest.raises(InstrumentError) as caught:
        driver.identify()
    assert caught.value.fault == "another instrument"


def test_it_is_tuned_where_a_range_is_stated() -> None:
    with scripted(Pos1, [OK, (b"range 48500\0", b"ok\0")], range_nT=48_500) as driver:
        driver.start()
