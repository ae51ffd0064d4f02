"""Waveshare relays: frames with the CRCs of the wiki, and contacts that do not follow."""

from __future__ import annotations

import pytest
from frames import read

from drivers.waveshare_relay import WaveshareRelay
from labcal.bench.driver_kit.testing import SILENT, scripted
from labcal.errors import InstrumentError

ON, OFF = bytes.fromhex("01050000FF008C3A"), bytes.fromhex("010500000000CDCA")
VERSION = bytes.fromhex("0103800000 01ADCA")
READ, IS_ON, IS_OFF = (bytes.fromhex(h) for h in ("010100000001FDCA", "010101019048", "010101005188"))


def test_polarity_minus_is_relay_on_and_is_read_back() -> None:
    with scripted(WaveshareRelay, [(ON, ON), (READ, IS_ON)], x=0) as relay:
        relay.set_polarity("x", -1)


def test_contacts_that_do_not_follow_are_a_fault() -> None:
    with scripted(WaveshareRelay, [(ON, ON), (READ, IS_OFF)], x=0) as relay, pytest.raises(InstrumentError) as caught:
        relay.set_polarity("x", -1)
    assert caught.value.fault == "polarity not confirmed"


def test_a_write_without_a_reply_is_not_repeated() -> None:
    with scripted(WaveshareRelay, [(OFF, SILENT)], x=0) as relay, pytest.raises(InstrumentError) as caught:
        relay.set_polarity("x", 1)
    assert caught.value.fault == "silent"


def test_an_old_firmware_is_another_instrument() -> None:
    with (
        scripted(WaveshareRelay, [(VERSION, bytes.fromhex("0103020064B9AF"))]) as relay,
        pytest.raises(InstrumentError) as caught,
    ):
        relay.identify()
    assert caught.value.fault == "another instrument"


@pytest.mark.parametrize(("mode", "fine"), [(0, True), (1, False)])
def test_a_board_whose_inputs_move_its_relays_is_refused(mode: int, fine: bool) -> None:
    wire = [read("0103 8000 0001", [200]), read("0103 1000 0001", [0]), read("0103 1002 0001", [mode])]
    with scripted(WaveshareRelay, wire, x=0, z=2, inputs=True) as relay:
        if fine:
            assert relay.identify().firmware == "V2.00"
            return
        with pytest.raises(InstrumentError, match="relay 2") as caught:
            relay.identify()
    assert caught.value.fault == "wrong set-up"
