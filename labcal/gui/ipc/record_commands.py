"""What the worker reads of a run's record beside its rows."""

from __future__ import annotations

from labcal.gui.ipc.channel import Channel
from labcal.gui.ipc.handlers import handles
from labcal.gui.ipc.record_messages import (
    LookForLeft,
    RunResult,
    TellRecord,
    TellResults,
    TellTurned,
)
from labcal.record.left_running import LeftRunning
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


def tell_results(channel: Channel, asked: TellResults) -> tuple[RunResult, ...]:
    """As the card of a run's end says it."""
    from labcal.session.checks import left_out, results, worst
    from labcal.store import Store

    def of(store: Store, run: str) -> RunResult:
        items = list(store.items(run, but="block", raw=False))
        found = results(items)
        least = worst(found)
        return RunResult(run, "" if least is None else least.verdict, left_out(items, found))

    with Store.open() as store:
        return tuple(of(store, run) for run in asked.runs)


def look_for_left(channel: Channel, asked: LookForLeft) -> LeftRunning | None:
    """What a killed process or another one has to do with the coils."""
    from labcal.session.left_running import left_running

    return left_running(asked.bench)


HANDLERS = (
    handles(TellRecord, tell),
    handles(TellResults, tell_results),
    handles(TellTurned, tell_turned),
    handles(LookForLeft, look_for_left),
)
