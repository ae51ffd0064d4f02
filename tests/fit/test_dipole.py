"""Permanent and induced moment: against magpylib's dipole, and the stated uncertainty against the scatter."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from importlib import import_module
from typing import Any

import numpy as np
import pytest

from labcal.fit.dipole import PAIRS, Dwell, dipole_field, fit_dipole, newey_west
from labcal.geometry import rotation, shortest_rotation

PERMANENT = np.array([0.02, -0.01, 0.03])
INDUCED = np.array([[30.0, 8, -5], [8, 50, 6], [-5, 6, 20]])
PLACES = np.array([[0.0, 0.0, 0.15], [0.0, 0.0, 0.25]])
FIELD = 50_000.0 * np.array([1.0, 0.0, 1.0]) / np.sqrt(2)
COILS = np.array([[0.0, 0.002, 0.0], [0.001, 0.0, 0.003], [0.004, 0.0, -0.01]])  # at the places, of the field


def seen(seed: int, noise_nT: float, mountings: str = "zx") -> list[Dwell]:
    rng = np.random.default_rng(seed)
    looks = noiseless(mountings)
    return [replace(k, seen_nT=k.seen_nT + noise_nT * rng.normal(size=k.seen_nT.shape)) for k in looks]


@cache
def noiseless(mountings: str) -> list[Dwell]:
    """At rest with the body and without, the field to and fro; and turning there and back, at two places."""
    looks = list[Dwell]()
    for place in range(2):
        for mounting in ("", *mountings):
            still = shortest_rotation([0, 0, 1], np.eye(3)["xyz".index(mounting)]).T if mounting else None
            session = len(looks)
            looks += [look(session, place, s * FIELD, still, 6.0 * k) for k, s in enumerate((1, -1, 1, -1))]
            turns = (1, -1) if mounting else ()
            looks += [look(len(looks) + k, place, s * FIELD, still, 0.0, 360.0) for k, s in enumerate(turns)]
    return looks


def look(session: int, place: int, b: np.ndarray, still: Any, begins_s: float, turn_deg: float = 0.0) -> Dwell:
    t = np.arange(0.0, 18.0 if turn_deg else 4.0, 0.2)
    field = np.tile(np.array([3.0, -2.0, 5.0]) + COILS @ b, (len(t), 1))
    if still is None:
        return Dwell(session, place, begins_s + t, field, b, None)
    turned = rotation([0.0, 0.0, 1.0], np.radians(turn_deg * t / t[-1])) @ still
    moment = np.einsum("nij,nj->ni", turned, PERMANENT + 1e-9 * np.einsum("nji,j->ni", turned, b) @ INDUCED)
    magpylib: Any = import_module("magpylib")
    dipole = magpylib.getB([magpylib.misc.Dipole(moment=m) for m in moment], PLACES[place])
    return Dwell(session, place, begins_s + t, field + 1e9 * dipole, b, turned)


def parameters(found: Any) -> np.ndarray:
    return np.concatenate([found.permanent_Am2, [found.induced_Am2_per_T[pair] for pair in PAIRS]])


TRUE = np.concatenate([PERMANENT, [INDUCED[pair] for pair in PAIRS]])


def test_the_moment_is_found_exactly_where_nothing_is_noisy() -> None:
    found = fit_dipole(seen(1, 0.0), PLACES)
    assert parameters(found) == pytest.approx(TRUE, rel=1e-6)


def test_the_stated_uncertainty_is_the_scatter() -> None:
    fits = [fit_dipole(seen(seed, 3.0), PLACES) for seed in range(12)]
    errors = np.array([(parameters(fit) - TRUE) / fit.u for fit in fits])
    assert 0.85 < np.sqrt(np.mean(errors**2)) < 1.2


def test_a_reference_that_stands_beside_its_place_is_within_the_uncertainty_stated_for_it() -> None:
    looks, exact = seen(1, 0.0), PLACES
    wrong = [fit_dipole(looks, exact + np.random.default_rng(k).normal(0, 1e-3, (2, 3)), 1e-3) for k in range(12)]
    errors = np.array([(parameters(f) - TRUE) / f.u for f in wrong])
    assert 0.7 < np.sqrt(np.mean(errors**2)) < 1.3


def test_the_moment_is_as_uncertain_as_the_scale_of_the_sensor_that_saw_it() -> None:
    """Seen by a sensor that reads 1 % too much, all of it is 1 % larger."""
    looks = seen(1, 0.0)
    here = fit_dipole(looks, PLACES, 0.0)
    there = fit_dipole([replace(k, seen_nT=1.01 * k.seen_nT) for k in looks], PLACES, 0.0)
    moved = np.r_[
        there.permanent_Am2 - here.permanent_Am2,
        [(there.induced_Am2_per_T - here.induced_Am2_per_T)[i, j] for i, j in PAIRS],
    ]
    wider = here.with_scale(0.01).covariance - here.covariance
    assert np.sqrt(np.diag(wider)) == pytest.approx(np.abs(moved), rel=1e-3)


def test_one_mounting_does_not_determine_the_moment() -> None:
    with pytest.raises(ValueError, match="do not determine"):
        fit_dipole(seen(1, 1.0, "z"), PLACES)


def test_the_largest_induced_moment_is_that_of_the_softest_axis() -> None:
    found = fit_dipole(seen(2, 1.0), PLACES)
    value, u = found.largest_induced_Am2(50_000.0)
    assert value == pytest.approx(5e-5 * np.linalg.eigvalsh(INDUCED).max(), abs=4 * u)


def test_correlated_rows_count_less_than_independent_ones() -> None:
    white = np.random.default_rng(3).normal(size=(20_000, 1))
    assert newey_west(white, 50)[0, 0] == pytest.approx(20_000, rel=0.2)
    blurred = np.convolve(white[:, 0], np.ones(10), "same")[:, None]
    assert newey_west(blurred, 100)[0, 0] == pytest.approx(100 * 20_000, rel=0.25)


def test_the_field_of_a_moment_above_and_beside_it() -> None:
    assert dipole_field([0, 0, 1.0]) @ [0, 0, 1.0] == pytest.approx([0, 0, 200.0])
    assert dipole_field([1.0, 0, 0]) @ [0, 0, 1.0] == pytest.approx([0, 0, -100.0])
