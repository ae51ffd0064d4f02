"""What another version states is held against a final fit in every number of it, so that none hides a forged one."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import asdict, replace
from math import inf
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import rfc8785

from labcal.certificate import parse_calibration
from labcal.certificate.between_versions import final_fit, with_held_out
from labcal.model import Calibration
from labcal.model.smooth import Basis
from labcal.record import Specification
from labcal.record.specification import Limit
from labcal.uncertainty.budget import Budget, Correlation, Row
from labcal.uncertainty.conformity import judge
from labcal.uncertainty.conformity.decision import Measured
from labcal.uncertainty.conformity.of_the_map import figures_of_the_map

EXAMPLE = Path(__file__).parents[2] / "examples" / "short-preflight" / "calibration.json"
Edit = Callable[[dict[str, Any]], object]


def smaller_block(c: dict[str, Any]) -> None:
    """The effects' part of the covariance, which `apply` takes its u from, beside the same u of each parameter."""
    for i, row in enumerate(c["covariance"]):
        for j in range(len(row)):
            row[j] /= 1e3 ** ((i >= 12) + (j >= 12))


def two_of_one_name(c: dict[str, Any]) -> None:
    """The smaller before the one that comes out again."""
    c["budget"].insert(0, c["budget"][0] | {"U": 0.001})


FORGERIES: list[tuple[Edit, str]] = [
    (smaller_block, "covariance[0][12]: "),
    (lambda c: c["effects"][0].update(domain=[]), "effects[0].domain: 0 of them"),
    (lambda c: c["effects"][0]["domain"][0]["hull"][1].__setitem__(0, 50.0), "effects[0].domain[0].hull[1][0]: 50 "),
    (lambda c: c.update(frame_known=False), "frame_known: false"),
    (lambda c: c["budget"][0].update(k=4.0), ".k: 4 "),
    (lambda c: c["budget"][0].update(dof=4.0), ".1 / dof: 0.25 "),
    (lambda c: c["budget"][0].update(unit="pT"), '.unit: "pT"'),
    (lambda c: c["budget"][0].update(rows=[]), ": none is stated, its run gives 3 of them"),
    (lambda c: c["budget"][0]["rows"][-1].update(source="Earth"), ".rows.Earth (A, normal, nT): 3 of them is "),
    (
        lambda c: c["budget"][3]["rows"][1].update(source="Earth"),
        ".rows.Earth (A, normal, nT): 3 of them is ",
    ),
    (lambda c: c["budget"][3]["rows"][1].update(unit="pT"), ".rows.noise of one reading (A, normal, pT): "),
    (lambda c: c["budget"][0]["rows"][-1].update(type="B"), ".rows.noise of one reading (B, normal, nT): "),
    (lambda c: c["budget"][0]["rows"][-1].update(u=0.1, sensitivity=149.5), ".u: 0.1 "),
    (
        lambda c: c["budget"][0].update(U=1.01 * c["budget"][0]["U"]),
        "budget[0].U: 32.2444 is stated, and 31.9249 ",
    ),
    (lambda c: c["budget"][0].update(k=1.01 * c["budget"][0]["k"]), "budget[0].U: 31.9251 is stated, "),
    (lambda c: smallest_row(c).update(sensitivity=1e-9), "].share: "),
    (lambda c: smallest_row(c).update(share=1e-4), "].share: 0.0001 is stated, and "),
    (lambda c: smallest_row(c).update(dof=2.0), ".k of dof: 4.52655 is stated, "),
    (lambda c: another_covariance(c, 0.85), "budget.b x at 50.04 µT along +x.U: "),
    (
        lambda c: less_of_one_combination(c, 0.7),
        "covariance: u of a combination, of K_zx for the most part, is 0.7 ",
    ),
    (lambda c: c["effects"][0]["parameters"][0].update(u=12.1), "].u: 12.1 is stated, and 12.0579 follows from "),
    (lambda c: c["budget"][0]["rows"][-1].update(share=0.1), ".share: 0.1 "),
    (two_of_one_name, "budget.b x at "),
    (lambda c: _correlated(c).update(correlations=[]), ".correlations."),
    (lambda c: _correlated(c)["correlations"][0].update(r=0.1), ".correlations."),
    (lambda c: _correlated(c)["correlations"][0].update(r=0.99), ".r: 0.99 is stated, and "),
    (lambda c: _correlated(c)["correlations"][0].update(r="x"), ".r: none is stated, and "),
    (lambda c: c["budget"][0]["correlations"].append({"one": "a", "other": "b", "r": 0.55}), " and none follows from "),
    (lambda c: c["effects"][0]["parameters"][0].update(unit="pT"), "effects[0].parameters[0].unit: "),
    (lambda c: c["metrics"]["after"].update(train_rms_nT=1.0), "metrics.after.train_rms_nT: 1 "),
    (lambda c: c["metrics"]["after"].pop("holdout_components"), "metrics.after.holdout_components: none is stated"),
    (lambda c: c["made_by"].update(method="by hand"), 'made_by.method: "by hand"'),
    (lambda c: c["specification"].append(JUDGED), "specification: 1 of them is stated"),
]
OFFSET = Specification(offset=Limit(5000.0, "nT"))
JUDGED = {"quantity": "residual", "value": 1.0, "U": 0.1, "limit": 5.0, "unit": "nT", "rule": "simple-acceptance",
          "result": "pass", "risk": 0.0, "tur": 9.0}  # fmt: skip


def smallest_row(c: dict[str, Any]) -> dict[str, Any]:
    """The row with the least part in the first entry of the budget."""
    least: dict[str, Any] = min(c["budget"][0]["rows"], key=lambda row: row["share"])
    return least


def another_covariance(c: dict[str, Any], factor: float) -> None:
    """Every u of the file times `factor`, all of it as a version would write it."""
    c["covariance"] = [[factor**2 * value for value in row] for row in c["covariance"]]
    for parameter in (p for effect in c["effects"] for p in effect["parameters"]):
        parameter["u"] *= factor
    for one in c["budget"]:
        one["U"] *= factor
        for row in one["rows"]:
            row["u"] *= factor


def less_of_one_combination(c: dict[str, Any], factor: float) -> None:
    """The u of the best known combination of parameters times `factor`: no element by a tenth of two u."""
    C = np.array(c["covariance"])
    r = C / (u := np.sqrt(np.outer(np.diag(C), np.diag(C))))
    variance, directions = np.linalg.eigh(r)
    least = np.outer(directions[:, 0], directions[:, 0])
    c["covariance"] = (u * (r + (factor**2 - 1) * variance[0] * least)).tolist()


def other_dof(c: dict[str, Any]) -> None:
    """The first entry of the budget with fewer degrees of freedom of its last row, as its writer has them."""
    one = c["budget"][0]
    rows = [Row(**{n: row[n] for n in row if n != "share"} | {"dof": row["dof"] or inf}) for row in one["rows"]]
    rows[-1] = replace(rows[-1], dof=40.0)
    pairs = tuple(Correlation(**pair) for pair in one["correlations"])
    c["budget"][0] = Budget(one["quantity"], one["at"], one["unit"], tuple(rows), pairs).as_json()
    assert c["budget"][0]["dof"] < 60


def _correlated(c: dict[str, Any]) -> dict[str, Any]:
    """A strong correlation's entry of the budget."""
    strong = (one for one in c["budget"] for pair in one["correlations"] if abs(pair["r"]) > 0.7)
    return next(strong)


@pytest.fixture(scope="module")
def made() -> Calibration:
    """The example's, as a final fit would give it: without the evidence of its effects."""
    found = parse_calibration(EXAMPLE.read_bytes())
    return replace(found, effects=tuple(replace(one, why="", rivals=(), p_value=None) for one in found.effects))


def forged(edit: Edit) -> Calibration:
    stated = json.loads(EXAMPLE.read_bytes())
    edit(stated)
    return parse_calibration(rfc8785.dumps(stated))


@pytest.mark.parametrize(
    ("edit", "field"),
    [pytest.param(*one, marks=pytest.mark.slow if n % 2 else ()) for n, one in enumerate(FORGERIES)],
)
def test_a_forged_number_of_another_version_is_named(made: Calibration, edit: Edit, field: str):
    found = final_fit(forged(edit), made)
    assert found.same is False
    assert field in "; ".join(found.why)


def test_a_term_without_a_name_is_not_shown_by_a_final_fit_and_hides_nothing(made: Calibration):
    basis = Basis("bspline", ((0.0, 1.0),), 0, ((1.0,),), ((0.0,),), 10.0, ((1.0,),), ((1.0,),))
    unnamed = replace(made.effects[0], basis=basis)
    found = final_fit(replace(made, effects=(unnamed,)), replace(made, effects=(unnamed,)))
    assert found.same is None
    assert found.why[0].startswith("effects[0].basis: another version built it")
    assert final_fit(replace(made, effects=(unnamed,), frame_known=False), made).same is False


def test_what_no_final_fit_shows_is_named(made: Calibration):
    """The reason, the p-value and the rivals of an effect can be anything: they stand as that version stated them."""

    def edit(c: dict[str, Any]) -> None:
        c["effects"][0].update(why="certified elsewhere", p_value=1e-12, rivals=[])
        c["made_by"]["version"], c["software"] = "0.0.9", "labcal 0.0.9"

    found = final_fit(forged(edit), made)
    assert found.same
    assert {f"effects[0].{name}" for name in ("why", "p_value", "rivals", "provisional")} < set(found.as_stated)
    assert {f"metrics.{when}.holdout_rms_nT" for when in ("before", "after")} <= set(found.as_stated)
    assert not [place for place in found.as_stated if "train_rms" in place or "u_nT" in place]
    again, standing = found.sentences()
    assert again == "Worked out again from its run, it is the same."
    assert standing.startswith("Stated by labcal 0.0.9, and not worked out again: effects[0] (provisional, ")


def test_other_words_of_what_is_not_covered_are_named(made: Calibration):
    found = final_fit(forged(lambda c: c["not_covered"].__setitem__(1, "Nothing.")), made)
    assert found.same
    assert "not_covered[1]" in found.as_stated


def test_no_held_out_error_is_smaller_than_what_the_final_fit_leaves():
    shown = {"before": {"train_rms_nT": 90.0}, "after": {"train_rms_nT": 8.0, "beside_declared_nT": 7.0}}
    stated = {"before": {"holdout_rms_nT": 95.0}, "after": {"holdout_rms_nT": 1.0, "holdout_beside_declared_nT": 0.0}}
    assert with_held_out(shown, stated) == {
        "before": {"train_rms_nT": 90.0, "holdout_rms_nT": 95.0},
        "after": {"train_rms_nT": 8.0, "holdout_rms_nT": 8.0, "holdout_beside_declared_nT": 7.0},
    }
    assert with_held_out(shown, {"after": {"holdout_rms_nT": 9.0}})["after"] == {
        "train_rms_nT": 8.0,
        "holdout_rms_nT": 9.0,
    }
    assert with_held_out(shown, {})["after"]["holdout_rms_nT"] == 8.0  # nor is it left out


def without_a_row_that_says_nothing(c: dict[str, Any]) -> None:
    """One that is listed just so: the next version may leave it out."""
    one = min(c["budget"], key=lambda one: min(row["share"] for row in one["rows"]))
    one["rows"].remove(row := min(one["rows"], key=lambda row: row["share"]))
    assert row["share"] < 1.1e-5


@pytest.mark.parametrize(
    "edit",
    [
        lambda c: None,
        without_a_row_that_says_nothing,
        lambda c: another_covariance(c, 1.05),
        lambda c: another_covariance(c, 0.95),
        lambda c: less_of_one_combination(c, 0.92),
        other_dof,
        lambda c: c["not_covered"].append("something else"),
    ],
)
def test_what_versions_may_differ_in_is_the_same(made: Calibration, edit: Edit):
    assert final_fit(forged(edit), made).same


@pytest.mark.parametrize(
    ("value", "change", "field"),
    [
        (4.5, {"risk": 0.001}, "specification[0].risk, as standard deviations: 3.09023 is stated, its run gives 37"),
        (49.3, {"risk": 1e-4}, "specification[0].risk, as standard deviations: 3.71902 is stated, its run gives 2"),
        (49.3, {"tur": 130.0}, "specification[0].tur: 130 is stated, and 71.4286 follows from limit and U"),
        (4.5, {"value": 4.6}, "specification[0].value: 4.6 "),
        (49.3, {"value": 49.32, "risk": 0.026}, ""),
    ],
)
def test_a_line_of_the_specification_differs_by_what_a_tenth_of_U_does(
    made: Calibration, value: float, change: dict[str, float], field: str
):
    noise = Measured("noise", "noise", value, 0.35, signed=False)
    line = asdict(judge(noise, Limit(50.0, "nT"), Specification(noise=Limit(50.0, "nT"))))
    there = replace(made, specification=(line,))
    found = final_fit(replace(there, specification=({**line, **change},)), there)
    assert found.same == (not field)
    assert field in "; ".join(found.why)


def test_a_figure_of_the_map_is_judged_as_the_map_has_it(made: Calibration):
    line = asdict(judge(figures_of_the_map(made)[0], Limit(5000.0, "nT"), OFFSET))
    there = replace(made, specification=(line,))
    assert final_fit(there, there).same
    little = {**line, "value": line["value"] + 0.01 * line["U"]}
    found = final_fit(replace(there, specification=(little,)), there)
    assert found.why[0].endswith("follows from K and k")
