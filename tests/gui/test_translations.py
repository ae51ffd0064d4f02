"""The window in another language: every word of it stands in the .ts file, and a translation changes what is seen."""

import re
import subprocess
from pathlib import Path

import PySide6
import pytest
from known_texts import KnownTexts
from PySide6.QtCore import QLocale, QTranslator
from PySide6.QtWidgets import QAbstractButton, QLabel, QLineEdit, QTableWidget, QWidget

from labcal.gui.frame import TopBar
from labcal.gui.pages.registry import OUR_PAGES, build_page
from labcal.gui.translations import translate

MARK = "§"
LRELEASE = next(Path(PySide6.__file__).parent.glob("lrelease*"), None)
TINY = """<?xml version="1.0" encoding="utf-8"?><!DOCTYPE TS><TS version="2.1" language="de">
<context><name>TopBar</name><message><source>DUT</source><translation>Prüfling</translation></message></context></TS>"""
DATA = {
    "labcal",
    "nT",
    "simulated cage",
    "EM-07",
    "J. Doe",
    "simulated.toml",
    "± U",
    "k, gain",
}  # what no language changes


@pytest.fixture
def marked(qapp):
    translator = KnownTexts(qapp, lambda text: MARK + text)
    qapp.installTranslator(translator)
    yield translator
    qapp.removeTranslator(translator)


def seen(page):
    """Every text that a person may read on a page, tool tips too."""
    for widget in page.findChildren(QWidget):
        yield widget.toolTip()
        if isinstance(widget, QLabel | QAbstractButton):
            yield widget.text()
        elif isinstance(widget, QLineEdit):
            yield widget.placeholderText()
        elif isinstance(widget, QTableWidget):
            yield from (widget.horizontalHeaderItem(n).text() for n in range(widget.columnCount()))


def unmarked(page):
    plain = (re.sub(r"<[^>]*>|&nbsp;|.*[/\\].*[.]toml|^\w+day, .*", "", text) for text in seen(page))
    return {text for text in plain if MARK not in text and re.search("[A-Za-z]{2}", text)} - DATA


def test_every_word_of_each_page_is_in_the_ts_file(new_window, marked):
    """In a window of its own: what two Run pages say of their forms to one state would be said of both."""
    missing = {}
    for entry in OUR_PAGES:
        page = build_page(entry, new_window.app_state, new_window.theme)
        try:
            missing[entry.name] = unmarked(page)
        finally:
            page.deleteLater()
    assert missing == {entry.name: set() for entry in OUR_PAGES}


def test_every_word_of_a_table_is_in_the_ts_file(marked):
    assert {text for text in translate.TEXTS if not translate.translated(text).startswith(MARK)} == set()


@pytest.mark.skipif(LRELEASE is None, reason="this PySide6 comes without lrelease, which makes the .qm file")
def test_a_tiny_translation_changes_one_word_of_the_window(qapp, qtbot, tmp_path):
    (tmp_path / "labcal_de.ts").write_text(TINY, encoding="utf-8")
    subprocess.run([LRELEASE, tmp_path / "labcal_de.ts"], check=True, capture_output=True)
    assert not translate.install_translator(qapp, QLocale("fr"), [tmp_path])
    before, before_that = qapp.children(), QLocale()
    assert translate.install_translator(qapp, QLocale("de_AT"), [tmp_path])
    added = [one for one in qapp.children() if isinstance(one, QTranslator) and one not in before]
    try:
        bar = TopBar()
        qtbot.addWidget(bar)
        assert {one.text() for one in bar.findChildren(QLabel)} >= {"Prüfling", "Operator"}
    finally:
        for translator in added:  # Qt's own of the language is among them
            qapp.removeTranslator(translator)
        QLocale.setDefault(before_that)


@pytest.mark.parametrize("language", ["de", "fr"])
def test_putting_a_card_away_has_one_word(language):
    """Its button was "Ablegen" on one card and "Schließen" on others, and the sentences named either."""
    text = (Path(translate.__file__).parent / f"labcal_{language}.ts").read_text(encoding="utf-8")
    pairs = re.findall(r"<source>([^<]*)</source>\s*<translation>([^<]*)</translation>", text)
    [word] = {said for source, said in pairs if source == "Close"}
    named = [(source, said) for source, said in pairs if re.search(r"\bClose, |\bPut (it|this \w+) away", source)]
    assert len(named) >= 6
    assert [pair for pair in named if word.lower() not in pair[1].lower()] == []
