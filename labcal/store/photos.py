"""Photographs beside the store: each under the SHA-256 of its bytes, so that a record can name it and prove it."""

from __future__ import annotations

from hashlib import sha256
from pathlib import Path

from labcal.errors import InputError
from labcal.files.atomic import write_bytes
from labcal.files.home import FILE, home, own_folder
from labcal.files.plain_file import read_limited

LARGEST_BYTES = 50 * 2**20
KINDS = {b"\xff\xd8\xff": ".jpg", b"\x89PNG": ".png", b"RIFF": ".webp"}


def keep_photo(path: Path) -> dict[str, str]:
    """Copy the photograph at `path` beside the store; returns its name there and its SHA-256, for an event's data.

    Raises InputError where it is no photograph, or larger than 50 MB.
    """
    try:
        content = read_limited(path, LARGEST_BYTES)
    except OSError as error:
        raise InputError(f"cannot be read: {error.strerror}", file=path) from error
    kind = next((kind for start, kind in KINDS.items() if content.startswith(start)), None)
    if kind is None:
        raise InputError("is no JPEG, PNG or WebP picture", file=path)
    digest = sha256(content).hexdigest()
    kept = home() / "photos" / f"{digest}{kind}"
    if not kept.exists():
        own_folder(own_folder(home()) / kept.parent.name)
        write_bytes(kept, content, FILE)
    return {"photo": kept.name, "sha256": digest, "taken_from": path.name}
