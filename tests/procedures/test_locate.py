"""Places in the cage against the twin's: within what is stated, for both sensors, by three coils' halves and by one."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from labcal.testing import check_procedure
from labcal.twin import open_twin

Run = Callable[..., Any]
ALL = 'halves = ["x", "y", "z"]'
U_SIZE_M, U_HALVES = 0.005, 0.002  # what is taken where bench.toml states none


def halves(names: str) -> tuple[str, str]:
    return ALL, f"halves = {list(names)}"


def lab(seed: int) -> tuple[str, np.ndarray, np.ndarray]:
    """The table [twin] of a lab with sensors somewhere and coils that err by what bench.toml declares; both places."""
    rng = np.random.default_rng([seed, 5])
    dut, reference = 0.03 * rng.normal(size=3), np.array([0.0, 0.0, 0.15]) + 0.02 * rng.normal(size=3)
    side, imbalance = 1.5 + U_SIZE_M * rng.normal(), U_HALVES * rng.normal(size=3)
    coils = f"coils = {{ exact = true, side_m = {side}, imbalance = {imbalance.tolist()} }}"
    return f"dut_place_m = {dut.tolist()}\nreference_place_m = {reference.tolist()}\n{coils}", dut, reference


def z_of(found: Any, dut: np.ndarray, reference: np.ndarray) -> np.ndarray:
    """Errors (9,) of DUT, reference and their distance in units of their standard uncertainty."""
    data = found.event("locate").data
    places = [np.subtract(data["place_m"]["dut"], dut), np.subtract(data["place_m"]["reference"], reference)]
    apart = np.subtract(data["reference_from_dut_m"], reference - dut)
    u = [data["u_m"]["dut"], data["u_m"]["reference"], data["u_reference_from_dut_m"]]
    return np.concatenate([*places, apart]) / np.concatenate(u)


def z_of_the_coils(found: Any, twin: str, seed: int, dut: np.ndarray, reference: np.ndarray) -> np.ndarray:
    """Errors (3,) of how much more each coil makes at the reference than at the DUT, over their uncertainty."""
    coils = open_twin(tomllib.loads(twin), seed).coil_field
    there, here = (
        np.linalg.norm([coils.at(one[None], place)[0] for one in np.eye(3)], axis=1) for place in (reference, dut)
    )
    told = [found.measured[f"coil {axis}: field at the reference over that at the DUT"] for axis in "xyz"]
    true = 1e6 * (there / here - 1)
    return np.array([(one.value - is_) / one.u for one, is_ in zip(told, true, strict=True)])


@pytest.mark.parametrize("names", [pytest.param("xyz", marks=pytest.mark.slow), "z"])
def test_both_places_are_the_twins_within_what_is_stated(ran: Run, names: str) -> None:
    twin, dut, reference = lab(1)
    found = ran("locate", twin, 1, [halves(names)], dwell_s=1.0)
    z = z_of(found, dut, reference)
    assert np.abs(z).max() < 4, z
    assert np.abs(z_of_the_coils(found, twin, 1, dut, reference)).max() < 4
    assert max(found.event("locate").data["u_reference_from_dut_m"]) < (1e-3 if names == "xyz" else 3e-3)
    assert all(m.verdict in ("PASS", "") or "less what is stated" in m.name for m in found.measured.values())


def test_the_other_half_reversed_is_told(ran: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    from labcal.twin.coils import Wires

    twin, _, _ = lab(1)
    right = Wires.at
    monkeypatch.setattr(Wires, "at", lambda self, place, opposed: right(self, place, opposed) * (-1 if opposed else 1))
    found = ran("locate", twin, 1, [halves("xyz")], dwell_s=0.5)
    assert found.measured["less what is stated: z"].verdict == "FAIL"
    assert any("halves towards − had been reversed" in getattr(item, "text", "") for item in found.items)


NO_GEOMETRY = f"[cage.geometry] # how the pairs are wound: `locate` needs it\nsize_m = 1.5\n{ALL}", "#"


@pytest.mark.parametrize(("edit", "why"), [(NO_GEOMETRY, "state [cage.geometry] size_m"), (halves(""), "no coil's")])
def test_without_halves_it_is_refused_and_says_what_to_state(
    bench_file: Callable[..., Any], edit: tuple[str, str], why: str
) -> None:
    from labcal import session
    from labcal.errors import InputError

    fault = session.run("locate", bench_file("", edit), {}, seed=1).fault
    assert isinstance(fault, InputError)
    assert why in str(fault)


@pytest.mark.slow
def test_errors_over_fifty_labs_in_units_of_their_uncertainty(ran: Run) -> None:
    places, coils = list[np.ndarray](), list[np.ndarray]()
    for seed in range(50):
        found, one = ran("locate", lab(seed)[0], seed, [halves("xyz")], dwell_s=1.0), lab(seed)
        places.append(z_of(found, *one[1:]))
        coils.append(z_of_the_coils(found, one[0], seed, *one[1:]))
    for z in (np.array(places), np.array(coils)):
        within = float(np.mean(np.abs(z) < 2))
        print(f"rms z {np.round(np.sqrt(np.mean(z**2, axis=0)), 2)}, within U {within:.3f}")
        assert 0.75 < np.sqrt(np.mean(z**2)) < 1.25
        assert within > 0.88


@pytest.mark.parametrize("moments", [1, pytest.param(3, marks=pytest.mark.slow)])
def test_it_keeps_what_every_procedure_keeps(bench_file: Callable[..., Any], moments: int) -> None:
    check_procedure("locate", {"dwell_s": "0.5"}, bench=bench_file("", halves("xyz")), moments=moments)
