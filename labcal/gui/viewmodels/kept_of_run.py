"""What is kept of a run that was fitted and traced before, in one line: nothing is worked out for it. No widgets."""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.calibration_rows import method_words
from labcal.gui.viewmodels.cause_words import with_id
from labcal.gui.viewmodels.loop_words import verdict_word
from labcal.gui.viewmodels.number_format import format_number
from labcal.gui.viewmodels.path import PathViewModel

KEPT = QT_TRANSLATE_NOOP("Words", "Kept of this run: {0}")
LEFT = QT_TRANSLATE_NOOP("Words", "{0} → {1} nT rms of the vector, noise alone {2} nT rms")
OFFSETS = QT_TRANSLATE_NOOP("Words", "offset k {0} nT by {1}")


def kept_words(path: PathViewModel, run_id: str) -> str:
    """Verdict, figures, causes, and how the calibration stands; "" where nothing is kept."""
    line = next((one for one in path.runs if one.run_id == run_id), None)
    file, parts = path.kept(run_id), list[str]()
    if line is not None and line.verdict:
        parts.append(verdict_word(line.verdict))
    if line is not None and line.left_nT is not None:
        before, after, noise = (format_number(value, signed=False) for value in line.left_nT)
        parts.append(translated(str(LEFT)).format(before, after, noise))
    if file is not None:
        parts += [with_id(effect, file.phrases) for effect in file.effects]
        offsets = " ".join(format_number(value) for value in file.k_nT)
        parts.append(translated(str(OFFSETS)).format(offsets, method_words(file) or "–"))
        parts.append(path.stands(run_id))
    kept = " · ".join(filter(None, parts))
    return translated(str(KEPT)).format(kept) if kept else ""
