"""`labcal` as somebody starts it at a terminal; its wall clock can be set while it runs, by the file CAMPAIGN_CLOCK."""

from __future__ import annotations

import fcntl
import os
import signal
import sys
import termios
import time
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

sys.path.pop(0)  # this folder: labcal must not find the campaign's files
for name in (signal.SIGHUP, signal.SIGTERM):
    signal.signal(name, signal.SIG_DFL)  # whoever runs the campaign may have them ignored
signal.signal(signal.SIGINT, signal.default_int_handler)
fcntl.ioctl(0, termios.TIOCSCTTY, 0)

SHIFT = Path(os.environ.get("CAMPAIGN_CLOCK", os.devnull))
true_time = time.time


def shift_s() -> float:
    return float(SHIFT.read_text() or 0) if SHIFT.exists() else 0.0


def utc(self: Any) -> datetime:
    return datetime.now(UTC) + timedelta(seconds=shift_s())


if __name__ == "__main__":
    if "CAMPAIGN_CLOCK" in os.environ:
        from labcal.bench.clock import RealClock

        time.time = lambda: true_time() + shift_s()
        RealClock.utc = utc  # type: ignore[method-assign]
    from labcal.cli import main

    main()
