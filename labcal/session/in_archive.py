"""What the archive knows of a signed calibration: when its signatures came there, and what took its place."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from datetime import datetime
from functools import partial
from hashlib import sha256
from pathlib import Path

from labcal.errors import InputError
from labcal.files.home import ARCHIVE
from labcal.session.opened_archive import opened

InArchive = Callable[[bytes, Sequence[bytes], Path], Mapping[str, datetime]]


def asking(given: str | None, on_remark: Callable[[str], None]) -> InArchive | None:
    """How to ask the archive at `given`, else that of LABCAL_ARCHIVE; None where neither is named.

    Only one that was `given` has to answer: of the other `on_remark` gets that it did not.
    """
    if given is not None:
        return partial(known_there, given)
    return partial(_if_it_answers, on_remark) if os.environ.get(ARCHIVE) else None


def _if_it_answers(
    on_remark: Callable[[str], None], content: bytes, signatures: Sequence[bytes], folder: Path
) -> Mapping[str, datetime]:
    try:
        return known_there(None, content, signatures, folder)
    except InputError as fault:
        on_remark(f"the archive was not asked: {fault}")
        return {}


def known_there(given: str | None, content: bytes, signatures: Sequence[bytes], folder: Path) -> Mapping[str, datetime]:
    """When each of the `signatures` came to the archive, by their SHA-256; those that are not there are left out.

    What supersedes the file that holds `content` is written to `folder`, with its signatures. Raises InputError where
    the archive cannot be asked.
    """
    with opened(given) as archive:
        from labcal.archive.queries import came_utc, superseding

        for number, (later, signed) in enumerate(superseding(archive, sha256(content).hexdigest())):
            (folder / f"{number}.json").write_bytes(later)
            for place, signature in enumerate(signed, 1):  # whatever they were called: none hides another
                (folder / f"{number}.json{'' if place == 1 else f'.{place}'}.sshsig").write_bytes(signature)
        return came_utc(archive, [sha256(one).hexdigest() for one in signatures])
