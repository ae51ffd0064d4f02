"""A calibration whose run was fitted and never traced: what stands above its approval, and what comes before it."""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.ipc.answers import CalibrationFile
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.calibration_rows import CLOSED
from labcal.gui.viewmodels.hands import NEXT_IS
from labcal.gui.viewmodels.number_format import format_number
from labcal.gui.viewmodels.path import PathViewModel

NOT_TRACED = QT_TRANSLATE_NOOP(
    "Words", "▲ Not traced: {0} nT of |b| are left over beyond the map, and nobody has looked for their cause."
)
DO_HERE = QT_TRANSLATE_NOOP("Words", "To do here: {0}")
NO_FIGURE = QT_TRANSLATE_NOOP(
    "Words", "▲ Not traced: nobody has looked for the cause of what is left over beyond the map."
)


def not_traced(path: PathViewModel, one: CalibrationFile) -> str:
    """That the residual of its run was not traced, and how much that is; "" where it was, or its run is not here."""
    listed = any(run.run_id == one.run_id for run in path.runs)
    if not listed or one.method == CLOSED or path.traced(one.run_id):
        return ""
    if one.left_nT is None:
        return translated(str(NO_FIGURE))
    return translated(str(NOT_TRACED)).format(format_number(one.left_nT, signed=False))


def comes_first(path: PathViewModel, one: CalibrationFile) -> str:
    """What Next says of this run where that comes before its approval; "" where the page's own steps are next."""
    to = path.next()
    before = to.about == one.run_id and to.page in ("Fit", "Loop")
    return translated(str(NEXT_IS)).format(to.words) if before else ""


def next_is(path: PathViewModel, one: CalibrationFile, step: str) -> str:
    """That this step is next, or to be done here where Next is of something else; "" where none is."""
    words = NEXT_IS if path.next().about == one.run_id else DO_HERE
    return translated(str(words)).format(translated(step)) if step else ""
