"""What becomes of the delays of a run that was interrupted: which are kept, and which Go on cannot measure any more."""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.number_format import step_title
from labcal.gui.viewmodels.run import RunViewModel
from labcal.gui.viewmodels.run_steps import axis_of, name_a_turn
from labcal.record.delays import delays_open

THERE_AND_BACK = 2  # turns of one stretch, which a delay is worked out from
TEXTS = (
    QT_TRANSLATE_NOOP("Words", "Measured already, and kept: {0} (how late the reading follows the field)."),
    QT_TRANSLATE_NOOP(
        "Words",
        "Lost: {0}, which comes of turns there and back without a break, and too few of those are left to measure. "
        "To get it: sync-check, or a new preflight.",
    ),
)
KEPT, LOST = map(str, TEXTS)


def delays_lost(run: RunViewModel) -> list[str]:
    """Those about axes of which some turns are kept, so that too few are measured without a break."""
    return [one for one in delays_open(run.names, run.measurements) if _is_lost(run, one.removeprefix("delay "))]


def delay_words(run: RunViewModel) -> str:
    """Which delays are kept and which are lost; "" where no turn has decided that yet."""
    kept, lost = [name for name in run.measurements if name.startswith("delay ")], delays_lost(run)
    said = ((KEPT, kept), (LOST, lost))
    return " ".join(translated(words).format(", ".join(map(step_title, names))) for words, names in said if names)


def _is_lost(run: RunViewModel, axis: str) -> bool:
    turns = [mark for name, mark in run.steps() if name_a_turn((name,)) and axis_of(name) == axis]
    left = sum(mark not in ("done", "skipped") for mark in turns)
    return "done" in turns and len(turns) >= THERE_AND_BACK > left
