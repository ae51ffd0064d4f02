"""What came over a line as a message quotes it: never more than can be read, nothing in it unseen."""

from __future__ import annotations

SHOWN, SENTENCE = 40, 120  # bytes or characters: of what should have been short, of an instrument's own words


def quoted(reply: bytes | str) -> str:
    """The beginning of a reply between quotes, with escapes for what is not seen, and how much more there was."""
    more = len(reply) - SHOWN
    return f"{reply[:SHOWN]!r}{f' … and {more} more' if more > 0 else ''}"


def abridged(words: str) -> str:
    """An instrument's own words, as `quoted` but without the quotes."""
    return repr(words[:SENTENCE])[1:-1] + " …" * (len(words) > SENTENCE)
