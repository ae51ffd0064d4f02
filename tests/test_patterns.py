"""A pattern that somebody states is refused where it could take long: what is taken ends soon, whatever it meets."""

import time

import pytest
from hypothesis import given, settings
from hypothesis import strategies as some

from labcal.files.patterns import LONGEST_TEXT, bounded

REPEATS = some.sampled_from(["*", "+", "?", "{2}", "{3,}", "{,40}", "{2,4}", "*?", "{60}"])
PIECES = some.recursive(
    some.sampled_from(["a", r"\w", "[ab]", ".", ""]),
    lambda inner: some.one_of(
        some.tuples(inner, inner).map("".join),
        some.tuples(inner, inner).map(lambda two: f"(?:{two[0]}|{two[1]})"),
        some.tuples(inner, REPEATS).map(lambda two: f"({two[0]}){two[1]}"),
    ),
    max_leaves=8,
)
HOSTILE = ["a" * LONGEST_TEXT, "a" * (LONGEST_TEXT - 1) + "!", "ab" * (LONGEST_TEXT // 2 - 1) + "!", "b" * LONGEST_TEXT]


@pytest.mark.parametrize(
    "pattern",
    [
        r"(\w+)+-",
        r"(a|a)*b",
        "a?" * 40 + "b",
        "(a|a)" * 30,
        "a*a*a*a*b",
        "(?:(?:){1000}){1000}",
        "((a*){60000}){60000}",
    ],
)
def test_what_could_take_long_is_refused(pattern: str) -> None:
    with pytest.raises(ValueError, match="may take very long to match"):
        bounded(pattern)


@pytest.mark.parametrize("pattern", ["EM-[", "(" * 150, "a{99999999999}", "a" * 201, "(?=a)b", r"(?P<n>a)(?(n)b|c)"])
def test_what_is_no_expression_or_is_not_taken_is_a_sentence(pattern: str) -> None:
    with pytest.raises(ValueError, match=r"is no regular expression|letters: at most|are taken"):
        bounded(pattern)


@pytest.mark.parametrize(
    "pattern", [r"EM-\d{2,4}", r"([A-Z]{2}-)*\d+", r"(?:EM|FM)-[()?*]+\(\d+\)", r"(?P<b>.+?)[-_ .]?\d+$"]
)
def test_those_of_labels_are_taken(pattern: str) -> None:
    assert bounded(pattern).pattern == pattern


@settings(max_examples=150, deadline=None)
@given(PIECES)
def test_what_is_taken_ends_soon_with_any_text(pieces: str) -> None:
    try:
        pattern = bounded(pieces + "$")
    except ValueError:
        return
    began = time.process_time()
    for text in HOSTILE:
        pattern.fullmatch(text)
    assert time.process_time() - began < 2.0, pattern.pattern
