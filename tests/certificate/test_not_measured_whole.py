"""A run that turns about one axis measures a part of the map: nobody approves the rest, and no paper gives it a U."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path
from unittest.mock import patch

import numpy as np
import pytest

import labcal
from labcal import session
from labcal.certificate import approve
from labcal.certificate.calibration_file import calibration_bytes
from labcal.certificate.report.calibration import calibration_page
from labcal.certificate.report.derived import sensor_figures
from labcal.cli import execute
from labcal.errors import InputError
from labcal.fit import draft_calibration
from labcal.loop import close_loop
from labcal.model import AffineMap, Calibration

EXAMPLE = "examples/short-preflight"
OFF_DIAGONAL = ("K_xy", "K_xz", "K_yx", "K_yz", "K_zx", "K_zy")


@pytest.fixture
def held(calibration: Calibration) -> Calibration:
    """One gain for all axes, as a run about one axis gives it: nothing off the diagonal varies."""
    variance = np.diag([1e-10, 0, 0, 0, 1e-10, 0, 0, 0, 1e-10, 4.0, 4.0, 4.0])
    gain = AffineMap(0.5 * np.eye(3), np.array([120.0, -8.0, 3.0]))
    return replace(
        calibration, affine=gain, covariance=variance, not_covered=("Unexplained by the closed loop: 9 nT are left.",)
    )


def test_a_loop_on_a_turn_about_one_axis_says_what_it_held_and_that_it_explains_nothing() -> None:
    run = labcal.load_run(f"{EXAMPLE}/run.zip")
    run = run.select(run.segment_index == int(np.argmax(np.bincount(run.segment_index))))
    closed = close_loop(run)
    assert (closed.base, closed.verdict) == ("gain-offset", "unexplained")
    made = draft_calibration(run, closed.fit(), "ab" * 32)
    assert made.metrics["after"]["holdout_rms_nT"] == closed.after.holdout_rms_nT  # what u_nT holds beside the noise
    assert made.not_measured() == OFF_DIAGONAL
    assert made.not_covered[0].startswith("Not measured by this run")
    assert "nT are left of held-out rows" in made.unexplained()


def test_nobody_approves_it(held: Calibration, tmp_path: Path) -> None:
    path = tmp_path / "cal.json"
    path.write_bytes(calibration_bytes(replace(held, approvers=())))
    before = path.read_bytes()
    with pytest.raises(InputError, match="did not measure K_xy, K_xz"):
        approve(path, "bob")
    assert path.read_bytes() == before


def test_signed_all_the_same_it_is_provisional_and_says_why(
    held: Calibration, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("LABCAL_PASSPHRASE", "correct horse")
    path = tmp_path / "cal.json"
    path.write_bytes(calibration_bytes(replace(held, approvers=())))
    for words in (["keys", "new", "--name", "ada"], ["sign", str(path), "--key", "ada"]):
        with patch.dict(os.environ):  # a command takes the passphrase out of it
            assert execute(words) == 0
    found = session.verify(path, only_kept=True)
    assert found.status == "provisional"
    said = " ".join(found.sentences())
    assert "did not measure K_xy" in said
    assert "Unexplained by the closed loop" in said


def test_its_paper_gives_no_uncertainty_to_what_was_held(held: Calibration, tmp_path: Path) -> None:
    path = tmp_path / "cal.json"
    path.write_bytes(calibration_bytes(held))
    page = calibration_page(held, session.verify(path, only_kept=True), "checked")
    assert {mark.word for mark in page.marks} >= {"NOT MEASURED WHOLE", "UNEXPLAINED"}
    angles = [row[-1] for row in sensor_figures(held, 2.0).rows]
    assert angles == ["not measured"] * 3


def test_a_whole_map_is_approved_as_before(calibration: Calibration) -> None:
    assert calibration.not_measured() == ()
    assert replace(calibration, covariance=None).not_measured() == ()
    assert not calibration.unexplained()
