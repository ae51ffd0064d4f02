"""A run whose reference is declared a hundred times worse: the certificate's own rows follow."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import wrong_lab
from trials import as_run, calibrated
from wrong_lab import Declared

from labcal.certificate.report.budget import field_blocks
from labcal.model import Calibration

GOOD = Declared(scale_ppm=50.0, zero_nT=3.0)


@pytest.fixture(scope="module")
def certificates() -> dict[str, Calibration]:
    """The same recording: as it was declared, with the scale, and with the zero, a hundred times worse."""
    run = as_run(wrong_lab.record(8, GOOD, effect="offset-current", rows=24))
    stated = {"as declared": {}, "scale": {"u_scale_ppm": 5_000.0}, "zero": {"u_offset_nT": 300.0}}
    return {
        name: calibrated(replace(run, reference=replace(run.reference, **worse)), effect="offset-current")
        for name, worse in stated.items()
    }


def row(c: Calibration, quantity: str, at: str, source: str) -> Mapping[str, Any]:
    budget = next(b for b in c.budget if b["quantity"] == quantity and b["at"].startswith(at))
    return next(r for r in budget["rows"] if r["source"] == source)


def along(c: Calibration) -> list[float]:
    """U of the component along each of the first three points."""
    return [c.budget[3 * point + point]["U"] for point in range(3)]


def test_a_scale_s_row_is_a_hundred_times_larger_and_u_with_it(certificates: dict[str, Calibration]) -> None:
    good, bad = certificates["as declared"], certificates["scale"]
    before, after = (row(c, "b x", "50", "reference scale") for c in (good, bad))
    assert (before["u"], after["u"]) == (50.0, 5_000.0)
    assert after["sensitivity"] == pytest.approx(before["sensitivity"], rel=1e-3)
    assert after["sensitivity"] == pytest.approx(0.05, rel=0.02)  # nT per ppm of 50 µT
    assert after["share"] > 0.9 > before["share"]
    assert along(bad) == pytest.approx([2 * 250.0] * 3, rel=0.1)
    assert max(along(good)) < 60.0


def test_a_zero_s_row_is_a_hundred_times_larger_and_u_with_it(certificates: dict[str, Calibration]) -> None:
    good, bad = certificates["as declared"], certificates["zero"]
    for axis in "xyz":
        name = f"zero reading {axis}"
        parts = [
            np.linalg.norm([r["u"] * r["sensitivity"] for r in b["rows"] if r["source"].startswith("reference zero")])
            for b in itertools.chain.from_iterable(
                [one for one in c.budget if one["quantity"] == name] for c in (good, bad)
            )
        ]
        assert parts[1] == pytest.approx(100 * parts[0], rel=1e-3)
    assert min(along(bad)) > 4 * max(along(good))


def test_the_rows_on_paper_and_every_reading_follow(certificates: dict[str, Calibration]) -> None:
    shown = {name: field_blocks(c)[0].rows[0] for name, c in certificates.items()}
    U = {name: float(rows[1].replace("\u202f", "")) for name, rows in shown.items()}
    assert U["scale"] > 8 * U["as declared"]
    assert U["zero"] > 4 * U["as declared"]
    assert "reference scale" in shown["scale"][-1]
    assert "reference zero" in shown["zero"][-1]
    said = {n: c.apply([[50_000.0, 0.0, 0.0]], channels={"i_eps": [0.2]}).u_nT[0] for n, c in certificates.items()}
    assert said["scale"] > 4 * said["as declared"]
    assert said["zero"] > 4 * said["as declared"]
