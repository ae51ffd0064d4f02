"""What the worker reads of a run's record beside its rows."""

from __future__ import annotations

from labcal.gui.ipc.channel import Channel
from labcal.gui.ipc.handlers import handles
from labcal.gui.ipc.record_messages import Interruption, TellRecord, Told


def tell(channel: Channel, asked: TellRecord) -> Told:
    """Interruptions and notes of a run."""
    from labcal.session.told import told

    found = told(asked.run)
    return Told(tuple(Interruption(one.at, one.gone_s, one.again) for one in found.interruptions), found.notes)


HANDLERS = (handles(TellRecord, tell),)
