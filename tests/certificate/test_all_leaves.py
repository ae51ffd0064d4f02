"""Every leaf of a draft is edited before anybody has seen it: each ends in a refusal, or is a person's to state."""

from __future__ import annotations

import json
import random
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import rfc8785

from labcal import session
from labcal.certificate import parse_calibration
from labcal.errors import InputError
from labcal.session import working_out

EXAMPLE = Path(__file__).parents[2] / "examples" / "short-preflight"
SAFE = 2**53  # of an integer in canonical JSON
OF_PEOPLE = {"validity.until", "supersedes", "issued_utc"}  # of a draft anybody states them, or the approval does
Leaf = tuple[str | int, ...]


@pytest.fixture
def example() -> dict[str, Any]:
    """The example's calibration, a draft again; its run is in the store, Bob has a key, what was worked out is kept."""
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


def passed(draft: dict[str, Any], path: Path, step: int) -> list[str]:
    """The leaves of every step's whose edit an approver would not be kept from."""
    chance, found = random.Random(17), []
    for at in [at for at, _ in leaves(draft)][chance.randrange(step) :: step]:
        path.write_bytes(forged(draft, at, chance))
        try:
            session.approve(path, "bob")
        except InputError:
            continue
        found.append(place(at))
    return found


@pytest.mark.parametrize("step", [97, pytest.param(1, marks=pytest.mark.slow)])
def test_no_leaf_can_be_another(example: dict[str, Any], tmp_path: Path, step: int):
    assert set(passed(example, tmp_path / "cal.json", step)) <= OF_PEOPLE
