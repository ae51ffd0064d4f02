"""Effects of the rig against the field they stand for, made without their formulas."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from labcal.model.effects import axis_tilt, encoder_error
from labcal.model.effects.field_gradient import SYMMETRIC, kernel
from labcal.model.effects.scene import Rig, Scene
from labcal.model.effects.term import Term


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


def on_a_platform(lean_deg: tuple[float, float], *, levelled: bool) -> tuple[Scene, np.ndarray]:
    """A device on a platform about z that leans, as it is declared; and what the lean adds to its field (n, 3).

    `levelled`: at angle zero the device stands as declared all the same.
    """
    rng = np.random.default_rng(5)
    angle, v = np.linspace(0, 2 * np.pi, 40), 3e4 * rng.normal(size=(40, 3))
    mounted = Rotation.random(random_state=rng)
    lean = Rotation.from_rotvec([*np.radians(lean_deg), 0.0])
    turns = Rotation.from_rotvec(np.outer(-angle, [0, 0, 1.0]))
    to_body = (mounted * turns).as_matrix()
    leaning = mounted * turns * lean.inv() if not levelled else mounted * lean * turns * lean.inv()
    p = np.einsum("nij,nj->ni", to_body, v)
    axis_body = np.tile(mounted.apply([0.0, 0.0, 1.0]), (40, 1))
    rig = Rig(p, v, to_body, axis_body, np.tile([0.0, 0.0, 1.0], (40, 1)), angle, np.zeros(40, dtype=np.intp))
    return Scene(angle, np.zeros(40, dtype=np.intp), p, rig=rig), leaning.apply(v) - p


def test_a_lean_of_degrees_is_held_to_second_order() -> None:
    scene, seen = on_a_platform((2.1, -1.4), levelled=False)
    names = ("cage_x", "cage_y", "cage_xx", "cage_xy", "cage_yy")
    columns = Term(axis_tilt.kernel, tuple((name, "") for name in names)).columns(scene)
    missed = seen - columns @ [2.1, -1.4, 2.1**2, -2.1 * 1.4, 1.4**2]
    assert np.abs(seen - columns[:, :, :2] @ [2.1, -1.4]).max() > 20.0
    assert np.abs(missed).max() < np.radians(2.6) ** 3 / 6 * np.linalg.norm(scene.field_nT, axis=1).max()


def test_a_spindle_that_leans_under_a_device_levelled_on_the_cage() -> None:
    scene, seen = on_a_platform((0.02, -0.01), levelled=True)
    columns = Term(axis_tilt.kernel, (("spindle_x", "deg"), ("spindle_y", "deg"))).columns(scene)
    assert np.abs(seen).max() > 10.0
    assert np.abs(seen - columns @ [0.02, -0.01]).max() < 0.02
    assert np.allclose((columns @ [0.02, -0.01])[0], 0.0)  # at angle zero


def test_an_angle_read_wrong_by_cycles_of_itself_turns_the_field_by_that() -> None:
    scene, _ = on_a_platform((0.0, 0.0), levelled=False)
    rig, small = scene.rig, 1e-4
    assert rig is not None
    read = rig.angle_rad
    error_deg = small * (3 * np.cos(read) - np.sin(read) + 2 * np.cos(2 * read) + 5 * np.sin(2 * read))
    more = Rotation.from_rotvec(-np.radians(error_deg)[:, None] * rig.axis_body)  # the body is that much further round
    term = encoder_error.of_cycles(2)
    seen = term.columns(scene) @ (small * np.array([3.0, -1.0, 2.0, 5.0]))
    assert np.allclose(seen, more.apply(rig.prediction_nT) - rig.prediction_nT, atol=1e-3)
    assert np.abs(seen).max() > 0.1
