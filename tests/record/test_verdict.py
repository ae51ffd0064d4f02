"""The verdict of a measurement against its limit, at k = 2."""

from __future__ import annotations

import pytest

from labcal.record.stream import Measurement


@pytest.mark.parametrize(
    ("value", "u", "verdict"),
    [
        (8.0, 1.0, "PASS"),  # 8 + 2 is within 10
        (-8.0, 1.0, "PASS"),
        (8.1, 1.0, "MARGINAL"),
        (-12.0, 1.0, "MARGINAL"),  # 12 − 2 is not beyond 10
        (12.1, 1.0, "FAIL"),
        (-12.1, 1.0, "FAIL"),
        (0.0, 2.5, "PASS"),  # U is half the limit
        (0.0, 2.6, "CANNOT DECIDE"),
        (15.2, 2.6, "CANNOT DECIDE"),  # 10.0 is not beyond 10
        (15.3, 2.6, "FAIL"),  # however large U is: beyond the limit by more than that
        (-1e6, 1e5, "FAIL"),
        (0.0, float("inf"), "CANNOT DECIDE"),
        (0.0, float("nan"), "CANNOT DECIDE"),
        (float("nan"), 1.0, "CANNOT DECIDE"),
        (10.0, 0.0, "PASS"),
    ],
)
def test_a_value_is_judged_with_its_uncertainty(value: float, u: float, verdict: str) -> None:
    assert Measurement(0.0, "closure", value, u, "nT", 10.0).verdict == verdict


def test_without_a_limit_there_is_no_verdict() -> None:
    assert Measurement(0.0, "mean", 1.0, 0.1, "nT").verdict == ""
