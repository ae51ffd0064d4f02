from dataclasses import replace

import made_up_runs as lab
import numpy as np
import pytest

from labcal.errors import InputError
from labcal.fit import fit
from labcal.fit.scalar import telemetry
from labcal.model.effects import load
from labcal.model.effects.scene import Scene

E = np.array([[1200.0, -400.0, 300.0], [200.0, 900.0, -700.0], [-3000.0, 1500.0, 800.0]])  # nT/A


def housekeeping(n):
    random = np.random.default_rng(5)
    panel = np.sin(np.arange(n) / 50.0) ** 2
    return {"i_panel": panel, "i_load": random.uniform(0, 1, n), "i_radio": 0.3 * (np.arange(n) % 20 < 2)}


def run_with_currents(seed, *, n=1000, noise=25.0):
    field, current = lab.tumbling(1, n), housekeeping(n)
    seen = field + np.column_stack(list(current.values())) @ E
    channels = tuple(lab.current(name, values) for name, values in current.items())
    run = lab.run_of(seen, seed, noise=noise, channels=channels)
    return replace(run, reference_magnitude=np.linalg.norm(field, axis=1))


def test_currents_are_found_within_their_uncertainty():
    found = fit(run_with_currents(0), "telemetry")
    assert [e.channels for e in found.effects] == [("i_panel",), ("i_load",), ("i_radio",)]
    for effect, truth in zip(found.effects, E, strict=True):
        assert effect.effect == "offset-current"
        assert [p.unit for p in effect.parameters] == ["nT/A"] * 3
        for parameter, value in zip(effect.parameters, truth, strict=True):
            assert parameter.value == pytest.approx(value, abs=4 * parameter.u)
    assert found.noise_nT == pytest.approx(25.0, rel=0.1)
    assert found.rms_scalar_nT == pytest.approx(25.0, rel=0.1)
    assert found.holdout_rms_scalar_nT == pytest.approx(25.0, rel=0.1)


def test_the_effects_correct_the_field_as_a_calibration_applies_them():
    run = run_with_currents(1, noise=0.01)
    found = fit(run, "telemetry", holdout=False)
    a = found.affine.apply(run.reading)
    scene = Scene(run.t_s, run.segment_index, a, {c.name: c.values for c in run.channels})
    b = a - sum(load(e).predict(scene) for e in found.effects)
    np.testing.assert_allclose(b, lab.tumbling(1), atol=0.5)


def test_without_channels_it_is_the_nonlinear_form():
    run = lab.run_of(lab.tumbling(2), 2)
    plain, bare = fit(run, "foster-elkaim"), fit(run, "telemetry", channels=[])
    np.testing.assert_allclose(bare.affine.parameters, plain.affine.parameters, rtol=1e-6, atol=1e-9)
    np.testing.assert_allclose(np.diag(bare.covariance), np.diag(plain.covariance), rtol=1e-3)


def test_slopes_are_the_numerical_derivatives():
    run = run_with_currents(3)
    current = np.column_stack(list(housekeeping(1000).values()))
    rows = telemetry.ScaledRows(run.reading / 4e4, run.reference_magnitude / 4e4, current, 1e-6 * np.eye(3), 0.0)
    q = np.random.default_rng(0).normal(0, 0.05, 18)

    def square(at, reading=rows.reading):
        field = replace(rows, reading=reading).field(at)[1]
        return np.sum(field**2, axis=1)

    slope, by_reading = rows.slopes(*rows.field(q))
    step = 1e-6 * np.eye(18)
    np.testing.assert_allclose(slope, np.column_stack([square(q + s) - square(q - s) for s in step]) / 2e-6, atol=1e-8)
    for axis, e in enumerate(1e-4 * np.eye(3)):
        up, down = (
            [square(q + s, rows.reading + sign * e) - square(q - s, rows.reading + sign * e) for s in step]
            for sign in (1, -1)
        )
        mixed = (np.array(up) - np.array(down)).T / 2e-6 / 2e-4
        np.testing.assert_allclose(by_reading[axis], mixed, atol=1e-5)


def test_dependent_currents_are_refused_by_name():
    run = run_with_currents(4)
    panel, load_, radio = run.channels
    total = lab.current("i_total", panel.values + 2 * radio.values + 0.5)
    found = fit(replace(run, channels=(*run.channels, total)), "telemetry")
    assert not found.ok
    assert found.why_not.startswith("the currents i_panel, i_radio, i_total are linearly dependent")
    still = fit(replace(run, channels=(load_, lab.current("i_still", np.full(1000, 0.2)))), "telemetry")
    assert not still.ok
    assert "i_still never changes" in still.why_not


def test_the_channels_option_limits_and_checks_the_currents():
    run = run_with_currents(5)
    found = fit(run, "telemetry", channels=["i_load"], holdout=False)
    assert [e.channels for e in found.effects] == [("i_load",)]
    with pytest.raises(InputError, match=r"no channel 'i_x'; it has i_panel, i_load, i_radio"):
        fit(run, "telemetry", channels=["i_x"])
    warm = replace(run, channels=(replace(run.channels[0], quantity="temperature"),))
    with pytest.raises(InputError, match="no current"):
        fit(warm, "telemetry", channels=["i_panel"])


def test_rows_without_a_current_are_left_out():
    run = run_with_currents(6)
    gaps = run.channels[0].values.copy()
    gaps[::7] = np.nan
    found = fit(replace(run, channels=(replace(run.channels[0], values=gaps), *run.channels[1:])), "telemetry")
    assert found.ok
    assert found.noise_nT == pytest.approx(25.0, rel=0.1)


def test_the_answer_scales_with_the_unit_of_the_current():
    run = run_with_currents(7)
    milli = tuple(replace(c, values=c.values * 1e3, unit="mA") for c in run.channels)
    plain, scaled = fit(run, "telemetry", holdout=False), fit(replace(run, channels=milli), "telemetry", holdout=False)
    for a, b in zip(plain.effects, scaled.effects, strict=True):
        np.testing.assert_allclose([p.value for p in b.parameters], [p.value * 1e-3 for p in a.parameters], rtol=1e-6)
        assert {p.unit for p in b.parameters} == {"nT/mA"}
