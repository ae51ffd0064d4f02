"""The field of finite coil pairs away from their centre: a field without sources, and that of real coils."""

from __future__ import annotations

import magpylib as magpy
import numpy as np
import pytest

from labcal.model.effects import iron, off_centre
from labcal.model.effects.off_centre import PAIRS, PAIRS_ASKEW, columns
from labcal.model.effects.protocol import Array, Rig

RADIUS_m = 0.6


def rig_at(places: Array, drives: Array) -> Rig:
    """A device at places of unit length: its lever is along x of the body, which is turned there."""
    across = np.cross(places, np.roll(places, 1, axis=1) + [0.3, 0.1, 0.2])
    across /= np.linalg.norm(across, axis=1)[:, None]
    to_body = np.stack([places, across, np.cross(places, across)], axis=1)
    n = len(places)
    nowhere = np.full((n, 3), np.nan)
    return Rig(drives, drives, to_body, nowhere, nowhere, np.full(n, np.nan), np.zeros(n, dtype=np.intp))


@pytest.fixture
def draw() -> np.random.Generator:
    return np.random.default_rng(3)


@pytest.mark.parametrize("degree", ["1", "2", "3", "4", "4s"])
def test_a_harmonic_has_no_divergence_and_no_curl(degree: str, draw: np.random.Generator) -> None:
    at, step = draw.normal(0, 0.5, 3), 1e-5
    for which in ("xx", "xy") if degree == "1" else "xyz":
        sides = [off_centre.harmonic(degree, which, at + sign * step * np.eye(3)) for sign in (1, -1)]
        slope = (sides[0] - sides[1]) / (2 * step)  # row i: the derivative by x_i
        assert abs(np.trace(slope)) < 1e-8 * np.abs(slope).max()
        assert np.abs(slope - slope.T).max() < 1e-8 * np.abs(slope).max()
        assert np.abs(slope).max() > 1e-3


def left_of_coils(names: off_centre.Names, square: bool, askew: bool = False, reach: float = 1 / 3) -> float:
    """The share of the rms that the parameters leave of three pairs' field at a third of their radius."""
    draw = np.random.default_rng(3)
    places = draw.normal(size=(400, 3))
    places /= np.linalg.norm(places, axis=1)[:, None]
    drives = draw.normal(0, 30000, (400, 3))
    seen = np.zeros((400, 3))
    for axis in range(3):
        here, centre = (field_of(axis, p, square, askew) for p in (RADIUS_m * reach * places, np.zeros((1, 3))))
        seen += drives[:, [axis]] * (here - centre) / centre[0, axis]
    rig = rig_at(places, drives)
    made = columns(names, 0.0, 0.0, 0.0, rig).reshape(1200, -1)
    left = seen.ravel() - made @ np.linalg.lstsq(made, seen.ravel(), rcond=None)[0]
    return float(np.linalg.norm(left) / np.linalg.norm(seen))


def field_of(axis: int, places: Array, square: bool, askew: bool) -> Array:
    """Of a Helmholtz pair along an axis of the cage."""
    turned = np.roll(places, 2 - axis, axis=1)
    corners = RADIUS_m * np.array([[1, 1, 0], [-1, 1, 0], [-1, -1, 0], [1, -1, 0], [1, 1, 0]])
    total = np.zeros_like(places)
    for sign in (-1, 1):
        size = 1.01 if askew and sign > 0 else 1.0
        half = (0.5445 if square else 0.5) * RADIUS_m
        coil = (
            magpy.current.Polyline(vertices=corners * size, current=1.0)
            if square
            else magpy.current.Circle(diameter=2 * RADIUS_m * size, current=1.0)
        )
        coil.position = (0, 0, sign * half)
        total += magpy.getB(coil, turned).reshape(-1, 3)
    return np.roll(total, axis - 2, axis=1)


def test_coils_are_followed_as_far_as_the_fourth_degree() -> None:
    straight = tuple(one for one in PAIRS if one[0][1] == "1")
    assert left_of_coils(straight, False) > 0.5
    assert left_of_coils(PAIRS, False) < 0.15
    assert left_of_coils(PAIRS, True) > 2 * left_of_coils(PAIRS_ASKEW, True)
    assert left_of_coils(PAIRS, False, askew=True, reach=1 / 8) > 2 * left_of_coils(
        PAIRS_ASKEW, False, askew=True, reach=1 / 8
    )


def test_without_a_common_zero_iron_on_the_table_is_of_one_form() -> None:
    assert {*iron.ALONG, *iron.ACROSS} == {*iron.ON_TABLE}
    assert [name for name, _ in iron.ALONG] == ["t_w", "tw_w"]
