"""Which runs are the same one, how each ended, and which two may stand beside each other. No widgets."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.ipc.answers import RunLine
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.run_search import NOT_WHOLE
from labcal.record.endings import ended_word, ended_words

NO_COMPARISON = QT_TRANSLATE_NOOP("Words", "No comparison: run {0} is {1}; what it lacks would look like a change.")


def run_key(one: RunLine) -> tuple[str, str]:
    """What a run is known by: in the archive names of runs repeat."""
    return one.site, one.sha256 or one.run_id


def in_full(one: RunLine) -> str:
    """How it ended, with the reason."""
    return in_words(ended_words(one.status, stopped=one.stopped))


def why_not_compared(chosen: Sequence[RunLine]) -> str:
    """What is wrong with two runs that were chosen to be compared; "" where nothing is, or where they are not two."""
    part = next((one for one in chosen if one.status in NOT_WHOLE), None)
    if len(chosen) != 2 or part is None:
        return ""
    return translated(str(NO_COMPARISON)).format(part.run_id, translated(ended_word(part.status, stopped=part.stopped)))
