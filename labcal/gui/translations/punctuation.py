"""Marks between parts of a sentence that are put together: French has a blank before ; and :, which breaks no line."""

from __future__ import annotations

from labcal.gui.translations.translate import spoken

NO_BREAK = "\N{NO-BREAK SPACE}"
SET_APART = (";", ":", "!", "?")
APART_IN = ("fr",)  # languages


def as_set(mark: str) -> str:
    """`mark` as the window's language sets it behind a word."""
    return f"{NO_BREAK}{mark}" if mark in SET_APART and spoken() in APART_IN else mark


def listed_apart(parts: list[str]) -> str:
    """Parts of one sentence, with a semicolon between them."""
    return f"{as_set(';')} ".join(parts)


def parted(sentence: str) -> list[str]:
    """The parts between the semicolons of a sentence, however these are set."""
    return [part.removesuffix(NO_BREAK) for part in sentence.split("; ")]


def with_head(head: str, words: str) -> str:
    """What `words` are about, a colon, and these."""
    return f"{head}{as_set(':')} {words}"
