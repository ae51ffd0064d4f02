"""A process of its own for whatever takes time or can fail: the bench, fits, the loop, files.

`python -m labcal.gui.ipc.worker` reads one message a line from stdin (`messages`, `lines`), works through the commands
in order and says for each Done or Failed, and Progress before that. During a run it also says what is Recorded and the
StateRead, and hears Answer, Pause, GoOn, Stop, Abort and Note at any moment. With `--watched` somebody starts a window
that broke off again: a run goes on until it is back (`channel`).
"""

from __future__ import annotations

import sys
import traceback

from labcal.gui.ipc import (
    archive_commands,
    bench_commands,
    bench_file_commands,
    compare_commands,
    customer_commands,
    file_commands,
    record_commands,
    recording_commands,
    study_commands,
)
from labcal.gui.ipc.channel import Channel, stdio_channel
from labcal.gui.ipc.codec import encode
from labcal.gui.ipc.messages import Done, Event, Failed, Request
from labcal.gui.ipc.wire import fault_of

ROOMS = (
    *(bench_commands, bench_file_commands, study_commands, compare_commands),
    *(customer_commands, file_commands, record_commands, recording_commands, archive_commands),
)
HANDLERS = dict(pair for room in ROOMS for pair in room.HANDLERS)


def serve(channel: Channel) -> None:
    """Work through what is asked until the window hangs up."""
    for request in channel.requests():
        channel.send(carried_out(channel, request))


def carried_out(channel: Channel, request: Request) -> Event:
    """Done with the answer, or Failed with what went wrong."""
    try:
        return Done(request.number, encode(HANDLERS[type(request.command)](channel, request.command)))
    except Exception as error:
        return Failed(request.number, fault_of(error, traceback.format_exc()))


if __name__ == "__main__":
    serve(stdio_channel(watched="--watched" in sys.argv))
