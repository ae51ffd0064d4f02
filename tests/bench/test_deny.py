"""What a line refuses: by pattern, by Modbus address, and whatever the framing."""

from __future__ import annotations

import pytest

from labcal.bench.links.deny import DenyList
from labcal.errors import InstrumentError

WRITE = bytes.fromhex("06 0100 1601")


def denied(url: str, data: bytes, unit: int | None) -> bool:
    never = DenyList()
    never.add((rb"^.\x06\x01\0",), unit)
    try:
        never.check(url, data)
    except InstrumentError:
        return True
    return False


@pytest.mark.parametrize(("address", "refused"), [(3, True), (0, True), (4, False)])
def test_devices_on_one_pair_are_bound_by_their_own_list_only(address: int, refused: bool) -> None:
    assert denied("modbus-rtu:///dev/x", bytes([address]) + WRITE, 3) is refused


def test_a_tcp_header_does_not_hide_what_is_forbidden() -> None:
    assert denied("modbus-tcp://h:502", bytes.fromhex("0007 0000 0006 03") + WRITE, 3)
    assert not denied("modbus-tcp://h:502", bytes.fromhex("0306 0100 0006 03 03 0100 0001"), 3)


def test_without_an_address_a_list_binds_everybody() -> None:
    assert denied("serial:///dev/x", b"\x07" + WRITE, None)
