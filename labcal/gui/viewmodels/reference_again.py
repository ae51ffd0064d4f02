"""The reference, read again after the coils were switched off: whether it sees the zero that the supplies state.

It is judged by the ambient field that a run compared it with last; once something was mounted anew, by the rule of
`bench.coils.before_hands`.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from labcal.bench.coils import state
from labcal.bench.coils.agreement import BEFORE_HANDS, CHANGED, LIMIT_NT, NO_AMBIENT, OF_BEFORE
from labcal.bench.coils.before_hands import DRIFT_NT_PER_H
from labcal.gui.ipc.bench_facts import Bench
from labcal.gui.ipc.lab_messages import InstrumentRead
from labcal.gui.viewmodels.field_witness import Off

CURRENT_FOLLOWS = 0.02  # of the coils' field, between what was set and what was read


def ambient_of(known: state.LabState, facts: Bench) -> tuple[state.Vector, float] | None:
    """The field [nT, C] that the reference sees with the coils at zero, and how far off that may be.

    None where it has not agreed with the supplies.
    """
    agreed, coils = known.reference, [coil.current_A for coil in known.coils]
    if agreed.verdict != "agrees" or agreed.expected_nT is None or None in coils:
        return None
    of_coils = np.array(facts.cage.matrix) @ np.array(coils, dtype=float)
    x, y, z = (np.array(agreed.expected_nT) - of_coils).tolist()
    return (x, y, z), LIMIT_NT + CURRENT_FOLLOWS * float(np.linalg.norm(of_coils))


def mounted_anew(known: state.LabState) -> bool:
    """Whether what the reference saw before says nothing any more."""
    return known.reference.why in (NO_AMBIENT, *OF_BEFORE)


def measured_at_s(agreed: state.Witness) -> float | None:
    """When the ambient field was measured with which it agreed: long before, where only hands were there since."""
    if agreed.read_s is None or agreed.why != BEFORE_HANDS:
        return agreed.read_s
    return agreed.read_s - (agreed.limit_nT - LIMIT_NT) / DRIFT_NT_PER_H * 3600  # its limit says how long before


def seconded(
    known: state.LabState,
    said: tuple[InstrumentRead, ...],
    ambient: tuple[state.Vector, float] | None,
    off: Off | None = None,
) -> state.LabState:
    """`known` with what the reference, if it was among those just read, says of a zero.

    A doubt stands until the supplies read zero after it and the reference sees that by the same comparison.
    `off`: what it saw with the coils off, however long ago, and the least change of it that tells of a coil.
    """
    seen = next((one for one in said if one.role == "reference" and not one.held), None)
    on = any(coil.current_A is not None and not coil.zero for coil in known.coils)
    if on:
        return known
    if seen is None:  # these supplies alone were read
        before = _just_seen(known, said)
        found = None if before is None else _agreement(known, before, ambient, off)
        return known if found is None or known.reference.verdict == "disagrees" else replace(known, reference=found)
    if known.reference.verdict == "disagrees":
        found = _agreement(known, seen, ambient, off)
        return known if found is None else replace(known, reference=found)
    zero = all(coil.zero for coil in known.coils)
    if zero and ambient is not None:
        return replace(known, reference=_witness(seen, ambient))
    if seen.field_nT is not None and off is not None:  # it tells of a supply that is silent, too
        apart, least = float(np.linalg.norm(np.subtract(seen.field_nT, off.field_nT))), off.least_nT
        if apart > least:
            found = state.Witness("not known", CHANGED, seen.field_nT, off.field_nT, apart, least, seen.read_s)
            return replace(known, reference=found)
    if zero:
        return replace(known, reference=_witness(seen, None) if off is None else _by_off(seen, off))
    why = NO_AMBIENT if off is None else BEFORE_HANDS
    return replace(known, reference=state.Witness(why=why)) if known.reference.why == CHANGED else known


def _just_seen(known: state.LabState, said: tuple[InstrumentRead, ...]) -> InstrumentRead | None:
    """What the reference saw just before these supplies were read: a zero of theirs need not wait for its next look.

    What it saw then may be of a current that flows no more: it may agree, and never disagrees.
    """
    field, coils = known.field, [one.read_s for one in said if one.role.startswith("coil-") and one.read_s is not None]
    if not coils or field.seen_nT is None or field.read_s is None or max(coils) - field.read_s > state.FRESH_S:
        return None
    if (known.reference.read_s or 0.0) >= field.read_s:  # it was compared with that
        return None
    return InstrumentRead("", "reference", "", read_s=field.read_s, field_nT=field.seen_nT)


def _agreement(
    known: state.LabState, seen: InstrumentRead, ambient: tuple[state.Vector, float] | None, off: Off | None
) -> state.Witness | None:
    """That what was `seen` is a zero, newer than any doubt in `known`; None where it is not, whatever else it is."""
    doubted_s = known.reference.read_s if known.reference.verdict == "disagrees" else None
    after = all(c.zero and c.read_s is not None and (doubted_s is None or c.read_s > doubted_s) for c in known.coils)
    if not after or not known.coils or (ambient is None and off is None):
        return None
    found = _witness(seen, ambient) if ambient is not None or off is None else _by_off(seen, off)
    return found if found.verdict == "agrees" else None


def _by_off(seen: InstrumentRead, off: Off) -> state.Witness:
    """By what it saw before hands were there: an agreement where that excludes a current that matters; no doubt."""
    if seen.field_nT is None:
        return _witness(seen, None)
    apart = float(np.linalg.norm(np.subtract(seen.field_nT, off.field_nT)))
    if off.limit_nT is None or apart > off.limit_nT:
        return state.Witness(why=BEFORE_HANDS)
    return state.Witness("agrees", BEFORE_HANDS, seen.field_nT, off.field_nT, apart, off.limit_nT, seen.read_s)


def _witness(seen: InstrumentRead, ambient: tuple[state.Vector, float] | None) -> state.Witness:
    if seen.field_nT is None:
        return state.Witness(why=state.REFERENCE_SILENT if seen.fault else state.NOT_ASKED)
    if ambient is None:
        return state.Witness(why=NO_AMBIENT)
    expected, limit = ambient
    apart = float(np.linalg.norm(np.subtract(seen.field_nT, expected)))
    verdict: state.Verdict = "agrees" if apart <= limit else "disagrees"
    return state.Witness(verdict, "", seen.field_nT, expected, apart, limit, seen.read_s)
