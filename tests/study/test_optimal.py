"""The quickest choice of rotations: in the order of lab time, none left out, kept by a fit."""

from __future__ import annotations

import itertools
from dataclasses import replace

import numpy as np
import pytest

from labcal.fit import fit
from labcal.fit.vector.information import Information, information
from labcal.record import Dut, Reference, Run, Segment
from labcal.study.accuracy import direction_U_deg, sensitivities
from labcal.study.optimal import LabTime, quickest_first
from labcal.study.trials import part

FIELD = 50_000.0
TIME = LabTime(60.0, np.array([200.0, 210.0, 220.0]), np.array([90.0, 70.0, 95.0, 75.0, 80.0, 60.0]), np.arange(6) // 2)


@pytest.fixture(scope="module")
def turns() -> Run:
    """Two turns about each axis of a sensor of 15 nT, mounted within 0.02°, each axis from its own unknown angle."""
    draw, each = np.random.default_rng(8), 150
    segments, fields, refs, angles = [], [], [], []
    for number, (axis, size) in enumerate(itertools.product(range(3), (20e3, 50e3))):
        e, turn = np.eye(3)[axis], np.linspace(0, 2 * np.pi, each, endpoint=False)
        ref = size * np.array([0.766, 0.0, 0.643])
        across = np.roll(np.stack([np.cos(turn + axis), -np.sin(turn + axis), np.zeros(each)], 1), axis + 1, axis=1)
        fields.append(0.766 * size * across + ref[2] * e)
        refs.append(np.tile(ref, (each, 1)))
        angles.append(np.degrees(turn))
        segments.append(
            Segment(f"{'xyz'[axis]}{number % 2}", "rotation", axis_body=tuple(e), axis_cage=(0.0, 0.0, 1.0),
                    mounting="xyz"[axis], u_axis_body_deg=0.02)
        )  # fmt: skip
    field = np.concatenate(fields)
    return Run(
        run_id="turns", started_utc="2026-01-01T00:00:00Z", simulated=True, operator="",
        dut=Dut("s", "m", "nT", 1.0, 15.0), reference=Reference("vector", noise_nT=3.0, u_offset_nT=3.0),
        segments=tuple(segments), t_s=np.arange(len(field)) * 0.5, segment_index=np.repeat(np.arange(6), each),
        reading=1.02 * field + [300.0, -200.0, 100.0] + draw.normal(0, 15, field.shape),
        reference_vector=np.concatenate(refs), reference_magnitude=None, angle_deg=np.concatenate(angles),
        row_mode=None, channels=(),
    )  # fmt: skip


@pytest.fixture(scope="module")
def known(turns: Run) -> Information:
    return information(turns)


@pytest.mark.parametrize("names", ["111111", "101010", "011101", "110011"])
def test_the_covariance_of_a_part_is_that_of_a_fit_to_it(turns: Run, known: Information, names: str) -> None:
    chosen = np.array([name == "1" for name in names])
    found = fit(part(turns, chosen), holdout=False)
    promised = known.covariance(chosen[None])[0]
    assert found.ok
    assert found.covariance is not None
    ratio = np.sqrt(np.diag(promised) / np.diag(found.covariance))
    assert np.all((ratio > 0.85) & (ratio < 1.18)), ratio


def test_what_does_not_determine_a_map_is_infinitely_uncertain(turns: Run, known: Information) -> None:
    about_one_axis = np.array([True, True, False, False, False, False])
    assert not fit(part(turns, about_one_axis), holdout=False).ok
    assert np.isinf(np.diag(known.covariance(about_one_axis[None])[0])).all()


def test_every_choice_comes_once_the_quickest_first(known: Information) -> None:
    found = list(quickest_first(known, TIME, FIELD))
    assert len({tuple(chosen) for chosen, _, _ in found}) == len(found) == 2**6 - 1
    times = [lab_s for _, lab_s, _ in found]
    assert times == sorted(times)
    chosen, lab_s, _ = found[-1]
    assert chosen.all()
    assert lab_s == 60 + 630 + 470


def test_the_first_that_is_accurate_enough_is_the_quickest_there_is(known: Information) -> None:
    wanted, good = 0.12, dict[tuple[bool, ...], float]()
    for choice in itertools.product((False, True), repeat=6):
        chosen = np.array(choice)
        covariance = known.covariance(chosen[None])
        determined = np.isfinite(np.diag(covariance[0])).all()
        if determined and direction_U_deg(sensitivities(known.affine, FIELD), covariance)[0] <= wanted:
            turned = [g for g in range(3) if any(choice[2 * g : 2 * g + 2])]
            good[choice] = 60 + sum(200 + 10 * g for g in turned) + float(TIME.turn_s @ chosen)
    chosen, lab_s, U = next(one for one in quickest_first(known, TIME, FIELD) if one[2] <= wanted)
    assert 0 < len(good) < 63
    assert lab_s == pytest.approx(min(good.values()))
    assert tuple(chosen.tolist()) in good
    assert wanted >= U


def test_a_run_that_leaves_the_frame_open_has_no_design(turns: Run) -> None:
    free = tuple(Segment(s.id, "free") for s in turns.segments)
    scalar = replace(
        turns, reference=Reference("scalar"), reference_vector=None, angle_deg=None, segments=free,
        reference_magnitude=turns.magnitude_nT,
    )  # fmt: skip
    with pytest.raises(ValueError, match="rotation of the map open"):
        information(scalar)
