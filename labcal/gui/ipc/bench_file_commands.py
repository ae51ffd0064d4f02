"""What the worker does with a bench file: its settings read, changed and written, and a draft of what answers."""

from __future__ import annotations

from pathlib import Path

from labcal.gui.ipc.answers import BenchText, SettingLine
from labcal.gui.ipc.channel import Channel
from labcal.gui.ipc.handlers import handles
from labcal.gui.ipc.messages import EditBench, FindOnLines, Progress


def edit(channel: Channel, asked: EditBench) -> BenchText:
    """The file and its settings, limits first; what changes make of it, written where that is asked for."""
    from labcal.session.bench_settings import save, settings, with_changes

    bench = Path(asked.bench)
    changed = (save if asked.save else with_changes)(bench, asked.before, asked.changes) if asked.changes else None
    text, found = settings(bench)
    lines = tuple(SettingLine(one.keys, one.value, one.usual, one.unit, one.meaning, one.here) for one in found)
    return BenchText(text, lines) if changed is None else BenchText(text, lines, changed.difference, changed.objection)


def find(channel: Channel, asked: FindOnLines) -> tuple[str, ...]:
    """Ask who answers; nothing is set. What was found so far is sent meanwhile."""
    from labcal import session

    said: list[str] = []

    def say(line: str) -> None:
        said.append(line)
        channel.send(Progress(line))

    session.find_instruments((), Path(asked.out), say, force=True)  # the dialogue has asked
    return tuple(said)


HANDLERS = (handles(EditBench, edit), handles(FindOnLines, find))
