"""What a serial number may look like on a bench, `serial_pattern` of its bench.toml or what serials usually are; and
whether an instrument names another one than is stated.
"""

from __future__ import annotations

import re
import unicodedata

from labcal.files import patterns

USUAL = r"\w([\w .:+#()-]*[\w)])?"  # letters, digits, and what stands between them on labels
CONTROL = "C"  # the category of characters that are no letters, and move what is written or read


def usable_pattern(pattern: str) -> str:
    """`pattern` itself. Raises ValueError where it is no regular expression, or may take long to match."""
    return patterns.bounded(pattern).pattern


def objection(serial: str, pattern: str) -> str:
    """Why `serial` is none, in words; "" where it matches `pattern` as a whole, or is empty."""
    if len(serial) > patterns.LONGEST_TEXT:
        return f"a serial number of {len(serial)} characters: at most {patterns.LONGEST_TEXT}"
    if _leads_astray(serial):
        return (
            f"{serial!r} is no serial number: it becomes part of file names, which have no \\ .. or control characters"
        )
    if not serial or re.fullmatch(pattern, serial):
        return ""
    if pattern == USUAL and "/" in serial:
        return (
            f"{serial!r} is no serial number: it becomes part of file names, where a / parts folders; a bench whose "
            "serials have one says so (dut.serial_pattern)"
        )
    if pattern == USUAL:
        return f"{serial!r} is no serial number: letters and digits, and . : + # ( ) - or blanks between them"
    return f"{serial!r} is no serial number of this bench: they match {pattern} (dut.serial_pattern)"


def _leads_astray(serial: str) -> bool:
    """Whether it is for no file's name, whatever pattern a bench has; a single / is a matter of that."""
    return "\\" in serial or ".." in serial or any(unicodedata.category(one).startswith(CONTROL) for one in serial)


def is_another(named: str, stated: str) -> bool:
    """Whether an instrument that names itself so is another than the one that is `stated`; not where either is silent.

    What a driver adds, as the serial of the sensor behind a converter, stands beside it.
    """
    words = [word.casefold() for word in (named, *named.split())]
    return bool(named.strip()) and bool(stated.strip()) and stated.strip().casefold() not in words
