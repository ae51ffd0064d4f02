"""What the worker does for those who are named on a certificate, and for whom it is handed out to."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

from labcal.gui.ipc.channel import Channel
from labcal.gui.ipc.customer_messages import HandOut, Named, StateNames, WhoIsNamed
from labcal.gui.ipc.handlers import handles
from labcal.record.administrative import Address, Laboratory
from labcal.record.run_id import name_outside

if TYPE_CHECKING:
    from labcal.record import Administrative


def who_is_named(channel: Channel, asked: WhoIsNamed) -> Named:
    """Laboratory and customer of a certificate, as far as they are stated."""
    from labcal.session.naming import named_on

    return _in_lines(named_on(Path(asked.path)))


def state_names(channel: Channel, asked: StateNames) -> Named:
    """Name the laboratory, the customer, or both."""
    from labcal.session.naming import name_on

    laboratory = None if asked.laboratory is None else Laboratory(**asdict(asked.laboratory))
    customer = None if asked.customer is None else Address(**asdict(asked.customer))
    return _in_lines(name_on(Path(asked.path), laboratory, customer))


def _in_lines(stated: Administrative) -> Named:
    laboratory, customer = (", ".join(who.lines()) if who else "" for who in (stated.laboratory, stated.customer))
    return Named(laboratory, customer)


def hand_out(channel: Channel, asked: HandOut) -> str:
    """All that goes to the customer, into one folder."""
    from labcal import session
    from labcal.session.handing_out import hand_out_whole

    path = Path(asked.path)
    name = name_outside(session.load_calibration(path).dut.serial, path.stem)
    hand_out_whole(path, Path(asked.folder), name)
    return asked.folder


HANDLERS = (handles(WhoIsNamed, who_is_named), handles(StateNames, state_names), handles(HandOut, hand_out))
