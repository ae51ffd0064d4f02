"""Our own procedures, effects and estimators, held to what `labcal.testing` asks of others'."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pytest

from labcal.model.effects import Scene
from labcal.record import Channel
from labcal.testing import check_effect, check_estimator, check_procedure


@pytest.mark.parametrize(
    ("name", "given"),
    [
        ("flip", {"dwell_s": "2"}),
        pytest.param("reverse", {}, marks=pytest.mark.slow),
        pytest.param("linearity", {}, marks=pytest.mark.slow),
        pytest.param("field-hold", {}, marks=pytest.mark.slow),
        pytest.param("rotate-axis", {}, marks=pytest.mark.slow),
    ],
)
def test_a_procedure_leaves_zero_by_every_way_out(name: str, given: Mapping[str, str]) -> None:
    check_procedure(name, given, moments=2)


def warming(t_s: np.ndarray) -> list[Channel]:
    return [Channel("temp_dut", "degC", "temperature", 20 + 6 * np.sin(t_s / 60) + np.sin(t_s / 11))]


def follows_temperature(scene: Scene, values: Mapping[str, float]) -> np.ndarray:
    return scene.channels["temp_dut"][:, None] * [values["c_x"], values["c_y"], values["c_z"]]


@pytest.mark.slow
def test_an_effect_is_found_where_it_is_and_comes_back_from_its_file() -> None:
    truth = {"c_x": 30.0, "c_y": -20.0, "c_z": 10.0}
    check_effect("offset-temperature", truth, follows_temperature, channels=warming, rows=60)


@pytest.mark.parametrize(
    ("name", "offers"),
    [
        ("centered", ["scalar"]),
        pytest.param("ml", ["vector", "axis", "scalar"], marks=pytest.mark.slow),
        pytest.param("twostep", ["scalar"], marks=pytest.mark.slow),
        pytest.param("foster-elkaim", ["scalar"], marks=pytest.mark.slow),
        pytest.param("centered-sequential", ["scalar"], marks=pytest.mark.slow),
        pytest.param("ekf", ["scalar"], marks=pytest.mark.slow),
        pytest.param("ukf", ["scalar"], marks=pytest.mark.slow),
        pytest.param("ukf-augmented", ["scalar"], marks=pytest.mark.slow),
        pytest.param("telemetry", ["scalar"], marks=pytest.mark.slow),
    ],
)
def test_an_estimator_keeps_its_contract(name: str, offers: list[str]) -> None:
    check_estimator(name, offers, seeds=12)
