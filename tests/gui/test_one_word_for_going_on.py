"""What brings an interrupted run on is called Go on, what does a step anew Try again: everywhere, in each language."""

import re
from pathlib import Path
from xml.etree import ElementTree

import pytest

HOME = Path(__file__).parents[2]
TEXTS = HOME / "labcal" / "gui" / "translations"
OTHER_NAMES = {  # of the same two things
    "source": re.compile(r"\bresum|take[sn]? up again|\bcontinue\b|begin this step again", re.IGNORECASE),
    "de": re.compile(r"fortsetz|fortgesetzt|wieder aufnehmen|Schritt neu beginnen", re.IGNORECASE),
    "fr": re.compile(r"\breprendre\b|\breprenez\b|recommencer cette étape", re.IGNORECASE),
}


def messages(language):
    return list(ElementTree.parse(TEXTS / f"labcal_{language}.ts").getroot().iter("message"))


@pytest.mark.parametrize("language", ["de", "fr"])
def test_the_window_has_one_word_for_it(language):
    sources = [one.findtext("source") for one in messages(language)]
    told = [one.findtext("translation") or "" for one in messages(language)]
    found = [text for text in sources if OTHER_NAMES["source"].search(text)]
    assert not [*found, *(text for text in told if OTHER_NAMES[language].search(text))]


def test_what_instruments_say_to_do_is_named_like_the_button():
    texts = [path.read_text(encoding="utf-8") for room in ("labcal", "drivers") for path in (HOME / room).rglob("*.py")]
    assert not [text for text in texts if re.search("begin this step again", text, re.IGNORECASE)]


def test_in_german_next_and_go_on_are_two_words():
    told = {one.findtext("source"): one.findtext("translation") or "" for one in messages("de")}
    go_on, following = told["Go on"], told["Next: {0}"].partition(":")[0]
    assert go_on != following
    of_next = [text for source, text in told.items() if re.search(r"\bNext\b", source or "")]
    assert of_next
    assert not [text for text in of_next if re.search(rf"\b{go_on}\b", text)]
