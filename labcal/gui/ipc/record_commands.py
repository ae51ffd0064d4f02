"""What the worker reads of a run's record beside its rows."""

from __future__ import annotations

from labcal.gui.ipc.channel import Channel
from labcal.gui.ipc.handlers import handles
from labcal.gui.ipc.record_messages import TellRecord, TellTurned
from labcal.record.told import Told
from labcal.record.turned import TurnBefore


def tell(channel: Channel, asked: TellRecord) -> Told:
    """Interruptions and notes of a run."""
    from labcal.session.told import told

    return told(asked.run)


def tell_turned(channel: Channel, asked: TellTurned) -> tuple[TurnBefore, ...]:
    """What is drawn of a run before it is gone on with."""
    from labcal.session.turned import turned

    return turned(asked.run)


HANDLERS = (handles(TellRecord, tell), handles(TellTurned, tell_turned))
