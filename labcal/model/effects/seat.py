"""How the device sits: which mountings stand still in a stated attitude, and which may slip between two segments."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.model.effects.regressors import AXES, STEP
from labcal.model.effects.scene import Scene
from labcal.model.effects.term import Term
from labcal.record import Run, Segment, offers

Mask = NDArray[np.bool_]
Names = tuple[tuple[str, str], ...]
REST, SLIP, MOUNTING = "rest", "slip", "m"  # what a parameter's rows are, before a mounting's number
APART = 0.1  # of the field, across its mean direction: in one direction no turn about it is seen


def rows_of(where: str, axes: NDArray[np.intp], term: Term, scene: Scene) -> Mask:
    """The rows (n,) in which a parameter acts: `rest`, `rest2` at rest, all or in the second mounting alone; `m2`, `2`
    turning in the second mounting, or about the second of the `axes` (n,); `slip2` in it from t_step on; else turning.
    """
    assert scene.rig is not None
    kind = where.rstrip("0123456789")
    number = where[len(kind) :]
    turning, here = np.isfinite(scene.rig.angle_rad), scene.rig.mounting + 1
    if number:
        here = here == int(number) if kind else axes == int(number)
    if kind == SLIP:
        return np.asarray(here & (scene.t_s >= term.at(STEP.name)))
    rows = ~turning if kind == REST else turning
    return np.asarray(rows & here) if number else rows


def in_stated_attitudes(run: Run) -> list[Names]:
    """Forms of a device that stands otherwise than stated: the cage as a whole, or the body in each mounting."""
    standing = [number for number, segments in _seats(run).items() if all(s.kind == "static" for s in segments)]
    if len(standing) < 2:  # of one mounting K takes the turn up
        return []
    return [_turns(f"cage_{REST}"), tuple(name for number in standing for name in _turns(f"body_{REST}{number}"))]


def that_slip(run: Run) -> list[Names]:
    """Forms of a device that sits otherwise in its mounting from a moment on, for each that holds several segments."""
    return [_turns(f"body_{SLIP}{number}") for number, segments in _seats(run).items() if len(segments) > 1]


def _turns(where: str) -> Names:
    return tuple((f"{where}:{a}", "deg") for a in AXES)


def _seats(run: Run) -> dict[int, list[Segment]]:
    """The segments of each mounting that show how the device sits, by its number from 1 in order of first segments."""
    names = list(dict.fromkeys(s.mounting or i for i, s in enumerate(run.segments)))
    out: dict[int, list[Segment]] = {}
    for i, segment in enumerate(run.segments):
        shown = offers(run, segment) == "vector" and segment.reference_frame == "cage" and len(run.rows(i))
        if shown and (segment.kind == "rotation" or _is_seen_from_sides(run, i)):
            out.setdefault(names.index(segment.mounting or i) + 1, []).append(segment)
    return out


def _is_seen_from_sides(run: Run, index: int) -> bool:
    """Whether the field of a segment at rest has more than one direction."""
    assert run.reference_vector is not None
    field = run.reference_vector[run.rows(index)]
    field = field[np.isfinite(field).all(axis=1)]
    if not len(field):
        return False
    size = np.linalg.svd(field / np.linalg.norm(field, axis=1)[:, None], compute_uv=False)
    return bool(size[1] > APART * size[0])
