"""What a coil carried when it was read last: a supply that fell silent with a current may have it on still."""

from __future__ import annotations

import time
from collections.abc import Iterable

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.bench.coils.state import CoilReading
from labcal.gui.translations.punctuation import listed_apart
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.number_format import format_number

LAST = QT_TRANSLATE_NOOP("Words", "{0}: {1} A when last read, {2}")


class LastCurrents:
    """By axis, as it was read last; times are by the computer's monotonic clock."""

    def __init__(self) -> None:
        self._read = dict[str, CoilReading]()

    def keep(self, coils: Iterable[CoilReading]) -> None:
        """What was read of these; one that was not read keeps what it had."""
        self._read |= {coil.axis: coil for coil in coils if coil.current_A is not None and coil.read_s is not None}

    def words(self, coils: Iterable[CoilReading]) -> str:
        """Of those `coils` that are not known now, and were not at zero; with the time on the wall of that."""
        unknown = (self._read.get(coil.axis) for coil in coils if coil.current_A is None)
        return listed_apart([_words(coil) for coil in unknown if coil is not None and not coil.zero])


def _words(coil: CoilReading) -> str:
    clock_s = time.time() - time.monotonic() + (coil.read_s or 0.0)
    when = time.strftime("%H:%M:%S", time.localtime(clock_s))
    return translated(str(LAST)).format(coil.axis, format_number(coil.current_A or 0.0, 3), when)
