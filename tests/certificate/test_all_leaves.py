"""Every leaf of a draft is edited before anybody has seen it: each ends in a refusal, or is a person's to state.

Beside it as another version states the same, of which a final fit alone can be worked out: what is "the same" there is
named by `verify` as stated, or moves no U, and nobody approves it.
"""

from __future__ import annotations

import json
import random
import re
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import rfc8785

from labcal import session
from labcal.certificate import parse_calibration, read_calibration
from labcal.errors import InputError
from labcal.session import working_out
from labcal.uncertainty.budget import coverage_factor

EXAMPLE = Path(__file__).parents[2] / "examples" / "short-preflight"
SAFE = 2**53  # of an integer in canonical JSON
OF_PEOPLE = {"validity.until", "supersedes", "issued_utc"}  # of a draft anybody states them, or the approval does
OF_ITS_APPROVAL = {"approvers", "number"}  # nothing to work out: whoever approves is refused beside another's
NOT_SHOWN = {"run_id", "cage_sha256"}  # a run that is not here, a cage that its bundle does not name: PROVISIONAL
AS_WELL = {"made_by.empirical"}  # no cause is left for a term without a name: made so, it is the same
Leaf = tuple[str | int, ...]


@pytest.fixture
def example(monkeypatch: pytest.MonkeyPatch) -> dict[str, Any]:
    """The example's calibration, a draft again; its run is in the store, Bob has a key, what was worked out is kept."""
    installed = working_out.version()
    monkeypatch.setattr(working_out, "version", lambda: installed)  # asked once, and not for each of 3 000 leaves
    session.import_bundle(EXAMPLE / "run.zip")
    session.new_key("bob", "correct horse")
    content = (EXAMPLE / "calibration.json").read_bytes()
    working_out.keep(parse_calibration(content))
    found: dict[str, Any] = json.loads(content, parse_int=lambda text: int(text) if int(text) < SAFE else float(text))
    return found


def leaves(value: Any, at: Leaf = ()) -> Iterator[tuple[Leaf, Any]]:
    """Every value that holds no other, with its place."""
    within = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    if not value or not within:
        yield at, value
    for name, one in within:
        yield from leaves(one, (*at, name))


def another(value: Any, chance: random.Random) -> Any:
    """A value of the same type; of what is absent, one that could be there."""
    if isinstance(value, bool):
        return not value
    if isinstance(value, int | float):
        return float(value * chance.choice((-1, 0.5, 2, 10, 1e-3)) if value else chance.choice((1, -1, 1e-3, 1e3)))
    if isinstance(value, str):
        return chance.choice((value + "x", "another", value[::-1] + "y"))
    return {"[]": ["x"], "{}": {"x": 1.0}}.get(str(value), chance.choice((1.0, "x", "2099-01-01", "ab" * 32)))


def forged(draft: dict[str, Any], at: Leaf, chance: random.Random) -> bytes:
    copy = json.loads(json.dumps(draft))
    within = copy
    for name in at[:-1]:
        within = within[name]
    within[at[-1]] = another(within[at[-1]], chance)
    if at[0] == "covariance":
        copy["covariance"][at[2]][at[1]] = within[at[-1]]
    return rfc8785.dumps(copy)


def place(at: Leaf) -> str:
    return "".join(f"[{name}]" if isinstance(name, int) else f".{name}" for name in at)[1:]


def is_approved(path: Path) -> bool:
    session.approve(path, "bob")
    return True


def is_the_same(path: Path) -> bool:
    """By what `verify` asks of the numbers, if its signatures hold."""
    return working_out.recomputed(read_calibration(path)).same is True


def passed(
    draft: dict[str, Any], path: Path, step: int, passes: Callable[[Path], bool] = is_approved
) -> dict[str, dict[str, Any]]:
    """The leaves of every step's whose edit is not found, and the drafts with it."""
    chance, found = random.Random(17), {}
    for at in [at for at, _ in leaves(draft)][chance.randrange(step) :: step]:
        path.write_bytes(content := forged(draft, at, chance))
        with suppress(InputError):
            if passes(path):
                found[place(at)] = json.loads(content)
    return found


@pytest.mark.parametrize("step", [97, pytest.param(1, marks=pytest.mark.slow)])
def test_no_leaf_can_be_another(example: dict[str, Any], tmp_path: Path, step: int):
    for leaf, other in passed(example, tmp_path / "cal.json", step).items():
        found = working_out.recomputed(parse_calibration(rfc8785.dumps(other)))
        assert leaf in OF_PEOPLE or (leaf in NOT_SHOWN and found.same is None) or (leaf in AS_WELL and found.same), leaf


@pytest.mark.parametrize("step", [97, pytest.param(1, marks=pytest.mark.slow)])
def test_of_another_version_what_passes_is_named_or_moves_no_U(example: dict[str, Any], tmp_path: Path, step: int):
    draft = example | {"software": "labcal 0.0.9", "made_by": example["made_by"] | {"version": "0.0.9"}}
    assert named(draft)
    path = tmp_path / "cal.json"
    found = passed(draft, path, step, is_the_same)
    print(f"{len(list(leaves(draft)))} leaves, passed: {', '.join(found)}")
    beside = {
        leaf: other for leaf, other in found.items() if leaf not in OF_PEOPLE and not leaf.startswith(named(other))
    }
    worked_out = {leaf: other for leaf, other in beside.items() if leaf not in OF_ITS_APPROVAL}
    assert [leaf for leaf, other in worked_out.items() if not moves_no_U(leaf, draft, other)] == []
    for leaf, other in beside.items():
        path.write_bytes(rfc8785.dumps(other))
        assert leaf.endswith("dof") or refused(path), leaf  # dof that k does not see


def named(draft: dict[str, Any]) -> tuple[str, ...]:
    """What `verify` says stands as another version stated it."""
    return working_out.recomputed(parse_calibration(rfc8785.dumps(draft))).as_stated


def refused(path: Path) -> bool:
    with pytest.raises(InputError):
        session.approve(path, "bob")
    return True


def moves_no_U(leaf: str, draft: dict[str, Any], other: dict[str, Any]) -> bool:
    """By a tenth, of any combination of parameters; of a budget not at all, or by a row that says next to nothing."""
    if leaf.startswith("covariance["):
        return bool(np.all(np.abs(spread_along(other) / spread_along(draft) - 1) < 0.1))
    entry, _, of_row = leaf.partition(".")
    if (number := re.fullmatch(r"budget\[(\d+)\]", entry)) is None:
        return False
    one, before = other["budget"][int(number[1])], draft["budget"][int(number[1])]
    if of_row.endswith("dof"):
        return effective_dof_sees_nothing(one, before)
    if of_row.endswith(".sensitivity"):
        return sizes_of(one) == sizes_of(before)  # another sign
    row = before["rows"][int(of_row.removeprefix("rows[").partition("]")[0])]
    return bool(row["share"] < 4e-5)  # one that another version may leave out, under whatever name


def spread_along(calibration: dict[str, Any]) -> Any:
    """u of 20 000 combinations of parameters, each of all of them in units of its own u of the example."""
    C, u = np.array(calibration["covariance"]), np.sqrt(np.diag(REFERENCE))
    along = np.random.default_rng(3).normal(size=(20_000, len(C))) / u
    return np.sqrt(np.einsum("ni,ij,nj->n", along, C, along))


REFERENCE = np.array(json.loads((EXAMPLE / "calibration.json").read_bytes())["covariance"])


def effective_dof_sees_nothing(one: dict[str, Any], before: dict[str, Any]) -> bool:
    k = [coverage_factor(entry["dof"] or np.inf) for entry in (one, before)]
    return bool(abs(k[0] - k[1]) < 1e-6)


def sizes_of(entry: dict[str, Any]) -> list[float]:
    return [abs(row["u"] * row["sensitivity"]) for row in entry["rows"]]
