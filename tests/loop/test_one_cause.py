"""Any cause can be looked at on its own, also one that the loop did not name."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from labcal import session
from labcal.errors import InputError
from labcal.loop import OneCause


def fall(found: OneCause) -> float:
    before, after = (np.nanmean(part**2) for part in (found.pictures.before_nT, found.pictures.after_nT))
    return float(1 - after / before)


def test_the_true_cause_takes_most_of_the_residual_another_little_and_an_absent_one_is_refused(shared: Path) -> None:
    run = str(shared / "data" / "practice" / "p02" / "bundle")
    named = session.one_cause(run, "offset-current", ("hk01",))
    assert fall(named) > 0.5
    assert all(p.u > 0 for p in named.parameters)
    assert fall(session.one_cause(run, "hysteresis", ())) < 0.3 * fall(named)
    with pytest.raises(InputError, match="nothing to show"):
        session.one_cause(run, "offset-current", ("no_such_channel",))
