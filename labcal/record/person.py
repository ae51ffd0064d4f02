"""What a person may be called, and whether two names are one person's, however they are spelled."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator

from labcal.errors import InputError

LONGEST = 100
BESIDE = " .,'’-‐·_@+&/()"  # letters and digits; each that a trust list allows is among them
_BETWEEN = re.compile(r"[\W_]+")  # what one person writes in a name today, and leaves out tomorrow
_TITLES = {"dr", "prof", "mr", "mrs", "ms"}
_LOOKS_LIKE = str.maketrans(  # small letters of other scripts and digits, and what they are taken for
    "авеһікмнорстухѕјԁԛԝӏ" + "αβεζικνορτυχϲ" + "օսհցոյ" + "ɑɡıȷʟ" + "01",
    "abehikmhopctyxsjdqwl" + "abezikvoptyxc" + "ouhgnj" + "agijl" + "ol",
)
_CAPITAL_I = re.compile(r"(?<=[a-z])I(?![A-Z])")  # amid small letters it may pass for an l
_SPELLED_OUT = str.maketrans({"ä": "ae", "ö": "oe", "ü": "ue", "å": "aa", "ø": "oe", "æ": "ae", "œ": "oe"})
_WITHOUT = str.maketrans({"ø": "o", "æ": "a", "œ": "o", "ł": "l", "đ": "d"})  # what does not come apart


def check_operator(name: str) -> None:
    """Raise InputError where `name` is not what a person may be called in a record; none is a name too."""
    if len(name) > LONGEST or not (name.isprintable() or not name):
        raise InputError(f"the operator's name must be one printable line of at most {LONGEST} letters")
    check_person(name)


def check_person(name: str) -> None:
    """Raise InputError where `name` is a slip of the keys, and nothing that a person is called; none is a name too."""
    if name and not (any(map(str.isalnum, name)) and all(map(_may_stand, name))):
        raise InputError(f"“{name}” is no name: letters, digits, blanks, and . , ' - _ @ + & / ( ) between them")


def _may_stand(letter: str) -> bool:
    """Letters of every script, with the marks that belong to them."""
    return letter.isalnum() or letter in BESIDE or unicodedata.category(letter).startswith("M")


def same_person(one: str, other: str) -> bool:
    """Whether two names are one person's: "J. Doe", "j doe", "j.doe@lab", "Doe, J." and "Dr. J. Doe" are.

    Capitals, blanks, dots, hyphens, apostrophes, accents, titles and which name comes first tell nobody apart, nor do
    letters of another script and digits that look the same; what stands behind an @ does where both say it.
    """
    one, other = _without_place(one, other)
    return bool(_spellings(one) & _spellings(other))


def perhaps_one_person(one: str, other: str) -> bool:
    """Whether nothing shows that these are two: they are the same, or one may be the other's initials ("Jane Doe")."""
    one, other = _without_place(one, other)
    return same_person(one, other) or bool(_initials(one) & _spellings(other) or _spellings(one) & _initials(other))


def _without_place(one: str, other: str) -> tuple[str, str]:
    """Both without what stands behind an @, where one of them does not say it."""
    return (one, other) if ("@" in one) == ("@" in other) else (one.partition("@")[0], other.partition("@")[0])


def _spellings(name: str) -> set[str]:
    """What the name comes to, whichever of its words is first; none for no name."""
    return {"".join(words) for words in _orders(name)}


def _initials(name: str) -> set[str]:
    """What it comes to with initials before the last word; none for one word."""
    return {"".join([*(word[0] for word in words[:-1]), words[-1]]) for words in _orders(name) if len(words) > 1}


def _orders(name: str) -> Iterator[list[str]]:
    """Its words, whichever is first, with ä as a and as ae, an I within a word as i and as l."""
    whole = unicodedata.normalize("NFKC", name)
    for read in {whole.casefold(), _CAPITAL_I.sub("l", whole).casefold()}:
        for table in (_SPELLED_OUT, _WITHOUT):
            words = [letters for word in _BETWEEN.split(read) if (letters := _letters(word.translate(table)))]
            words = [word for word in words if word not in _TITLES] or words
            yield from (words[first:] + words[:first] for first in range(len(words)))


def _letters(text: str) -> str:
    apart = unicodedata.normalize("NFKD", text)
    return "".join(letter for letter in apart if unicodedata.category(letter) not in ("Mn", "Cf", "Lm")).translate(
        _LOOKS_LIKE
    )
