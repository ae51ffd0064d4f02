"""What a run's record tells beside its rows: interruptions, and what people noted."""

from __future__ import annotations

from dataclasses import dataclass

from labcal.record.stream import Measurement


@dataclass(frozen=True, slots=True)
class Interruption:
    """`at`: the step that was broken off, "" where none had begun. `gone_s` is None where nobody wrote when it ended.

    `again`: the steps that were begun before it and after it. `timed` is False on a simulated bench: its clock stood.
    """

    at: str
    gone_s: float | None
    again: tuple[str, ...]
    timed: bool = True


@dataclass(frozen=True, slots=True)
class Told:
    """Notes and photographs in the order that they were made, in the words that were typed.

    `remarks`: what the procedure itself noted. `open`: of the run's checks the last result of each that is no PASS;
    `not_measured`: the closures and delays that it was to have and has not. `other_serials`: a sentence for each
    instrument that named another serial than was stated, as the DUT's that was typed.
    """

    interruptions: tuple[Interruption, ...] = ()
    notes: tuple[str, ...] = ()
    remarks: tuple[str, ...] = ()
    open: tuple[Measurement, ...] = ()
    not_measured: tuple[str, ...] = ()
    other_serials: tuple[str, ...] = ()
