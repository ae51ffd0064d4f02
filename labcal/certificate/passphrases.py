"""What a new passphrase has to be: ten characters, and more than one common word with something round it."""

from __future__ import annotations

import re

from labcal.errors import InputError

SHORTEST = 10

# What guessing programs try first and labs are tempted to take; each alone, whatever digits and signs stand round it.
_WORDS = """
    access account admin administrator amplifier analysis astronaut attitude baseball basketball battery bluetooth
    butterfly calculator calibrate calibrated calibration certificate certified changeme charlie chocolate coil coils
    computer cosmonaut default demagnetise demagnetize department diamond dragon dynamics earthfield elephant engineer
    engineering experiment facility firmware flight football forever freedom gaussmeter hamster helmholtz hello
    helmholtzcage iloveyou instrument instruments internet jennifer lab labcal labcalibration laboratory labor
    letmein liverpool login magnet magnetic magnetics magnetism magnetometer manchester master measure measurement
    metrology michelle microsoft monkey mountain nanotesla observatory offset operator orbit orientation oscilloscope
    passphrase password passwort physics platform princess private procedure qwerty qwertyui qwertyuiop
    reference research satellite satellites scientist secret sensor sensors shadow signature simulated simulation
    spacecraft spaceflight standard starwars sunshine superman supervisor technician telemetry temperature test
    tester testing trustno1 uncertainty university unknown user validation verification volunteer welcome whatever
    workshop
"""
COMMON = frozenset(_WORDS.split())
_ROWS = ("qwertyuiop", "asdfghjkl", "zxcvbnm", "qwertzuiop", "yxcvbnm", "azertyuiop", "1234567890")
_READ_AS = str.maketrans("0134578@$!", "oieastbasi")  # digits and signs that are written for letters


def check_passphrase(passphrase: str, name: str) -> None:
    """Raise InputError where the passphrase for the key of `name` would be guessed among the first."""
    if (why := objection(passphrase, name)) is not None:
        raise InputError(f"{why}; nothing was made")


def objection(passphrase: str, name: str) -> str | None:
    """Why the key of `name` cannot have this passphrase; None where it can."""
    if not passphrase:
        return "the passphrase is empty"
    if len(passphrase) < SHORTEST:
        return f"the passphrase has {len(passphrase)} characters and needs {SHORTEST}: four words are easy to keep"
    if (why := _guessed(passphrase.casefold(), name.casefold())) is not None:
        return f"the passphrase is {why}: four words are easy to keep"
    return None


def _guessed(plain: str, name: str) -> str | None:
    bare, own = _letters(plain), _letters(name.partition("@")[0])
    if len(set(plain)) < 4:
        return "three signs over and over"
    if plain == name or (own and bare == own):
        return "the name of the key's own person"
    if _repeated(bare) in COMMON:
        return "a common word alone"
    if _runs(plain):
        return "a row of the keyboard, or of the alphabet"
    return None


def _letters(text: str) -> str:
    """What it spells: without blanks and what stands round each word, digits and signs inside one as letters."""
    words = (re.sub(r"^[\W\d_]+|[\W\d_]+$", "", word) for word in re.split(r"[\s._-]+", text))
    return re.sub(r"[\W\d_]", "", "".join(words).translate(_READ_AS))


def _repeated(word: str) -> str:
    """Of a word that is written several times, the word once."""
    return next(part for n in range(1, len(word) + 1) if (part := word[:n]) * (len(word) // n) == word) if word else ""


def _runs(plain: str) -> bool:
    """Whether it goes along a row of keys, or the alphabet, forward or backward, all the way."""
    rows = (*_ROWS, "abcdefghijklmnopqrstuvwxyz", "0123456789")
    steps = {row[i : i + 2] for row in rows for i in range(len(row) - 1)}
    pairs = [plain[i : i + 2] for i in range(len(plain) - 1)]
    strange = sum(pair not in steps and pair[::-1] not in steps for pair in pairs)
    return strange <= len(plain) // 6
