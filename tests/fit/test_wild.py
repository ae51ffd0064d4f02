"""One number that no field made spoils nobody's fit; many of them have to show."""

from __future__ import annotations

from dataclasses import replace

import made_up_runs as lab
import numpy as np
import pytest

from labcal.fit import fit
from labcal.fit.draft import draft_calibration
from labcal.fit.wild import wild_rows
from labcal.record import Run


def with_wild(run: Run, value: float, rows: list[int]) -> Run:
    reading = run.reading.copy()
    reading[rows, 1] = value
    return replace(run, reading=reading)


@pytest.fixture(scope="module")
def clean() -> Run:
    return lab.run_of(lab.tumbling(1, 400), 1)


@pytest.mark.parametrize("value", [2_147_483_647.0, -2_147_483_648.0, 1e12, 1e29])
@pytest.mark.parametrize("method", ["ml", "twostep", "centered", "ukf"])
def test_a_reading_that_no_field_made_is_as_one_that_is_missing(clean: Run, value: float, method: str) -> None:
    rows = [17, 230]
    found = fit(with_wild(clean, value, rows), method)
    missing = fit(with_wild(clean, np.nan, rows), method)
    assert found.affine is not None
    assert missing.affine is not None
    assert np.array_equal(found.affine.K, missing.affine.K)
    assert found.rms_scalar_nT == missing.rms_scalar_nT
    assert found.holdout_rms_scalar_nT == missing.holdout_rms_scalar_nT


def test_the_draft_states_the_raw_residual_without_it(clean: Run) -> None:
    wild = with_wild(clean, 2_147_483_647.0, [17])
    stated = draft_calibration(wild, fit(wild), "00" * 32).metrics["before"]["rms_scalar_nT"]
    whole = draft_calibration(clean, fit(clean), "00" * 32).metrics["before"]["rms_scalar_nT"]
    assert stated == pytest.approx(whole, rel=0.05)


def test_what_a_large_offset_or_another_unit_makes_is_no_wild_reading(clean: Run) -> None:
    for reading in (clean.reading, clean.reading + [3e6, 0, 0], clean.reading * 1e3, clean.reading * 1e-3):
        assert not wild_rows(replace(clean, reading=reading)).any()


def test_where_many_are_wild_they_stay(clean: Run) -> None:
    many = with_wild(clean, 1e12, list(range(0, len(clean), 8)))
    assert not wild_rows(many).any()
    assert wild_rows(with_wild(clean, 1e12, [3])).sum() == 1
