"""Where bundles lie: a folder, or what fsspec reaches; each is what it is called by."""

from __future__ import annotations

from hashlib import sha256
from pathlib import Path

import pytest

from labcal.archive.bundles import get, put
from labcal.errors import InputError


@pytest.mark.parametrize("place", ["folder", "memory://labcal/bundles"])
def test_what_is_put_comes_back_by_its_content(place: str, tmp_path: Path) -> None:
    if "://" in place:
        pytest.importorskip("fsspec", reason="bundles elsewhere than in a folder need fsspec")
    where = place if "://" in place else str(tmp_path / place)
    assert put(where, b"samples") == put(where, b"samples") == sha256(b"samples").hexdigest()
    assert get(where, sha256(b"samples").hexdigest()) == b"samples"
    with pytest.raises(InputError, match="is not there"):
        get(where, sha256(b"other").hexdigest())


def test_half_a_file_of_before_is_made_whole(tmp_path: Path) -> None:
    digest = put(str(tmp_path), b"samples")
    [path] = tmp_path.rglob("*.zip")
    path.chmod(0o600)
    path.write_bytes(b"sam")
    put(str(tmp_path), b"samples")
    assert get(str(tmp_path), digest) == b"samples"


def test_a_damaged_object_of_the_same_size_is_made_whole_elsewhere_too() -> None:
    fsspec = pytest.importorskip("fsspec", reason="bundles elsewhere than in a folder need fsspec")
    place = "memory://labcal/damaged"
    digest = put(place, b"samples")
    [path] = fsspec.filesystem("memory").glob("/labcal/damaged/*/*.zip")
    fsspec.filesystem("memory").pipe_file(path, b"SAMPLES")
    put(place, b"samples")
    assert get(place, digest) == b"samples"


def test_an_error_of_the_other_side_s_own_is_one_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    """S3 without a connection or credentials raises what is no OSError."""
    fsspec = pytest.importorskip("fsspec", reason="bundles elsewhere than in a folder need fsspec")

    class NoCredentialsError(Exception): ...

    def refuse(*_: object, **__: object) -> None:
        raise NoCredentialsError("Unable to locate credentials")

    digest = sha256(b"samples").hexdigest()
    for method in ("exists", "cat_file"):
        monkeypatch.setattr(type(fsspec.filesystem("memory")), method, refuse)
    with pytest.raises(InputError, match="cannot be kept or read there: Unable to locate credentials"):
        put("memory://labcal/bundles", b"samples")
    with pytest.raises(InputError, match="cannot be kept or read there: Unable to locate credentials"):
        get("memory://labcal/bundles", digest)


def test_a_folder_that_is_none_is_one_sentence(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(InputError, match="bundles cannot be kept or read there"):
        put(str(tmp_path / "file"), b"samples")


def test_a_place_that_nobody_reaches_is_one_sentence_without_its_password(tmp_path: Path) -> None:
    pytest.importorskip("fsspec", reason="bundles elsewhere than in a folder need fsspec")
    for place in ("nonsense://u:c4nary@x/y", "s3://c4nary:c4nary@x/y"):
        with pytest.raises(InputError) as told:
            put(place, b"samples")
        assert "c4nary" not in str(told.value).replace("s3://c4nary:", "")
