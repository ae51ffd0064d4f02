"""The reference as a witness that a coil is on, where its supply is silent or says zero. No widgets."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.bench.coils import state
from labcal.bench.coils.agreement import CHANGED, LIMIT_NT, OF_FIELD
from labcal.bench.coils.before_hands import BeforeHands, least_that_matters_nT
from labcal.gui.ipc.bench_facts import Bench
from labcal.gui.translations.translate import translated

SEES_MORE = QT_TRANSLATE_NOOP("Words", "the reference sees {0} µT along {1} more than with the coils off")


def least_seen_nT(facts: Bench, measured_s: float, now_s: float) -> float:
    """A change of more than that since `measured_s` is a coil's: no mounting makes it, a tenth of a limit does."""
    cage = facts.cage
    matters_nT = least_that_matters_nT(np.array(cage.matrix), np.array(cage.limit_A, dtype=float), OF_FIELD)
    return max(matters_nT, BeforeHands(np.zeros(3), measured_s).most_hidden_nT(LIMIT_NT, now_s))


def more_than_off(known: state.LabState, facts: Bench | None) -> state.Vector | None:
    """What the reference sees [nT, C] beyond the ambient field, where that tells of a coil that nobody owns to."""
    seen, on = known.reference, any(coil.current_A is not None and not coil.zero for coil in known.coils)
    if facts is None or on or seen.seen_nT is None or seen.expected_nT is None or seen.read_s is None:
        return None
    if seen.verdict != "disagrees" and seen.why != CHANGED:
        return None
    x, y, z = np.subtract(seen.seen_nT, seen.expected_nT).tolist()
    return (x, y, z) if np.hypot(np.hypot(x, y), z) > least_seen_nT(facts, seen.read_s, seen.read_s) else None


def sees_more(more_nT: state.Vector) -> str:
    """In words, along the axis on which it is most."""
    most = max(range(3), key=lambda axis: abs(more_nT[axis]))
    said = f"{more_nT[most] / 1000:+.{0 if abs(more_nT[most]) >= 1e4 else 1}f}".replace("-", "−")
    return translated(str(SEES_MORE)).format(said, "xyz"[most])
