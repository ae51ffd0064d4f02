from __future__ import annotations

import os
from pathlib import Path

import pytest

from labcal.errors import InputError
from labcal.files.atomic import replacing, write_text
from labcal.files.text_safety import checked_text, replace_control


def test_a_file_is_whole_or_absent_and_leaves_nothing_beside_it(tmp_path: Path) -> None:
    path = tmp_path / ("n" * 250)
    write_text(path, "first\n")
    with pytest.raises(UnicodeEncodeError), replacing(path) as part:
        part.write_text("sec\ud800", encoding="utf-8")
    assert path.read_text() == "first\n"
    assert list(tmp_path.iterdir()) == [path]


def test_what_no_file_may_replace_is_refused_by_its_own_name(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    for path, says in ((tmp_path, "a folder"), (tmp_path / "pipe", "a device"), (tmp_path / "no/x", "does not exist")):
        with pytest.raises(InputError, match=says) as caught:
            write_text(path, "x")
        assert str(caught.value).startswith(f"{path}: ")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["pipe"]


def test_a_fault_of_the_disk_names_the_file_that_was_asked_for(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(_: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("os.fsync", full)
    with pytest.raises(OSError, match="No space left") as caught:
        write_text(tmp_path / "out.csv", "x")
    assert caught.value.filename == str(tmp_path / "out.csv")
    assert not list(tmp_path.iterdir())


def test_text_that_acts_on_a_terminal_is_refused_or_marked() -> None:
    assert checked_text("Grüße, 测试\tand\nmore") == "Grüße, 测试\tand\nmore"
    for acts in ("\x1b[2J", "\x00", "\x9b2J", "a\u202eb", "\ud800"):
        with pytest.raises(ValueError, match=r"control character U\+"):
            checked_text(acts)
    assert replace_control({"a": ["\x1b[2J", 1, None]}) == {"a": ["\ufffd[2J", 1, None]}
