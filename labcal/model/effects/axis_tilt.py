"""The platform axis is not where it was declared: in the cage, or in the body for each way of mounting.

With the true axis turned by the small vector d in the cage, p = R M (v − d × v); mounted along an axis turned by e in
the body, p' = p + e × p (to first order, from v_B = R(axis_body, −angle) · body_from_cage · v_C). A bearing that runs
out lets the axis wobble about its mean: d goes round with the platform angle. Where the spindle leans by d and the
device stands at angle zero as declared, levelled on the cage, e is M d in each mounting.
"""

from __future__ import annotations

import itertools

import numpy as np
from numpy.typing import NDArray

from labcal.geometry import rotate, skew
from labcal.model.effects import seat
from labcal.model.effects.protocol import Array, Confounded, Family
from labcal.model.effects.regressors import STEP, mountings, some_moment
from labcal.model.effects.scene import Rig, Scene
from labcal.model.effects.term import Term
from labcal.record import Run, offers
from labcal.record.vector import Vector

DEG = np.pi / 180
WAVES = {"cos": np.cos, "sin": np.sin}
WOBBLE = tuple(f"{wave}:" for wave in WAVES)
LAG_OR_TILT = Confounded(
    "a lag at a constant rate", "the mounting's phase and tilt", "turn at another rate, and backwards"
)
TILT_OR_GRADIENT = Confounded(
    "a tilted axis",
    "a gradient, in one direction of the field",
    "mount the device turned by 180°, or turn in another direction of the field",
)


def kernel(term: Term, scene: Scene) -> Array:
    """`cage_x` turns the axis in C, `cage_2:x` for the second mounted axis alone, `body_2:x` in B. Per degree.

    `spindle_x` turns the axis in C with the device as declared at angle zero. `cage_xy` is of second order, per square
    degree: a lean of two degrees misses the field by a thousandth without it.
    `cage_cos:x` and `cage_sin:x` turn it by the cosine and the sine of the platform angle, `body_m2:x` in the second
    mounting alone. `cage_rest:x` and `body_rest2:x` are those of a device at rest; `body_slip2:x` from t_step on.
    """
    assert scene.rig is not None
    out = np.zeros((len(scene), 3, len(term.parameters)))
    axes = _mounted(scene.rig.axis_body)
    for column, (name, _) in enumerate(term.parameters):
        where, _, direction = name.rpartition(":" if ":" in name else "_")
        frame, _, number = where.partition("_")
        rows = seat.rows_of(number, axes, term, scene)
        along = np.eye(3)["xyz".index(direction[0])]
        turn = skew(along) * DEG
        if frame in ("cage", "spindle"):
            moved = _second_order(direction) if len(direction) > 1 else -turn
            cage = scene.rig.reference_nT[rows] @ moved.T
            if number in WAVES:
                cage = cage * WAVES[number](scene.rig.angle_rad[rows])[:, None]
            out[rows, :, column] = np.einsum("nij,nj->ni", scene.rig.to_body[rows], cage)
        if frame == "spindle":
            out[rows, :, column] += np.cross(_at_zero(scene.rig, along, rows) * DEG, scene.rig.prediction_nT[rows])
        if frame == "body":
            out[rows, :, column] = scene.rig.prediction_nT[rows] @ turn.T
    return out


def _second_order(directions: str) -> Array:
    """The part of exp(−[d]×) with d_i d_j (3, 3): [d]×² / 2, d in degrees."""
    one, other = (skew(np.eye(3)["xyz".index(a)]) * DEG for a in directions)
    return np.asarray(one @ one / 2 if directions[0] == directions[1] else (one @ other + other @ one) / 2)


def _at_zero(rig: Rig, direction: Array, rows: NDArray[np.bool_]) -> Array:
    """M `direction` (n, 3): a direction of C as the body sees it while the platform stands at angle zero."""
    return rotate(rig.axis_body[rows], rig.angle_rad[rows], rig.to_body[rows] @ direction)


def _mounted(axis_body: Array) -> NDArray[np.intp]:
    """A number from 1 for each different axis, 0 where there is none."""
    known = np.isfinite(axis_body).all(axis=1)
    number = np.zeros(len(axis_body), dtype=np.intp)
    if known.any():
        axes = np.round(axis_body[known], 6)
        anew = np.r_[True, (axes[1:] != axes[:-1]).any(axis=1)]  # of the many rows few differ from the one before
        _, index = np.unique(axes[anew], axis=0, return_inverse=True)
        number[known] = index.ravel()[np.cumsum(anew) - 1] + 1
    return number


def candidates(run: Run) -> list[Term]:
    """A tilt in the cage, common to all, of the spindle alone, wobbling, or for each mounted axis; in the body; both.

    In the body it is one for each mounted axis, or for each mounting. At rest in the cage or in each mounting, and from
    a moment on where a mounting slips.
    """
    slips = [Term(kernel, form, shape=(some_moment(run),)) for form in seat.that_slip(run)]
    standing = [*(Term(kernel, form) for form in seat.in_stated_attitudes(run)), *slips]
    segments = [s for s in run.segments if s.kind == "rotation" and offers(run, s) == "vector"]
    if not segments:
        return standing
    across_cage = _across([s.axis_cage for s in segments if s.axis_cage is not None])
    common, wobble = (tuple((f"cage_{w}{a}", "deg") for w in ws for a in across_cage) for ws in (("",), WOBBLE))
    spindle = tuple((f"spindle_{a}", "deg") for a in across_cage)
    pairs = tuple(itertools.combinations_with_replacement(across_cage, 2))
    squares = tuple((f"cage_{a}{b}", "deg^2") for a, b in pairs)
    forms = (common, spindle, common + squares, common + wobble)
    terms = [Term(kernel, form) for form in forms]
    mounted = np.unique(np.round([s.axis_body for s in segments if s.axis_body is not None], 6), axis=0)
    if len(mounted) > 1:
        numbered = list(enumerate(mounted, start=1))
        each_axis = tuple((f"cage_{i}:{a}", "deg") for i, _ in numbered for a in across_cage)
        terms.append(Term(kernel, each_axis))
        terms.append(
            Term(kernel, each_axis + tuple((f"cage_{i}:{a}{b}", "deg^2") for i, _ in numbered for a, b in pairs))
        )
        body = tuple((f"body_{i}:{a}", "deg") for i, axis in numbered for a in _across([tuple(axis)]))
        terms.append(Term(kernel, body))
        terms.append(Term(kernel, (*common, *body)))  # levelled on the cage: its axis is tilted in both
    if len(each := mountings(run)) > len(mounted):
        names = (f"body_m{i}:{a}" for i, axis in each.items() for a in _across([axis]))
        terms.append(Term(kernel, tuple((name, "deg") for name in names)))
    return terms + standing


def _across(axes: list[Vector]) -> str:
    """The directions about which a turn moves any of these axes."""
    spread = np.sum([1 - np.square(axis) for axis in axes], axis=0)
    return "".join(a for a, moved in zip("xyz", spread, strict=True) if moved > 1e-6)


FAMILY = Family(
    "axis-tilt",
    "rig",
    kernel,
    candidates,
    phrase="the rotation axis is not where it was declared",
    shapes=(STEP,),
    experiment="mount the device turned by 180° about the platform axis and repeat",
    confounded=(LAG_OR_TILT, TILT_OR_GRADIENT),
    drawn_against="angle",
)
