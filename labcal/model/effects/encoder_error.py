"""The platform's angle is read with an error of one or two cycles a turn: a disc off its centre, or tilted.

A graduated disc whose centre is off by d reads, with one head at radius r, an angle that is wrong by
(d / r) sin(θ − φ); a tilt of the disc, or two poles of a magnetic encoder that are unlike, has two cycles a turn.
"""

from __future__ import annotations

import re

import numpy as np

from labcal.errors import InputError
from labcal.model.effects.protocol import Array, Confounded, Family
from labcal.model.effects.scene import Scene
from labcal.model.effects.term import Term
from labcal.record import Run, offers

MOST_CYCLES = 2  # a turn
NAME = re.compile(r"(cos|sin)(\d)_deg")
WAVES = {"cos": np.cos, "sin": np.sin}
ERROR_OR_FIELD = Confounded(
    "an angle that is read wrong", "a field of the cage that goes by the platform's angle", "repeat in another field"
)


def kernel(term: Term, scene: Scene) -> Array:
    """E = δ(θ) dp/dθ, δ = Σ_h cos_h cos hθ + sin_h sin hθ: where the platform stands is the angle read and δ more."""
    assert scene.rig is not None
    rig = scene.rig
    turning = np.isfinite(rig.angle_rad) & np.isfinite(rig.axis_body).all(axis=1)
    angle = np.nan_to_num(rig.angle_rad)
    by_angle = np.where(turning[:, None], -np.cross(rig.axis_body, rig.prediction_nT), 0.0)
    waves = [wave(cycles * angle) for wave, cycles in map(_wave, term.parameters)]
    return np.asarray(np.radians(1.0) * by_angle[:, :, None] * np.stack(waves, axis=1)[:, None, :])


def _wave(parameter: tuple[str, str]) -> tuple[np.ufunc, int]:
    found = NAME.fullmatch(parameter[0])
    if found is None:
        raise InputError(f"encoder-error has no parameter {parameter[0]}")
    return WAVES[found[1]], int(found[2])


def of_cycles(most: int) -> Term:
    """An error of up to so many cycles a turn."""
    return Term(kernel, tuple((f"{wave}{cycles}_deg", "deg") for cycles in range(1, most + 1) for wave in WAVES))


def candidates(run: Run) -> list[Term]:
    """One cycle a turn, and two, where the platform turns beside a vector reference."""
    turning = any(s.kind == "rotation" and offers(run, s) == "vector" for s in run.segments)
    return [of_cycles(most) for most in range(1, MOST_CYCLES + 1)] if turning else []


FAMILY = Family(
    "encoder-error",
    "rig",
    kernel,
    candidates,
    phrase="the platform reads its angle wrong",
    experiment="turn the device by 90° on the platform and repeat: what the platform reads wrong stays at its angles",
    confounded=(ERROR_OR_FIELD,),
    drawn_against="angle",
)
