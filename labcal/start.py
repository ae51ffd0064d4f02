"""The first step of the command line: Ctrl-C while the program loads ends it without a traceback."""

from __future__ import annotations

import signal
import sys


def main() -> None:
    """Load the commands, then hand over; from there on Ctrl-C is an order to stop, and is answered.

    Coils that are to go off do so first.
    """
    orders = signal.getsignal(signal.SIGINT)
    if orders is signal.default_int_handler:  # else it is ignored, for whoever started this wants it so
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    if sys.argv[1:3] == ["bench", "off"]:
        from pathlib import Path

        from labcal.bench import early_off

        if early_off.is_off(sys.argv[1:]) and (code := early_off.off(Path(sys.argv[3]))) is not None:
            sys.exit(code)
    from labcal import cli

    signal.signal(signal.SIGINT, orders)
    cli.main()
