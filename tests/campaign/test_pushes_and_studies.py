"""The campaign on the archive in its short form: a server and a push killed once each, and a judge that sees damage."""

from __future__ import annotations

import os
import random
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest
from postgres import NoServerError

pytest.importorskip("psycopg", reason="needs the extra `archive`: pip install 'labcal[archive]'")

from pushes_and_studies import Place, Pushing, cut_push, tried


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Place]:
    if os.name != "posix":
        pytest.skip("a push is copied as POSIX systems copy a process")
    with pytest.MonkeyPatch.context() as patch, ExitStack() as stack:
        patch.setenv("LABCAL_HOME", os.environ.get("LABCAL_HOME", ""))  # put back at the end
        made = Place(tmp_path_factory.mktemp("campaign"), stack)
        try:
            assert made.server
        except NoServerError as reason:
            pytest.skip(str(reason))
        yield made


@pytest.mark.parametrize("kind", [pytest.param("server killed in a push", marks=pytest.mark.slow), "push killed"])
def test_what_was_cut_is_there_as_if_nothing_had_been(kind: str, place: Place) -> None:
    assert tried(place, kind, 0)["faults"] == []


def test_the_judge_sees_a_row_and_a_bundle_that_are_gone(place: Place) -> None:
    def damage(place: Place, pushing: Pushing) -> None:
        pushing.process.join(1800)
        lost = sorted(Path(place.folder, f"trial-{place.used}", "bundles").rglob("*.zip"))[0]
        lost.unlink()
        with place.server.connect(newest_database(place)) as connection:
            connection.execute("DELETE FROM labcal.instrument")

    faults = cut_push(place, random.Random(0), damage)["faults"]
    assert "other rows" in faults
    assert "other bundles" in faults
    assert any("half there" in one for one in faults)


def newest_database(place: Place) -> str:
    """Its number counts those of all tests of this process."""
    with place.server.connect() as connection:
        found = connection.execute("SELECT datname FROM pg_database WHERE datname LIKE 'lab%'").fetchall()
    return max((name for (name,) in found), key=lambda name: int(name.removeprefix("lab")))
