"""`labcal` as somebody starts it at a terminal; its wall clock can be set while it runs, by the file CAMPAIGN_CLOCK.

`launcher.py WORDS…` is that; `launcher.py --prepared` has everything imported and forks one for each order that comes
on the socket that is its standard input (`prepared.py`): two seconds of processor fewer a trial.
"""

from __future__ import annotations

import fcntl
import gc
import json
import os
import select
import signal
import socket
import sys
import tempfile
import termios
import time
from contextlib import suppress
from datetime import UTC, datetime, timedelta
from importlib import import_module
from pathlib import Path
from typing import Any

sys.path.pop(0)  # this folder: labcal must not find the campaign's files
PREPARED = "--prepared"
LOOK_S = 0.02
true_time = time.time


def shift_s() -> float:
    shift = Path(os.environ["CAMPAIGN_CLOCK"])
    return float(shift.read_text() or 0) if shift.exists() else 0.0


def utc(self: Any) -> datetime:
    return datetime.now(UTC) + timedelta(seconds=shift_s())


def at_a_terminal() -> None:
    """Standard input is this process's terminal, whose signals it hears."""
    for name in (signal.SIGHUP, signal.SIGTERM):
        signal.signal(name, signal.SIG_DFL)  # whoever runs the campaign may have them ignored
    signal.signal(signal.SIGINT, signal.default_int_handler)
    fcntl.ioctl(0, termios.TIOCSCTTY, 0)


def by_its_own_clock() -> None:
    """The clock of the wall can be set, where the campaign says so."""
    if "CAMPAIGN_CLOCK" in os.environ:
        from labcal.bench.clock import RealClock

        time.time = lambda: true_time() + shift_s()
        RealClock.utc = utc  # type: ignore[method-assign]  # that is what is meant


def serve(orders: socket.socket) -> None:
    """Fork for each order; returns in each child, at its terminal. Says {"pid"} of it, {"pid", "code"} when it ends."""
    while True:
        with suppress(ChildProcessError):
            while (ended := os.waitpid(-1, os.WNOHANG))[0]:
                tell(orders, {"pid": ended[0], "code": os.waitstatus_to_exitcode(ended[1])})
        if not select.select([orders], [], [], LOOK_S)[0]:
            continue
        words, handles, _, _ = socket.recv_fds(orders, 65536, 1)
        if not words:
            sys.exit(0)
        order = json.loads(words)
        if (child := os.fork()) == 0:
            orders.close()
            os.setsid()
            for number in range(3):
                os.dup2(handles[0], number)
            os.close(handles[0])
            out, err = open(1, "w", buffering=1), open(2, "w", buffering=1)  # noqa: SIM115  # open until the process ends
            sys.stdin, sys.stdout, sys.stderr = open(0), out, err  # noqa: SIM115  # as these are
            os.environ.clear()
            os.environ.update(order["env"])
            tempfile.tempdir = None
            sys.argv[1:] = order["words"]
            return
        os.close(handles[0])
        tell(orders, {"pid": child})


def tell(orders: socket.socket, what: dict[str, int]) -> None:
    """One message."""
    orders.send(json.dumps(what).encode())


if __name__ == "__main__":
    from labcal.cli import main

    if sys.argv[1:] == [PREPARED]:
        for module in ("labcal.cli.run", "labcal.session"):
            import_module(module)
        gc.freeze()
        serve(socket.socket(fileno=os.dup(0)))
    at_a_terminal()
    by_its_own_clock()
    main()
