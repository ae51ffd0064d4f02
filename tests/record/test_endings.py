"""How a run ended, in two words: stopped by a person, or broken off by a fault or a crash."""

import pytest

from labcal.record.endings import ended_word, ended_words


@pytest.mark.parametrize(
    ("status", "stopped", "words", "word"),
    [
        ("finished", False, "finished", "finished"),
        ("imported", False, "imported", "imported"),
        ("stopped", True, "stopped", "stopped"),
        ("interrupted", True, "stopped", "stopped"),
        ("interrupted", False, "broken off", "broken off"),
        ("failed: dut is silent", False, "broken off: dut is silent", "broken off"),
        ("failed: aborted by the operator", True, "stopped by the operator", "stopped"),
        ("interrupted: stopped by the operator", False, "stopped by the operator", "stopped"),
        ("interrupted by its store: disk full", False, "broken off by its store: disk full", "broken off"),
        ("failed", False, "broken off", "broken off"),
    ],
)
def test_one_word_for_each_of_the_two(status, stopped, words, word):
    assert ended_words(status, stopped=stopped) == words
    assert ended_word(status, stopped=stopped) == word
