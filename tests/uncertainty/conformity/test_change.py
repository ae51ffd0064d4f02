"""As found and as left: E_n of two calibrations of one sensor, over many pairs and where the sensor did change."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy import stats

from labcal.fit import draft_calibration, fit
from labcal.model import AffineMap, Calibration
from labcal.testing.made_up_runs import TRUE_K, TRUE_k, made_up_run
from labcal.uncertainty.conformity import changes

PAIRS = 150


def calibration(seed: int, offers: str = "vector", moved_nT: float = 0.0, gain: float = 1.0) -> Calibration:
    made = made_up_run(offers=offers, seed=seed, rows=60, K=TRUE_K * gain, k=TRUE_k + [0.0, moved_nT, 0.0])
    found = fit(made.run, "ml", holdout=False)
    return replace(draft_calibration(made.run, found, "0" * 64), run_id=f"run-{seed}")


@pytest.mark.parametrize("offers", ["vector", pytest.param("scalar", marks=pytest.mark.slow)])
def test_a_sensor_that_did_not_change_differs_by_its_uncertainty(offers: str):
    """2 E_n, differences over their standard uncertainty, have the mean square one, by every kind of figure."""
    true, found = calibration(7, offers), dict[str, list[float]]()
    draws = np.random.default_rng(8).multivariate_normal(true.affine.parameters, true.covariance, 2 * PAIRS)
    drawn = [replace(true, affine=AffineMap.from_parameters(theta)) for theta in draws]
    for new, old in zip(drawn[::2], drawn[1::2], strict=True):
        for row in changes(new, old).rows:
            found.setdefault(row.quantity.split(" ")[0], []).append(2 * row.e_n)
            assert row.e_n == pytest.approx((row.left - row.found) / row.U)
    assert set(found) == {"offset", "scale", "non-orthogonality", "|b|"}
    for name, z in found.items():
        assert 0.85 < np.sqrt(np.mean(np.square(z))) < 1.15, name


def test_a_sensor_that_changed_is_said_to_have():
    found = changes(calibration(1, moved_nT=60.0, gain=1.004), calibration(2))
    rows = {row.quantity: row for row in found.rows}
    assert (found.found, found.left) == ("run-2", "run-1")
    for axis in "xyz":  # the scale factor is the length of K's inverse row, inverted
        assert rows[f"scale {axis}"].left - rows[f"scale {axis}"].found == pytest.approx(4000, rel=0.1)
        assert rows[f"scale {axis}"].changed
    assert rows["offset y"].left - rows["offset y"].found == pytest.approx(60 / 0.94, abs=25)
    assert rows["offset y"].changed
    assert not rows["non-orthogonality x-y"].changed
    # a sensor calibrated anew at 0.4 % more: the old calibration reads the largest field 0.4 % low
    strongest = max(row.left for row in found.rows if row.quantity.startswith("|b|"))
    assert rows["|b| at +x"].left - rows["|b| at +x"].found == pytest.approx(0.004 * strongest, rel=0.3)
    assert "of 15 figures changed by more than their uncertainty; the largest is E_n = " in found.in_words()


def test_few_degrees_of_freedom_behind_both_widen_the_difference():
    """Of six and of ten with one variance: Welch and Satterthwaite's 15, whose t of 97.725 % is 2.18."""
    one = replace(calibration(3), budget=())  # as if by infinitely many
    six, ten = (
        replace(one, budget=({"quantity": "zero reading x", "dof": dof, "U": 1.0, "k": 2.0},)) for dof in (6.0, 10.0)
    )
    few = {row.quantity: row for row in changes(six, ten).rows}
    many = {row.quantity: row for row in changes(one, one).rows}
    k = stats.t.ppf(0.97725, 4 / (1 / 6 + 1 / 10))
    ratios = [few[f"offset {axis}"].U / many[f"offset {axis}"].U for axis in "xy"]
    assert ratios == pytest.approx([k / 2, 1.0], rel=1e-6)
    assert few["offset x"].k == pytest.approx(k, rel=1e-6)


def test_the_same_calibration_twice_has_not_changed():
    one = calibration(3)
    found = changes(one, one)
    assert {row.e_n for row in found.rows} == {0.0}
    assert found.in_words().startswith("No figure changed by more than its uncertainty")


def test_what_cannot_be_compared_is_said():
    one, other = calibration(4), calibration(5)
    bare = changes(one, replace(other, covariance=None))
    assert {row.e_n for row in bare.rows} == {None}
    assert bare.in_words() == "Whether the sensor changed cannot be said: a calibration states no uncertainty."
    shifted = changes(replace(one, k_at={"i_eps": 0.05}), other)
    assert shifted.remarks == ("Offsets are not of the same state: as found at any state, as left at i_eps = 0.05.",)
    alike = [replace(c, k_at={"i_eps": 0.05}) for c in (one, other)]
    assert changes(*alike).remarks == ("Offsets are those at i_eps = 0.05.",)
    with pytest.raises(ValueError, match="is of S2, not of S1"):
        changes(one, replace(other, dut=replace(other.dut, serial="S2")))
    with pytest.raises(ValueError, match="has readings in counts of 4 nT, not in nT"):
        changes(one, replace(other, dut=replace(other.dut, unit="count", nominal_nT_per_unit=4.0)))
