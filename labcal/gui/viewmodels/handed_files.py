"""What was handed out, file by file."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.certificate.handed import kind_of
from labcal.gui.translations.punctuation import with_head
from labcal.gui.translations.translate import translated

KINDS = {
    "certificate": QT_TRANSLATE_NOOP("Words", "the certificate, for people"),
    "calibration": QT_TRANSLATE_NOOP("Words", "the calibration, for programs"),
    "signature": QT_TRANSLATE_NOOP("Words", "a signature of it"),
    "time-stamp": QT_TRANSLATE_NOOP("Words", "when it was signed"),
    "keys": QT_TRANSLATE_NOOP("Words", "the keys to verify it by"),
    "contents": QT_TRANSLATE_NOOP("Words", "this list, for the customer"),
}


def handed_files(folder: Path, name: str) -> list[str]:
    """A line for each file in `folder` that belongs to the calibration handed out as `name`."""
    names = sorted(one.name for one in folder.iterdir()) if folder.is_dir() else []
    return [with_head(one, translated(str(KINDS[kind]))) for one in names if (kind := kind_of(one, name))]
