"""A nonlinear parameter is searched, told and applied by its kind, whatever its name and whoever wrote the effect."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from labcal.model import AffineMap, Calibration, EffectRecord, Parameter, Validity
from labcal.model.apply import apply, apply_in_pieces, needed_columns
from labcal.model.effects import (
    ANGLE,
    DELAY,
    FREQUENCY,
    LEVEL,
    MOMENT,
    SCALE,
    THRESHOLD,
    TIME_CONSTANT,
    Family,
    Kind,
    Scene,
    Shape,
    Term,
    registry,
)
from labcal.model.effects.regressors import delayed, low_passed, on_each_axis, per_axis
from labcal.model.readings import Readings
from labcal.record import Dut

T_S = np.arange(0.0, 400.0, 2.0)
GRID = (10.0, 20.0, 50.0)
U_nT = 2.0  # of each parameter


@pytest.mark.parametrize(
    ("kind", "value", "between"),
    [
        (SCALE, 10.0, (10 / 3, 20.0)),
        (SCALE, 50.0, (20.0, 150.0)),
        (SCALE, -5.0, (-15.0, 10.0)),
        (TIME_CONSTANT, 20.0, (10.0, 50.0)),
        (THRESHOLD, 10.0, (10.0, 20.0)),
        (LEVEL, 0.0, (-10.0, 10.0)),
        (ANGLE, 20.0, (10.0, 30.0)),
        (DELAY, 20.0, (10.0, 30.0)),
        (FREQUENCY, 0.1, (0.1 - 0.6 / 398, 0.1 + 0.6 / 398)),
    ],
)
def test_each_kind_is_refined_in_a_bracket_of_its_own(kind: Kind, value: float, between: tuple[float, float]) -> None:
    assert Shape("any", value, "1", GRID, kind).bracket(T_S) == pytest.approx(between)


def test_a_derivative_is_taken_over_a_step_that_suits_the_kind() -> None:
    steps = {k.name: Shape("any", 20.0, "1", GRID, k).step(T_S) for k in (SCALE, LEVEL, DELAY, FREQUENCY)}
    assert steps == pytest.approx({"scale": 0.02, "level": 0.01, "delay": 0.1, "frequency": 1e-3 / 398})


def test_a_moment_lies_anywhere_between_two_rows() -> None:
    assert Shape("any", 101.0, "s", GRID, MOMENT).u(T_S, by_slope=9.0) == pytest.approx(2 / np.sqrt(12))
    assert Shape("any", 101.0, "s", GRID, SCALE).u(T_S, by_slope=9.0) == 9.0


Make = Callable[..., Calibration]


@pytest.fixture
def calibration(monkeypatch: pytest.MonkeyPatch) -> Make:
    """A calibration with an effect of somebody else's, whose one nonlinear parameter is called `hers`."""

    def make(
        kernel: Callable[[Term, Scene], np.ndarray], hers: Shape, u_hers: float = 1.0, **stated: object
    ) -> Calibration:
        family = Family("hers", "sensor", kernel, lambda run: [], shapes=(hers,), **stated)  # type: ignore[arg-type]
        monkeypatch.setattr(registry, "families", lambda: (family,))
        linear = tuple(Parameter(name, 100.0, U_nT, unit) for name, unit in per_axis("c", "nT"))
        record = EffectRecord(
            "hers", ("q",), {"q": 0.0}, "sensor", (*linear, Parameter("hers", hers.value, u_hers, "s"))
        )
        metrics = {"before": {}, "after": {"noise_nT": 10.0}}
        return Calibration(
            run_id="r", simulated=True, dut=Dut("S"), affine=AffineMap(np.eye(3), np.zeros(3)), covariance=None,
            frame_known=True, validity=Validity((1e4, 5e4)), span_s=(0.0, 400.0), run_sha256="0" * 64,
            effects=(record,), metrics=metrics,
        )  # fmt: skip

    return make


def _readings() -> Readings:
    field = 3e4 * np.column_stack([np.cos(T_S / 50), np.sin(T_S / 50), 0.1 * np.cos(T_S / 20)])
    segment = np.where(T_S < 200, "a", "b")
    return Readings(field, t_s=T_S, segment=segment, channels={"q": (np.mod(T_S, 60) < 25).astype(float)})


def _after(term: Term, scene: Scene) -> np.ndarray:
    return on_each_axis(term.drive(scene) * (scene.t_s >= term.at("hers")))


def _late(term: Term, scene: Scene) -> np.ndarray:
    return on_each_axis(delayed(scene.t_s, scene.segment, term.drive(scene), term.at("hers")))


def _slow(term: Term, scene: Scene) -> np.ndarray:
    return on_each_axis(low_passed(scene.t_s, scene.segment, term.drive(scene), term.at("hers"), scene.past))


def test_rows_beside_a_moment_are_flagged_and_less_certain_by_half_the_jump(calibration: Make) -> None:
    found = apply(calibration(_after, Shape("hers", 261.0, "s", kind=MOMENT)), _readings())
    beside = np.abs(T_S - 261.0) < np.sqrt(3) * 1.0
    assert [flag == "time" for flag in found.flags] == beside.tolist()
    assert found.u_nT[beside] == pytest.approx(np.hypot(np.hypot(10.0, 50.0), [0.0, U_nT]))  # 100 nT or none
    assert found.u_nT[~beside].max() < 11.0


def test_rows_whose_channel_is_not_known_so_much_earlier_are_less_certain(calibration: Make) -> None:
    found = apply(calibration(_late, Shape("hers", 7.0, "s", kind=DELAY), u_hers=0.0), _readings())
    unsure = found.u_nT > 20.0
    assert np.flatnonzero(unsure).tolist() == [*range(4), *range(100, 104)]


def test_where_a_late_channel_changes_an_uncertain_delay_is_in_the_uncertainty(calibration: Make) -> None:
    known, unknown = (
        apply(calibration(_late, Shape("hers", 7.0, "s", kind=DELAY), u_hers=u), _readings()).u_nT for u in (0.0, 0.5)
    )
    changing = unknown > known + 1.0
    assert 10 < changing.sum() < 20  # rows between which the load, seven seconds late, is switched
    assert unknown[changing] == pytest.approx(np.hypot(known[changing], 0.5 * 100 / 2), rel=0.02)


@pytest.mark.parametrize("in_pieces", [False, True])
def test_what_follows_behind_is_the_same_however_the_rows_are_cut(calibration: Make, in_pieces: bool) -> None:
    cal = calibration(_slow, Shape("hers", 12.0, "s", kind=TIME_CONSTANT), in_pieces=in_pieces)
    whole, pieces = apply(cal, _readings()), list(apply_in_pieces(cal, _readings(), 60))
    assert len(pieces) == (4 if in_pieces else 1)  # one that does not go on from where it was is given all at once
    assert np.allclose(np.concatenate([p.field_nT for p in pieces]), whole.field_nT, rtol=0, atol=1e-9)
    assert {"t_s", "segment"} <= set(needed_columns(cal))


def test_an_effect_with_modes_of_its_own_needs_them_and_flags_the_others(calibration: Make) -> None:
    cal = calibration(lambda term, scene: on_each_axis(term.drive(scene) * (scene.mode == "loud")),
                      Shape("hers", 1.0, "s"), modes=lambda term: ["loud"])  # fmt: skip
    mode = np.where(T_S < 100, "loud", np.where(T_S < 300, "", "strange"))
    assert "mode" in needed_columns(cal)
    found = apply(cal, replace(_readings(), mode=mode))
    assert [flag == "mode" for flag in found.flags] == (mode == "strange").tolist()


def test_the_temperature_that_a_range_speaks_of_is_that_of_the_effect_that_says_so(calibration: Make) -> None:
    cold = {"q": np.linspace(0.0, 1.0, len(T_S))}
    for said in (True, False):
        cal = calibration(_late, Shape("hers", 0.0, "s", kind=DELAY), of_temperature=said)
        cal = replace(cal, validity=Validity((1e4, 5e4), temperature_C=(0.0, 0.5)))
        flags = apply(cal, replace(_readings(), channels=cold)).flags
        assert [flag == "temperature" for flag in flags] == ((cold["q"] > 0.5) & said).tolist()
