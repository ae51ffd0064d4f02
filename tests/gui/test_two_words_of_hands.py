"""Whether hands may be in the lab has two words in each language, and no third: "Hands off" and "Hands may go in"."""

import re
from pathlib import Path
from xml.etree import ElementTree

import pytest

ROOT = Path(__file__).parents[2]
TS = ROOT / "labcal" / "gui" / "translations"
THIRD = re.compile(r"Hands out\b|[Kk]eeps? hands out|[Hh]ands (?:are kept|stay) out|[Hh]ands (?:away|clear)")
WORDS = {
    "de": ("hände weg", "hände hinein dürfen|hände dürfen hinein"),
    "fr": ("mains loin", "mains puissent|mains peuvent"),
}


def sentences(language):
    """Source and translation of each sentence of the window."""
    for message in ElementTree.parse(TS / f"labcal_{language}.ts").iter("message"):
        yield message.findtext("source", ""), message.findtext("translation", "")


def test_english_has_no_third_word():
    assert [source for source, _ in sentences("de") if THIRD.search(source)] == []


@pytest.mark.parametrize("page", ["window.md", "safety.md"])
def test_nor_have_the_documents(page):
    assert THIRD.findall((ROOT / "docs" / page).read_text(encoding="utf-8")) == []


@pytest.mark.parametrize("language", ["de", "fr"])
def test_each_language_has_one_term_for_each(language):
    off, may = WORDS[language]
    for source, translation in sentences(language):
        if re.search(r"\bhands off\b", source, re.IGNORECASE):
            assert re.search(off, translation, re.IGNORECASE), source
        if re.search(r"\bhands may go in\b", source, re.IGNORECASE):
            assert re.search(may, translation, re.IGNORECASE), source
