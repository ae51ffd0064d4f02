"""Whether two names are one person's, however they are spelled."""

from __future__ import annotations

import re
import unicodedata

from labcal.errors import InputError

LONGEST = 100
_BETWEEN = re.compile(r"[\s._-]+")  # what one person writes in a name today, and leaves out tomorrow
_LOOKS_LIKE = str.maketrans(  # small letters of other scripts and digits, and what they are taken for
    "авеһікмнорстухѕјԁԛԝӏ" + "αβεζικνορτυχϲ" + "օսհցոյ" + "ɑɡıȷʟ" + "01",
    "abehikmhopctyxsjdqwl" + "abezikvoptyxc" + "ouhgnj" + "agijl" + "ol",
)
_CAPITAL_I = re.compile(r"(?<=[a-z])I(?![A-Z])")  # amid small letters it may pass for an l
_SPELLED_OUT = str.maketrans({"ä": "ae", "ö": "oe", "ü": "ue", "å": "aa", "ø": "oe", "æ": "ae", "œ": "oe"})
_WITHOUT = str.maketrans({"ø": "o", "æ": "a", "œ": "o", "ł": "l", "đ": "d"})  # what does not come apart


def check_operator(name: str) -> None:
    """Raise InputError where `name` is not what a person is called on one line of a certificate; none is a name too."""
    if len(name) > LONGEST or not (name.isprintable() or not name):
        raise InputError(f"the operator's name must be one printable line of at most {LONGEST} letters")


def same_person(one: str, other: str) -> bool:
    """Whether two names are one person's: "J. Doe", "j doe", "j.doe" and "j.doe@lab" are.

    Capitals, blanks, dots, hyphens, underscores and accents tell nobody apart, nor do letters of another script and
    digits that look the same; what stands behind an @ does where both say it.
    """
    if ("@" in one) != ("@" in other):
        one, other = one.partition("@")[0], other.partition("@")[0]
    return bool(_spellings(one) & _spellings(other))


def _spellings(name: str) -> set[str]:
    """What the name comes to, with ä as a and as ae, an I within a word as i and as l; none for no name."""
    whole = unicodedata.normalize("NFKC", name)
    plain = [_BETWEEN.sub("", read.casefold()) for read in (whole, _CAPITAL_I.sub("l", whole))]
    return {_letters(read.translate(table)) for read in plain for table in (_SPELLED_OUT, _WITHOUT)} - {""}


def _letters(text: str) -> str:
    apart = unicodedata.normalize("NFKD", text)
    return "".join(letter for letter in apart if unicodedata.category(letter) not in ("Mn", "Cf")).translate(
        _LOOKS_LIKE
    )
