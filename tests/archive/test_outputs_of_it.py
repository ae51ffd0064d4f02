"""Files that the archive's commands write replace nothing that is not theirs."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import Bundle

from labcal.cli import execute as labcal
from labcal.files.home import home
from labcal.session import archiving
from labcal.store import Store


@pytest.mark.parametrize(
    ("words", "name"),
    [
        (("archive", "runs", "--json"), "runs.json"),
        (("archive", "calibrations", "--json"), "calibrations.json"),
        (("archive", "get", "demo-0", "--out"), "back.zip"),
    ],
)
def test_what_is_there_is_kept_until_force_is_said_and_the_store_then_too(
    words: tuple[str, ...], name: str, url: str, bundle: Bundle, tmp_path: Path
) -> None:
    archiving.push(url, [str(bundle())])
    out = tmp_path / name
    out.write_text("the work of a week")
    assert labcal([*words, str(out), "--archive", url]) == 2
    assert out.read_text() == "the work of a week"
    assert labcal([*words, str(out), "--archive", url, "--force"]) == 0
    assert out.read_bytes()[:1] in (b"P", b"[")
    Store.open().close()
    before = (home() / "store.sqlite").read_bytes()
    assert labcal([*words, str(home() / "store.sqlite"), "--archive", url, "--force"]) == 2
    assert (home() / "store.sqlite").read_bytes() == before
