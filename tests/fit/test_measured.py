"""Every method of the papers on measured and on other hands' runs: an answer with its uncertainty, or a reason."""

import numpy as np
import pytest

from labcal.fit import fit
from labcal.store.bundle import load_bundle

METHODS = ("centered", "centered-sequential", "twostep", "ekf", "ukf", "ukf-augmented", "foster-elkaim", "telemetry")
RUNS = ("av-mageval", "px4-battery-current", "practice/p01/bundle", "practice/p04/bundle", "practice/p05/bundle")


@pytest.mark.parametrize("name", RUNS)
@pytest.mark.parametrize("method", METHODS)
def test_an_answer_with_its_uncertainty_or_a_reason(shared, method, name):
    found = fit(load_bundle(shared / "data" / name).run(), method, holdout=False)
    if not found.ok:
        assert len(found.why_not) > 20
        assert found.affine is None
        return
    assert np.linalg.eigvalsh(found.covariance).min() > -1e-9 * np.abs(found.covariance).max()
    assert not found.frame_known
    assert found.rms_scalar_nT < 6000
    assert np.all(np.abs(np.linalg.eigvalsh(found.D)) < 0.5)
