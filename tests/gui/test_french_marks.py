"""French has a blank before ; : ! ? and within «  »: one that breaks no line, in each text and in what is joined."""

import re

import pytest
from test_languages import messages
from test_tenth_walk import in_language as in_language

from labcal.bench.coils import state
from labcal.gui.translations.punctuation import as_set, listed_apart, parted, with_head
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import FOLDER

SET_WRONG = re.compile(r"(?<!^)(?<![\u00a0\u202f])[;:!?](?=\s|$)|(?<![\u00a0\u202f])»|«(?![\u00a0\u202f])")


def test_each_has_it_in_every_text():
    texts = [one.text or "" for one in messages(FOLDER / "labcal_fr.ts").values()]
    assert [text for text in texts if SET_WRONG.search(text)] == []
    assert any("\u00a0:" in text for text in texts)


@pytest.mark.parametrize(("code", "set_"), [("en", ";"), ("de", ";"), ("fr", "\u00a0;")])
def test_what_is_joined_has_it_too(in_language, code, set_):
    in_language(code)
    assert listed_apart(["a", "b"]) == f"a{set_} b"
    assert with_head("a", "b") == f"a{set_[:-1]}: b"
    assert as_set(".") == "."
    assert parted(listed_apart(["a", "b"])) == ["a", "b"]
    both = in_words(f"{state.AT_ZERO}; {state.AT_ZERO}")
    assert both == listed_apart([in_words(state.AT_ZERO)] * 2)
    assert in_words(f"{state.BY_WORD}: {state.NOT_READ_ON}").count(f"{set_} ") == 1
