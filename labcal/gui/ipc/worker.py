"""A process of its own for whatever takes time or can fail: the bench, fits, the loop, files.

`python -m labcal.gui.ipc.worker` reads one JSON request a line from stdin, {"do": command, "id": n, …}, works through
them in order and answers with messages of that id: any number of "progress", then "done" with a result, or "fault".
During a run it also sends "items", and hears answer, pause, go on, stop, abort and note at any moment.
"""

from __future__ import annotations

import traceback
from collections.abc import Callable
from dataclasses import asdict
from typing import Any

from labcal.gui.ipc import bench_commands, file_commands, study_commands
from labcal.gui.ipc.channel import Channel, stdio_channel
from labcal.gui.ipc.wire import fault_of

Command = Callable[..., Any]
COMMANDS: dict[str, Command] = {**bench_commands.COMMANDS, **study_commands.COMMANDS, **file_commands.COMMANDS}


def serve(channel: Channel) -> None:
    """Work through what is asked until the window hangs up."""
    for request in channel.requests():
        number, command = request.pop("id"), request.pop("do")
        try:
            channel.send("done", id=number, result=COMMANDS[command](channel, **request))
        except Exception as error:
            channel.send("fault", id=number, **asdict(fault_of(error, traceback.format_exc())))


if __name__ == "__main__":
    serve(stdio_channel())
