"""Runs that broke off and are to be gone on with. No widgets."""

from __future__ import annotations

from collections.abc import Collection

from labcal.gui.ipc.answers import RunLine


def to_be_resumed(runs: tuple[RunLine, ...], resumable: Collection[str] = ()) -> list[RunLine]:
    """Of `runs`, the newest first, the interrupted ones after which nobody began the same of the same DUT anew.

    Of procedures that can be gone on with, `resumable`, once these are known.
    """
    newest = dict[tuple[str, str], RunLine]()
    for one in runs:
        newest.setdefault((one.procedure, one.dut_serial), one)
    may = (one for one in newest.values() if one.procedure in resumable or not resumable)
    return [one for one in may if one.status == "interrupted"]
