"""A method that tells its sources apart states the covariance that they come to."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from labcal.fit import fit
from labcal.store import load_bundle

RUN = Path(__file__).parents[2] / "examples" / "short-preflight" / "run.zip"


@pytest.mark.parametrize("method", ["ml", "centered", "twostep", "telemetry"])
def test_sources_come_to_the_covariance(method: str) -> None:
    found = fit(load_bundle(RUN).run(), method, holdout=False)
    assert found.sources is not None
    assert np.allclose(found.sources.covariance, found.covariance, rtol=1e-9)
    assert {one.type for one in found.sources.declared} == {"B"}
    assert found.sources.noise.dof > 10
