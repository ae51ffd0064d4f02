"""The first step of the command line: Ctrl-C while the program loads ends it without a traceback."""

from __future__ import annotations

import signal


def main() -> None:
    """Load the commands, then hand over; from there on Ctrl-C is an order to stop, and is answered."""
    orders = signal.getsignal(signal.SIGINT)
    if orders is signal.default_int_handler:  # else it is ignored, for whoever started this wants it so
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    from labcal import cli

    signal.signal(signal.SIGINT, orders)
    cli.main()
