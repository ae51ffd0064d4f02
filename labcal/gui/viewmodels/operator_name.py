"""What the operator's name may look like where it is typed: whatever a person is called, and no slip of the keys."""

from __future__ import annotations

import unicodedata

from labcal.errors import InputError
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.record.person import check_operator

BETWEEN = " .,'’-‐·_@+&/()"  # beside letters and digits; each that a trust list allows is among them


def name_objection(name: str) -> str:
    """Why this is no name, in words; "" where it is one, or is empty."""
    try:
        check_operator(name)
    except InputError as error:
        return in_words(str(error))
    if not name or (any(map(str.isalnum, name)) and all(map(_may_stand, name))):
        return ""
    return translated("“{0}” is no name: letters, digits, blanks, and . , ' - _ @ + & / ( ) between them").format(name)


def _may_stand(letter: str) -> bool:
    """Letters of every script, with the marks that belong to them."""
    return letter.isalnum() or letter in BETWEEN or unicodedata.category(letter).startswith("M")
