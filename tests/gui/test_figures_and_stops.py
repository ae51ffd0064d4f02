"""German and French as they are written: the decimal mark in what is said of keys, and a stop after each sentence."""

from pathlib import Path
from xml.etree import ElementTree

import pytest
from test_nothing_is_cut import other_language as other_language

from labcal.gui.translations import translate

LANGUAGES = ["de", "fr"]


@pytest.mark.parametrize("other_language", LANGUAGES, indirect=True)
def test_the_sheet_of_keys_says_how_long_in_the_decimal_mark_of_the_language(other_language, still):
    said = " ".join(dict(still.keys()).values())
    assert "0,7 s" in said
    assert "0.7" not in said


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_sentence_ends_with_a_stop_where_it_does_in_english(language):
    """Sentences are put one after another: "15,4 nT rms Le résidu …"."""
    file = Path(translate.__file__).with_name(f"labcal_{language}.ts")
    told = [
        (one.findtext("source", ""), one.findtext("translation", "")) for one in ElementTree.parse(file).iter("message")
    ]
    assert len(told) > 1000
    assert not [translation for source, translation in told if source.endswith(".") != translation.endswith(".")]
