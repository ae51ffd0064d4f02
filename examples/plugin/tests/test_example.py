"""Each part keeps the promises of `labcal.testing`; what it is for is tested beside them."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from labcal_example.supply import ExampleSupply
from numpy.typing import NDArray

from labcal.bench.driver_kit.testing import scripted
from labcal.model.effects import Scene
from labcal.record import Channel
from labcal.testing import check_driver, check_effect, check_estimator, check_page, check_procedure

Array = NDArray[np.float64]


def test_the_supply() -> None:
    check_driver("example-supply", forbidden=[b"*RST\n", b"*SAV 1\n", b"*RCL 1\n"])


def test_the_supply_in_the_manuals_own_bytes() -> None:
    wire = [
        (b"CURR 0.5000\n", b""),
        (b"SYST:ERR?\n", b'0,"No error"\n'),
        (b"CURR?\n", b"0.5000\n"),
    ]
    with scripted(ExampleSupply, wire) as supply:
        supply.set_current(0.5)


def test_the_procedure() -> None:
    check_procedure("example-steps", {"top_nT": "20000"}, moments=3)


def load(t_s: Array) -> list[Channel]:
    """A load that draws now little, now much, either way."""
    return [Channel("i_load", "A", "current", 1.2 * np.sin(t_s / 7.3) + 0.6 * np.sign(np.sin(t_s / 31.0)))]


def core(scene: Scene, values: Mapping[str, float]) -> Array:
    """The same physics as the effect's, written apart from it."""
    up, down = (np.exp(sign * scene.channels["i_load"] / values["bend_A"]) for sign in (1, -1))
    return ((up - down) / (up + down))[:, None] * [values["c_x"], values["c_y"], values["c_z"]]


def test_the_effect() -> None:
    truth = {"c_x": 300.0, "c_y": -200.0, "c_z": 100.0, "bend_A": 0.4}
    check_effect("example-core", truth, core, channels=load)


def test_the_estimator() -> None:
    check_estimator("example-magnitudes", ["scalar"], seeds=12)


def test_the_page() -> None:
    check_page("Example DUTs")
