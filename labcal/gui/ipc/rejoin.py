"""`python -m labcal.gui.ipc.rejoin PID`: a window's line to the worker PID that went on without one, byte for byte."""

from __future__ import annotations

import os
import socket
import sys
import threading
from contextlib import suppress

from labcal.system import run_door

BYTES = 65536


def main(worker: int) -> int:
    """Carry until the worker hangs up; exit 1 where no run goes on there."""
    try:
        connection = run_door.knock(worker)
    except OSError as error:
        print(f"no run goes on in process {worker}: {error}", file=sys.stderr)
        return 1
    threading.Thread(target=_carry_out, args=(connection,), daemon=True).start()
    with suppress(OSError):  # either end is gone
        while data := connection.recv(BYTES):
            sys.stdout.buffer.write(data)
            sys.stdout.buffer.flush()
    return 0


def _carry_out(connection: socket.socket) -> None:
    """What the window says; where it hangs up, so does this."""
    with suppress(OSError):
        while data := os.read(sys.stdin.fileno(), BYTES):
            connection.sendall(data)
    with suppress(OSError):
        connection.shutdown(socket.SHUT_WR)


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1])))
