"""A photograph is kept under its own hash; what is no picture is refused."""

from __future__ import annotations

from hashlib import sha256
from pathlib import Path

import pytest

from labcal.errors import InputError
from labcal.files.home import home
from labcal.store.photos import keep_photo

PNG = b"\x89PNG\r\n\x1a\n" + bytes(range(64))


def test_a_photograph_is_kept_under_its_hash_once(tmp_path: Path) -> None:
    (tmp_path / "a.png").write_bytes(PNG)
    said = keep_photo(tmp_path / "a.png")
    assert said == keep_photo(tmp_path / "a.png")
    assert (said["sha256"], said["taken_from"]) == (sha256(PNG).hexdigest(), "a.png")
    assert (home() / "photos" / said["photo"]).read_bytes() == PNG


def test_what_is_no_picture_is_refused_by_name(tmp_path: Path) -> None:
    (tmp_path / "a.png").write_text("no picture")
    with pytest.raises(InputError, match="no JPEG"):
        keep_photo(tmp_path / "a.png")
    with pytest.raises(InputError, match="cannot be read"):
        keep_photo(tmp_path / "none.png")
