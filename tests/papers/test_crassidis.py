import as_printed
import crassidis
import numpy as np
import pytest
from crassidis import batch, column, our_filter, over_phases, printed_filter

from labcal.fit.filters.ekf import EKF
from labcal.fit.filters.ukf import UKF, AugmentedUKF
from labcal.fit.scalar import centered, twostep

SEEDS = range(30)


def test_twostep_is_within_a_fifth_of_a_milligauss_of_the_truth():
    found = column(batch(twostep, unbiased=True), SEEDS)
    np.testing.assert_array_less(np.abs(found.mean - crassidis.TRUTH)[:3], 0.2)
    assert found.error_squared == pytest.approx(9, abs=3.3 * np.sqrt(18 / 30))


@pytest.mark.parametrize(("name", "module"), [("TWOSTEP", twostep), ("Centered", centered)])
@pytest.mark.parametrize("unbiased", [True, False])
def test_the_printed_batch_columns_lie_inside_our_scatter(name, module, unbiased):
    found = column(batch(module, unbiased=unbiased), SEEDS)
    rounding = np.repeat([5e-5, 5e-5], [3, 6])
    np.testing.assert_array_less(np.abs(np.array(crassidis.PRINTED[name][0]) - found.mean), found.deviation + rounding)


@pytest.mark.parametrize("unscented", [False, True])
@pytest.mark.parametrize("carried", [False, True])
def test_the_filters_as_printed_trust_themselves_beside_the_truth(unscented, carried):
    found = column(printed_filter(unscented=unscented, carried=carried), range(1))
    assert found.error_squared > 200


def test_the_printed_unscented_column_excludes_the_truth_that_it_was_made_from():
    mean, deviation = (np.array(v) for v in crassidis.PRINTED["UF"])
    assert abs(mean[4] - crassidis.TRUTH[4]) > 3 * deviation[4]


def test_the_printed_start_lies_far_from_the_truth():
    x, P = as_printed.start(carried=False)
    E22 = 2 * 0.1 + (crassidis.D @ crassidis.D)[1, 1]
    assert abs(x[4] - E22) / np.sqrt(P[4, 4]) == pytest.approx(6.8, abs=0.05)


def test_our_extended_filter_is_honest():
    found = column(our_filter(EKF), range(12))
    np.testing.assert_array_less(np.abs(found.mean - crassidis.TRUTH)[:3], 0.6)
    assert found.error_squared == pytest.approx(9, abs=3.3 * np.sqrt(18 / 12))


@pytest.mark.parametrize("kind", [UKF, AugmentedUKF])
def test_our_unscented_filters_end_at_twostep(kind):
    B, H = crassidis.readings(0)
    batch_estimate, found = twostep.estimate(B, H, crassidis.READING_NOISE), our_filter(kind)(B, H)
    u = np.sqrt(np.diag(batch_estimate.covariance))
    np.testing.assert_array_less(np.abs(found.theta - batch_estimate.theta), u)
    assert crassidis.error_squared(found) < 27.9  # the 99.9 % point of chi-squared with nine degrees of freedom


@pytest.mark.slow
@pytest.mark.parametrize("kind", [EKF, UKF, AugmentedUKF])
def test_our_filters_are_honest_over_thirty_seeds(kind):
    found = column(our_filter(kind), SEEDS)
    assert found.error_squared == pytest.approx(9, abs=3.3 * np.sqrt(18 / 30))


@pytest.mark.slow
def test_our_unscented_filter_ends_within_twosteps_uncertainty_in_every_phase():
    distance, _ = over_phases(our_filter(UKF))
    assert np.abs(distance).max() < 1


@pytest.mark.slow
def test_the_unscented_filter_as_printed_swings_with_the_phase():
    distance, b1 = over_phases(printed_filter(unscented=True))
    assert np.ptp(b1) > 20
    assert np.sqrt(np.mean(distance**2)) > 10
