"""Pages of other packages: they stand in the sidebar like ours, and one that breaks is a card and stops nothing."""

import sys
from importlib.metadata import EntryPoint
from types import ModuleType

import pytest
from PySide6.QtCore import QObject
from PySide6.QtWidgets import QPushButton, QVBoxLayout, QWidget

from labcal.gui.pages import lazy_page, registry
from labcal.gui.theming.theme import DARK, LIGHT
from labcal.gui.widgets.fault_card import FaultCard
from labcal.gui.widgets.idle_queue import IdleQueue


class Good(QWidget):
    """A page like any other: in two parts, and in the theme's colours."""

    def __init__(self, app_state, theme):
        super().__init__()
        self.colour, self.left = theme.name, 2
        self.words = QPushButton(app_state.lab.state.operator)
        QVBoxLayout(self).addWidget(self.words)

    def build_more(self):
        self.left -= 1
        return self.left >= 0

    def set_theme(self, theme):
        self.colour = theme.name


class Raising(QWidget):
    def __init__(self, app_state, theme):
        raise ValueError("no coil log here")


class Exiting(Good):
    def build_more(self):
        sys.exit(3)


def no_widget(app_state, theme):
    return "a text"


@pytest.fixture
def foreign(monkeypatch):
    """An entry point of another package, by the attribute of its module."""
    module = ModuleType("coil_log")
    module.Good, module.Raising, module.Exiting, module.no_widget = Good, Raising, Exiting, no_widget
    monkeypatch.setitem(sys.modules, "coil_log", module)
    return lambda what, name="Coil log": EntryPoint(name, f"coil_log:{what}", registry.GROUP)


@pytest.fixture
def opened(still):
    """A page in its place, as the window builds it."""

    def opened(entry):
        page = lazy_page.LazyPage(entry, still.app_state, lambda: still.theme, still.sheet)
        page.built()
        return page

    return opened


def test_every_page_of_ours_is_registered_as_a_stranger_s_is_and_comes_first(foreign, monkeypatch):
    mine = [foreign("Good"), foreign("Good", "Bench"), foreign("Good", "A first one")]
    monkeypatch.setattr(registry, "entry_points", lambda group: mine)
    ours = [entry.name for entry in registry.OUR_PAGES]
    assert list(registry.pages()) == [*ours, "A first one", "Bench (coil_log)", "Coil log"]


def test_a_stranger_s_page_is_built_whole_styled_and_follows_the_theme(foreign, opened):
    place = opened(foreign("Good"))
    page = place.page
    assert (page.left, page.words.text(), page.colour) == (-1, "J. Doe", LIGHT.name)
    assert page.words.styleSheet()
    for update in place.theme_updates(DARK):
        update()
    assert page.colour == DARK.name


@pytest.mark.parametrize(
    ("what", "words"),
    [
        ("Raising", ("fails as it is built: ValueError: no coil log here", "test_foreign_pages.py")),
        ("Exiting", ("fails as it is built: SystemExit: 3",)),
        ("no_widget", ("makes no QWidget but str",)),
        ("missing", ("fails as it is loaded: AttributeError",)),
    ],
)
def test_a_page_that_breaks_is_a_card_that_says_so(foreign, opened, still, what, words):
    place = opened(foreign(what))
    card = place.findChild(FaultCard)
    assert card.heading.text() == "✕ This page cannot be shown"
    for one in (f"'Coil log' of labcal.pages (coil_log:{what})", *words):
        assert one in card.text.text()
    assert "All other pages work" in card.remedy.text()
    assert card.details.toPlainText()
    assert place.ready
    assert list(place.theme_updates(DARK)) == []


def test_a_job_that_breaks_holds_up_none_of_the_others(qtbot, patience):
    parent, done = QObject(), []
    queue = IdleQueue(parent)
    queue.add(lambda: 1 / 0, lambda: done.append("the next"))
    with qtbot.capture_exceptions() as caught:
        qtbot.waitUntil(lambda: done == ["the next"], timeout=patience)
    assert [kind for kind, *_ in caught] == [ZeroDivisionError]


def test_the_window_lives_with_a_page_that_breaks_beside_ours(foreign, monkeypatch, tmp_path, deaf, windows, qapp):
    from PySide6.QtCore import QSettings

    from labcal.gui.prebuilding import import_pages
    from labcal.gui.viewmodels import app_state
    from labcal.gui.window import Window

    monkeypatch.setattr(app_state, "Client", lambda parent: deaf())
    monkeypatch.setattr(registry, "entry_points", lambda group: [foreign("missing", "Lost"), foreign("Good")])
    import_pages()
    window = Window(app_state.AppState(QSettings(str(tmp_path / "w.ini"), QSettings.Format.IniFormat)), LIGHT)
    windows.append(window)
    window.show()
    for name in window.lazy_pages:
        window.open_page(name)
        assert window.page(name).isVisible()
    assert isinstance(window.page("Coil log"), Good)
    assert window.page("Lost").findChild(FaultCard).isVisible()
    window.set_theme(DARK)
    window.style_queue.finish()
    window.close()
