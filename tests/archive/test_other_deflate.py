"""One machine has ISA-L and another has not: their zips of a run differ, and it is the same run."""

from __future__ import annotations

import sys
import zlib
from pathlib import Path

import pytest
from conftest import rows_of
from made_lab import stored_runs
from postgres import Server

from labcal.session import archiving
from labcal.store.zip_writing import deflaters


@pytest.mark.skipif(list(deflaters()) == [zlib], reason="isal is not installed: there is one deflate alone")
@pytest.mark.parametrize("first", ["with", "without"])
def test_what_was_pushed_with_it_and_without_is_one_row_and_is_made_whole_by_either(
    first: str, postgres: Server, database: str, url: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    stored_runs([0], 2000)

    def push(how: str, *names: str) -> tuple[int, tuple[str, ...]]:
        with monkeypatch.context() as patch:
            if how == "without":
                patch.setitem(sys.modules, "isal.isal_zlib", None)
            found = archiving.push(url, names)
            return found.runs, found.refused

    assert push(first) == (1, ())
    there = rows_of(postgres, database)
    [kept] = (tmp_path / "bundles").rglob("*.zip")
    content = kept.read_bytes()
    other = "without" if first == "with" else "with"
    assert push(other) == push(other, "size-0") == (0, ())
    assert rows_of(postgres, database)["run"] == there["run"]
    assert list((tmp_path / "bundles").rglob("*.zip")) == [kept]
    kept.unlink()
    assert push("with", "size-0") == (0, ())  # whichever made it, for zlib is there as well
    assert kept.read_bytes() == content
