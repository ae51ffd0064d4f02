"""A day in a language that says everything in dots: what can still be read is data, or nobody has translated it."""

import re
from collections import defaultdict
from importlib.metadata import entry_points
from pathlib import Path
from shutil import copytree

import pyqtgraph
import pytest
from known_texts import KnownTexts
from PySide6.QtCore import QDate, QLocale
from PySide6.QtGui import QPainter, QTextDocument
from PySide6.QtWidgets import (
    QAbstractButton,
    QComboBox,
    QGroupBox,
    QLabel,
    QLineEdit,
    QListWidget,
    QPlainTextEdit,
    QTableWidget,
    QTabWidget,
    QWidget,
)

from labcal.fit.registry import METHODS
from labcal.model.effects import families
from labcal.runner import catalogue
from labcal.session.bench_settings import settings

SHORT = {"axes": "x,y,z", "magnitudes_nT": "20000", "reverse": "no", "modes": "nominal", "rate_deg_per_s": "20"}
EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"
DOTS = re.compile(r"(\{[^}]*\}|<[^>]*>|&\w+;|\bF\d+\b)|[^\W\d_]")


@pytest.fixture
def mute(qapp):
    translator = KnownTexts(qapp, lambda text: DOTS.sub(lambda found: found[1] or "·", text))
    qapp.installTranslator(translator)
    yield translator
    qapp.removeTranslator(translator)


@pytest.fixture
def painted(monkeypatch):
    """Texts that widgets paint by themselves."""
    said, draw = set(), QPainter.drawText

    def drawn(painter, *given):
        said.update(one for one in given if isinstance(one, str))
        return draw(painter, *given)

    monkeypatch.setattr(QPainter, "drawText", drawn)
    return said


def texts_of(window):
    """Every text that a person may read or hear of a window."""
    yield window.windowTitle()
    for one in window.findChildren(QWidget):
        yield from (one.toolTip(), one.accessibleName(), one.accessibleDescription())
        if isinstance(one, QLabel | QAbstractButton):
            yield one.text()
        elif isinstance(one, QGroupBox):
            yield one.title()
        elif isinstance(one, QLineEdit):
            yield one.placeholderText()
        elif isinstance(one, QPlainTextEdit):
            yield from (one.toPlainText(), one.placeholderText())
        elif isinstance(one, QComboBox):
            yield from (one.itemText(n) for n in range(one.count()))
        elif isinstance(one, QTabWidget):
            yield from (one.tabText(n) for n in range(one.count()))
            yield from (one.tabToolTip(n) for n in range(one.count()))
        elif isinstance(one, QListWidget):
            yield from (one.item(n).text() for n in range(one.count()))
            yield from (one.item(n).toolTip() for n in range(one.count()))
        elif isinstance(one, QTableWidget):
            cells = [one.item(r, c) for r in range(one.rowCount()) for c in range(one.columnCount())]
            cells += [one.horizontalHeaderItem(c) for c in range(one.columnCount())]
            yield from (text for cell in cells if cell is not None for text in (cell.text(), cell.toolTip()))
        elif isinstance(one, pyqtgraph.GraphicsView):
            yield from (item.toPlainText() for item in one.scene().items() if hasattr(item, "toPlainText"))
    yield window.message.text()


def data_words():
    """Words of names that no language changes: of procedures, effects, methods, instruments, units, files, people."""
    names = [*catalogue()[0], *METHODS, *(family.id for family in families())]
    names += [entry.name for group in ("labcal.drivers", "labcal.emulators") for entry in entry_points(group=group)]
    names += [key for one in settings(EXAMPLE)[1] for key in one.keys]
    names += re.findall(r"[\w.]+", EXAMPLE.read_text(encoding="utf-8"))
    names += [QLocale().toString(QDate(2026, month, 1), "dddd ddd MMMM MMM") for month in range(1, 13)]
    names += [QLocale().dayName(n) for n in range(1, 8)]
    return {word for name in names for word in words_of(name)} | DATA


UNITS = ("nT", "µT", "mT", "km", "mm", "Hz", "ppm", "deg", "degC")
SETTINGS = ("none", "inertial", "nadir")  # values that `--set` takes, in the tip that says so
OF_QT = ("Scroll", "Left", "Right", "Down", "Ctrl", "Tab")  # in Qt's own files: tests/gui/test_languages.py
WHO = ("THURLBY", "THANDAR", "PL", "QMT")  # the emulated supplies, as they name themselves
DATA = {
    "labcal",
    "Deutsch",
    "toml",
    "bx",
    "by",
    "bz",
    "rms",
    "json",
    "Kp",
    "square",
    "false",
    *UNITS,
    *SETTINGS,
    *OF_QT,
    *WHO,
}


def words_of(text):
    return re.findall(r"[^\W\d_]{2,}", text)


PLACES = re.compile(  # settings, elements, columns, files and addresses, who works here, serials and runs
    r"--set \w+=…|\bK [xyz]{2}\b|\b[a-z]+_\w+|\S*[/\\]\S*|\b\w+@\w+\b|J\. Doe|EM-\d+|"
    r"\d{8}T\d{6}\w*(-\w+)*|\bZaber device \d+"  # and the emulated stage, as it names itself
)


def readable(text):
    """What a person sees of it: without markup."""
    document = QTextDocument()
    document.setHtml(text) if re.search("<[a-z]", text) else document.setPlainText(text)
    return document.toPlainText()


def english(texts, data):
    found = defaultdict(set)
    for text in texts:
        for line in PLACES.sub(" ", readable(text or "")).splitlines():
            if left := [word for word in words_of(line) if word not in data]:
                found[line].update(left)
    return dict(found)


@pytest.mark.slow
def test_a_day_without_an_english_word(qtbot, tmp_path, drafted, monkeypatch, mute, painted, patience, window_on):
    monkeypatch.setenv("LABCAL_HOME", str(copytree(drafted, tmp_path / "home")))
    seen = defaultdict(set)

    with window_on(tmp_path / "home") as window:
        state, run, study = window.app_state, window.app_state.run, window.app_state.study_vm

        def look(where):
            seen[where].update(texts_of(window))

        def wait(until):
            qtbot.waitUntil(until, timeout=patience)

        wait(lambda: bool(state.facts))
        for page in window.lazy_pages:
            window.open_page(page)
            window.page(page)
            window.grab()
            look(page)
        window.open_page("Run")
        choose, live = window.page("Run").choose, window.page("Run").live
        wait(lambda: choose.form is not None)
        for procedure in catalogue()[0]:
            choose.choose(procedure)
            look("choose")
        choose.choose("preflight")
        for name, text in (SHORT | {"zero_s": "3"}).items():
            choose.form.set_text(name, text)
        choose.pace.setCurrentIndex(choose.pace.count() - 1)
        choose.rehearse()
        wait(lambda: choose.give_up.isHidden())
        look("plan")
        run.changed.connect(lambda: look("run"))
        run.item.connect(lambda _: look("run"))
        choose.start.click()
        while True:
            wait(lambda: run.state in ("asking", "ended"))
            window.grab()
            look("run")
            if run.state == "ended":
                break
            run.answer(run.prompt.choices[0] if run.prompt.choices else "EM-07")
        assert run.status == "finished", run.fault
        window.grab()
        look("over")
        live.fit.click()
        wait(lambda: "ml" in study.fits and not study.busy)
        study.progressed.connect(lambda: look("progress"))
        study.fit_all()
        wait(lambda: not study.busy)
        window.grab()
        look("fit")
        study.close_loop()
        wait(lambda: study.loop is not None)
        window.open_page("Loop")
        loop = window.page("Loop")
        loop.fold.click()
        look("loop")
        for row in (0, loop.others.rowCount() - 1):  # one that was looked at is worked out
            loop.others.selectRow(row)
            look("loop")
        wait(lambda: not study.busy)
        window.grab()
        look("loop")
        window.open_page("Certificate")
        page = window.page("Certificate")
        wait(lambda: page.list.count() > 0)
        window.grab()
        look("certificate")
        window.open_page("Bench")
        window.page("Bench").edit.click()
        wait(lambda: window.page("Bench").editor.table.rowCount() > 0)
        look("editor")
        window.open_page("History")
        history = window.page("History")
        wait(lambda: history.table.rowCount() == 2)
        history.table.selectAll()
        history.compare.click()
        wait(lambda: history.comparison.against.count() > 0)
        window.grab()
        look("comparison")
        window.show_keys()
        look("keys")
    data = data_words()
    seen["painted"] = painted
    left = {where: found for where, texts in seen.items() if (found := english(texts, data))}
    shown = {}
    for where, found in left.items():
        for line, words in found.items():
            shown.setdefault(line, (words, []))[1].append(where)
    print("\n".join(f"{line[:220]} {words} {where}" for line, (words, where) in sorted(shown.items())))
    assert left == {}
