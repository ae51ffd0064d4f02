"""The operator's name where it is typed: the record's own rule, in words."""

from __future__ import annotations

from labcal.errors import InputError
from labcal.gui.translations.sentences import in_words
from labcal.record.person import check_operator


def name_objection(name: str) -> str:
    """Why this is no name, in words; "" where it is one, or is empty."""
    try:
        check_operator(name)
    except InputError as error:
        return in_words(str(error))
    return ""
