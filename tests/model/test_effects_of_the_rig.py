"""Effects of the rig against the field they stand for, made without their formulas."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from labcal.model.effects.field_gradient import SYMMETRIC, kernel
from labcal.model.effects.protocol import Rig, Scene, Term


def turned(n: int, rng: np.random.Generator) -> Scene:
    """A device at n attitudes in fields of any size."""
    to_body, v = Rotation.random(n, random_state=rng).as_matrix(), 3e4 * rng.normal(size=(n, 3))
    p, nothing = np.einsum("nij,nj->ni", to_body, v), np.full(n, np.nan)
    axes = np.tile([0.0, 0.0, 1.0], (n, 1))
    rig = Rig(p, v, to_body, axes, axes, nothing, np.zeros(n, dtype=np.intp))
    return Scene(np.arange(n, dtype=float), np.zeros(n, dtype=np.intp), p, rig=rig)


def test_a_sensor_off_the_middle_of_the_device_is_carried_about_in_the_gradient() -> None:
    rng = np.random.default_rng(3)
    scene = turned(40, rng)
    assert scene.rig is not None
    gradient = rng.normal(size=(3, 3))
    gradient = gradient + gradient.T - np.eye(3) * 2 * np.trace(gradient) / 3  # free of curl and divergence
    place = rng.normal(size=3)
    there = np.array([R.T @ place for R in scene.rig.to_body])  # where it is in the cage
    cage = np.linalg.norm(scene.rig.reference_nT, axis=1)[:, None] * (there @ gradient)
    seen = np.array([R @ c for R, c in zip(scene.rig.to_body, cage, strict=True)])

    term = Term(kernel, tuple((f"g{w}_{a}", "1") for w in SYMMETRIC for a in "xyz"))
    beta = np.outer([gradient[at] for at in SYMMETRIC.values()], place).ravel()
    assert np.allclose(term.columns(scene) @ beta, seen)
