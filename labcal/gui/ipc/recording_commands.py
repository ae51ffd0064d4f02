"""What the worker does with a recording of others: its mapping looked at and changed, and the import by it."""

from __future__ import annotations

from pathlib import Path

from labcal.gui.ipc.answers import MappedLine, RecordingMapped
from labcal.gui.ipc.channel import Channel
from labcal.gui.ipc.handlers import handles
from labcal.gui.ipc.messages import ImportRecording, LookAtRecording


def look(channel: Channel, asked: LookAtRecording) -> RecordingMapped:
    """The recording as its mapping has it, guessed where there is none yet."""
    from labcal.session import recording_mapping

    found = recording_mapping.look(Path(asked.path), asked.before, asked.changes)
    lines = tuple(MappedLine(one.keys, one.value, one.remark, one.first) for one in found.lines)
    return RecordingMapped(found.text, lines, found.rows, found.remarks, found.objection)


def take(channel: Channel, asked: ImportRecording) -> str:
    """Take it into the store."""
    from labcal.session import recording_mapping

    return recording_mapping.take(Path(asked.path), asked.text).result


HANDLERS = (handles(LookAtRecording, look), handles(ImportRecording, take))
