"""`check_effect` and its parts fail for an effect that breaks what each is about, and say what to do."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any, cast

import numpy as np
import pytest

from labcal.fit import Fit, draft_calibration
from labcal.model import EffectRecord, Parameter
from labcal.model.effects import SCALE, TIME_CONSTANT, Family, Kind, Scene, Shape, Term, family
from labcal.model.effects.regressors import on_each_axis, per_axis
from labcal.record import Channel, Run
from labcal.testing import check_effect
from labcal.testing.effects import (
    EffectTrial,
    check_applied,
    check_derivative,
    check_found,
    check_left_where_it_is_not,
    check_memory,
)
from labcal.testing.made_up_runs import made_up_run


def late(run: Run) -> list[Term]:
    """A drift that begins in the middle of the run."""
    return [Term(right, per_axis("c", "nT/s"))]


def right(term: Term, scene: Scene) -> np.ndarray:
    return on_each_axis(np.maximum(scene.t_s - 100.0, 0.0))


def formula(scene: Scene, values: Mapping[str, float]) -> np.ndarray:
    return np.maximum(scene.t_s - 100.0, 0.0)[:, None] * [values["c_x"], values["c_y"], values["c_z"]]


def trial(kernel: Callable[..., np.ndarray], size: float = 1.0) -> EffectTrial:
    def candidates(run: Run) -> list[Term]:
        return [replace(term, kernel=kernel) for term in late(run)]

    truth = {"c_x": size, "c_y": -size, "c_z": size}
    return EffectTrial(Family("offset-drift", "sensor", kernel, candidates), made_up_run(rows=50), truth, formula)


@pytest.mark.parametrize(
    "wrong",
    [
        lambda term, scene: -right(term, scene),
        lambda term, scene: 1e3 * right(term, scene),
        lambda term, scene: np.roll(right(term, scene), 1, axis=2),
        lambda term, scene: right(term, scene) + 1e-3,
    ],
)
def test_an_effect_with_a_wrong_derivative(wrong: Callable[..., np.ndarray]) -> None:
    check_derivative(trial(right))
    with pytest.raises(AssertionError, match=r"column c_x \[nT/s\] .* is not the derivative of the formula"):
        check_derivative(trial(wrong))


WARM = "temp_dut"


def warmed(t_s: np.ndarray) -> list[Channel]:
    """At rest for a while, then up and down."""
    return [Channel(WARM, "degC", "temperature", 20 - 4 * np.cos(np.maximum(t_s - 20.0, 0.0) / 9))]


def behind(tau_s: float, scene: Scene) -> np.ndarray:
    """A first-order response that begins at its drive in the first row, whatever went before."""
    q, keep = [scene.channels[WARM][0]], np.exp(-np.maximum(np.diff(scene.t_s), 0.0) / tau_s)
    for kept, now in zip(keep, scene.channels[WARM][1:], strict=True):
        q.append(kept * q[-1] + (1 - kept) * now)
    return np.array(q) - 20.0


def responding(kind: Kind, **more: Any) -> EffectTrial:
    """An effect that remembers, with what its family says of that."""
    tau = Shape("tau_s", 5.0, "s", (5.0,), kind)

    def kernel(term: Term, scene: Scene) -> np.ndarray:
        return on_each_axis(behind(term.at("tau_s"), scene))

    def candidates(run: Run) -> list[Term]:
        return [Term(kernel, per_axis("c", "nT/degC"), (WARM,), {WARM: 20.0}, (tau,))]

    made = made_up_run(rows=50)
    made = replace(made, run=replace(made.run, channels=tuple(warmed(made.run.t_s))))
    truth = {"c_x": 80.0, "c_y": -60.0, "c_z": 50.0, "tau_s": 5.0}
    return EffectTrial(Family("slow", "sensor", kernel, candidates, shapes=(tau,), **more), made, truth, formula)


def test_an_effect_that_remembers_and_does_not_say_so() -> None:
    check_memory(responding(TIME_CONSTANT))
    check_memory(responding(SCALE, reach_s=lambda term: 0.0))
    with pytest.raises(
        AssertionError, match=r"looks at other rows, and does not say so\. A shape of the kind TIME_CON"
    ):
        check_memory(responding(SCALE))


def test_an_effect_that_does_not_go_on_where_a_recording_is_cut(monkeypatch: pytest.MonkeyPatch) -> None:
    def applied(trial: EffectTrial) -> None:
        monkeypatch.setattr("labcal.model.effects.registry.families", lambda: (trial.family,))
        run, map_ = trial.made.run, trial.made.true
        effect = trial.term().columns(trial.scene) @ [80.0, -60.0, 50.0]
        values = tuple(Parameter(name, value, 1e-3, "") for name, value in trial.truth.items())
        record = EffectRecord("slow", (WARM,), {WARM: 20.0}, "sensor", values)
        fit = Fit("true", ok=True, affine=map_, covariance=np.eye(12) * 1e-12, frame_known=True, effects=(record,))
        check_applied(trial, trial.made.with_effect(effect), draft_calibration(run, fit, "0" * 64))

    applied(responding(TIME_CONSTANT))
    with pytest.raises(
        AssertionError, match=r"comes in 3 pieces\. With in_pieces its kernel goes on from `scene\.past`"
    ):
        applied(responding(TIME_CONSTANT, in_pieces=True))


@pytest.mark.parametrize(
    ("wrong", "says"),
    [
        (lambda scene, values: formula(scene, values)[:, 0], r"gives an array of shape \(300,\), not \(rows, 3\)"),
        (
            lambda scene, values: formula(scene, {"c": 1.0}),
            r"asks for 'c_x'; there are: channels none; values c_x, c_y",
        ),
    ],
)
def test_a_formula_that_is_not_whole(wrong: Any, says: str) -> None:
    with pytest.raises(AssertionError, match=says):
        check_derivative(replace(trial(right), formula=wrong))


def test_channels_that_are_no_list_and_those_that_an_effect_does_not_follow() -> None:
    (temp,) = warmed(np.arange(300) * 0.5)
    with pytest.raises(AssertionError, match=r"`channels` has to give a list of labcal\.record\.Channel"):
        check_effect("offset-current", {}, formula, channels=lambda t_s: cast(Any, temp), rows=50)
    with pytest.raises(AssertionError, match=r"the channels temp_dut \(temperature, role dut, 300 rows\): which does"):
        check_effect("offset-current", {}, formula, channels=[temp], rows=50)


def test_an_effect_that_is_not_found_where_it_is() -> None:
    with pytest.raises(AssertionError, match=r"is clean by nothing: is `truth` large beside the noise"):
        check_found(trial(right, 1e-4))


def test_an_effect_that_is_named_where_it_is_not() -> None:
    made = made_up_run(rows=40)
    t_s = made.run.t_s
    warm = Channel("temp", "degC", "temperature", 20 + 5 * np.sin(t_s / 9))
    run = made.with_effect((warm.values - 20)[:, None] * [40.0, -30.0, 20.0])
    spoilt = replace(made, run=replace(run, channels=(warm,)))
    with pytest.raises(AssertionError, match="'offset-temperature' is named in a run that has not got it"):
        check_left_where_it_is_not(EffectTrial(family("offset-temperature"), spoilt, {}, formula))
