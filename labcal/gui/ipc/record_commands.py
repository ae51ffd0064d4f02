"""What the worker reads of a run's record beside its rows."""

from __future__ import annotations

from labcal.gui.ipc.channel import Channel
from labcal.gui.ipc.handlers import handles
from labcal.gui.ipc.record_messages import TellRecord
from labcal.record.told import Told


def tell(channel: Channel, asked: TellRecord) -> Told:
    """Interruptions and notes of a run."""
    from labcal.session.told import told

    return told(asked.run)


HANDLERS = (handles(TellRecord, tell),)
