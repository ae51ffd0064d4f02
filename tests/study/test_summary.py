"""What is said of rows, made up so that the answer is known; rows without a result among them."""

from __future__ import annotations

from typing import Any

from labcal.study.job import Job, Row
from labcal.study.page import cell_text, heading
from labcal.study.specification import Blind, Design, FleetStudy, MonteCarlo
from labcal.study.summary import Summary, summarise

FAILED: Row = {"why_not": "the supply is silent"}


def summary(study: Any, rows: list[tuple[str, Row]]) -> Summary:
    seeds = list(range(len(rows)))
    jobs = [Job(study.kind, {}, {"point": point, "seed": seed}) for (point, _), seed in zip(rows, seeds, strict=True)]
    return summarise(study, jobs, [row for _, row in rows])


def trial(error: float, lab_s: float) -> Row:
    return {"why_not": "", "lab_s": lab_s, "direction_error_deg": error, "direction_U_deg": 0.1,
            "magnitude_error_nT": 5}  # fmt: skip


def test_the_quickest_point_that_is_accurate_enough_is_named() -> None:
    asked = MonteCarlo(format="labcal-study/1", kind="monte-carlo", accuracy_deg=0.1)
    rows = [("a", trial(0.3, 60.0)), ("b", trial(0.05, 600.0)), ("b", trial(0.15, 600.0)), ("c", trial(0.04, 900.0))]
    found = summary(asked, [*rows, ("d", trial(0.01, 120.0)), ("d", FAILED)])
    assert found.reached
    assert "point = c, 15 min" in found.answer  # a and b are not accurate enough, of d one run gave nothing
    assert [line["jobs"] for line in found.lines] == [1, 2, 1, 2]
    assert found.lines[1]["within_U_share"] == 0.5
    assert not summary(asked, rows[:1]).reached


def test_designs_are_told_by_the_choice_that_most_seeds_made() -> None:
    asked = Design(format="labcal-study/1", kind="design", accuracy_deg=0.1)
    good: Row = {"why_not": "", "rotations": "x; y", "lab_s": 600.0, "all_lab_s": 900.0, "direction_U_deg": 0.09}
    found = summary(asked, [("a", good), ("a", {**good, "rotations": "z"}), ("a", good), ("b", FAILED)])
    assert (found.lines[0]["rotations"], found.lines[0]["chosen_by"]) == ("x; y", 2)
    assert "point = a: x; y, 10.0 min (all: 15.0 min)." in found.answer
    assert "point = b: not by any choice." in found.answer
    assert not found.reached


def test_blind_trials_are_counted_and_a_wrong_name_is_a_negative_result() -> None:
    asked = Blind(format="labcal-study/1", kind="blind")
    rows = [("a", Row(found=word)) for word in ("right", "right", "missed")]
    assert summary(asked, rows).answer == "2 of 3 hidden effects were named and nothing else; 0 wrongly."
    assert summary(asked, rows).reached
    assert not summary(asked, [*rows, ("a", Row(found="wrong"))]).reached


def test_a_fleet_counts_what_moves_by_more_than_its_U() -> None:
    asked = FleetStudy(format="labcal-study/1", kind="fleet")
    rows = [("a", Row(why_not="", worst_change_U=-3.0, effects="lag", effects_before="")),
            ("b", Row(why_not="", worst_change_U=0.5, effects="", effects_before=""))]  # fmt: skip
    found = summary(asked, rows)
    assert found.answer == "1 of 2 calibrations would move by more than their U; the largest by 3.00 U."
    assert found.lines[0]["other_effects"] == 1
    assert found.reached
    assert not summary(asked, [*rows, ("c", FAILED)]).reached


def test_names_of_columns_and_numbers_are_for_people() -> None:
    assert heading("direction_error_95_deg") == "direction error 95 (deg)"
    assert heading("lab.twin.dut.noise_nT") == "lab.twin.dut.noise_nT"
    assert [cell_text(v) for v in (0.012345, 1234.5, 0.0, None, "x", 3)] == ["0.0123", "1\u202f234", "0", "–", "x", "3"]
