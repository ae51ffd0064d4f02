"""What another version states is held against a final fit in every number of it, so that none hides a forged one."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import rfc8785

from labcal.certificate import parse_calibration
from labcal.certificate.recomputed import final_fit
from labcal.model import Calibration
from labcal.model.smooth import Basis

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
    (lambda c: c["budget"][0].update(rows=[]), ".u x sensitivity: 0 "),
    (lambda c: c["budget"][0]["rows"][-1].update(source="Earth"), ".u x sensitivity: "),
    (lambda c: c["budget"][0]["rows"][-1].update(type="B"), ".u x sensitivity: "),
    (lambda c: c["budget"][0]["rows"][-1].update(u=0.1, sensitivity=149.5), ".u: 0.1 "),
    (lambda c: c["budget"][0]["rows"][-1].update(share=0.1), ".share: 0.1 "),
    (two_of_one_name, "budget: "),
]


@pytest.fixture(scope="module")
def made() -> Calibration:
    """The example's, as a final fit would give it: without the evidence of its effects."""
    found = parse_calibration(EXAMPLE.read_bytes())
    return replace(found, effects=tuple(replace(one, why="", rivals=(), p_value=None) for one in found.effects))


def forged(edit: Edit) -> Calibration:
    stated = json.loads(EXAMPLE.read_bytes())
    edit(stated)
    return parse_calibration(rfc8785.dumps(stated))


@pytest.mark.parametrize(("edit", "field"), FORGERIES)
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


def without_a_row_that_says_nothing(c: dict[str, Any]) -> None:
    c["budget"][0]["rows"] = [row for row in c["budget"][0]["rows"] if row["share"] > 1e-4]


@pytest.mark.parametrize(
    "edit",
    [
        lambda c: None,
        without_a_row_that_says_nothing,
        lambda c: c["budget"][0].update(U=1.05 * c["budget"][0]["U"], k=2.05),
        lambda c: c["budget"][0]["rows"][-1].update(dof=3000.0),
        lambda c: c["not_covered"].append("something else"),
    ],
)
def test_what_versions_may_differ_in_is_the_same(made: Calibration, edit: Edit):
    assert final_fit(forged(edit), made).same
