from __future__ import annotations

import pytest

from labcal.cli import _run


@pytest.mark.parametrize("words", [["no-such-command"], ["--no-such-option"], ["keys", "new"], ["verify"]])
def test_a_wrong_word_is_a_sentence_and_exit_2(words: list[str], capsys: pytest.CaptureFixture[str]):
    assert _run(words) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert "Traceback" not in said.err
    assert said.err


def test_help_is_no_fault(capsys: pytest.CaptureFixture[str]):
    assert _run(["--help"]) == 0
    assert "verify" in capsys.readouterr().out
