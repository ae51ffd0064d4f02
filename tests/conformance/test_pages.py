"""Our own pages, held to what `labcal.testing` asks of others', and pages that break it."""

from __future__ import annotations

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QPushButton, QVBoxLayout, QWidget

from labcal.gui.ipc.messages import ListRuns
from labcal.gui.pages.registry import OUR_PAGES
from labcal.testing.pages import check_page


@pytest.mark.parametrize("name", [entry.name for entry in OUR_PAGES])
def test_a_page_of_ours(name: str, qapp: object) -> None:
    check_page(name)


class Plain(QWidget):
    """A page with one button."""

    def __init__(self, app_state: object, theme: object) -> None:
        super().__init__()
        self.button = QPushButton("Count")
        self.button.setToolTip("Count the runs")
        QVBoxLayout(self).addWidget(self.button)


class Begins(Plain):
    def __init__(self, app_state: object, theme: object) -> None:
        super().__init__(app_state, theme)
        app_state.bench_worker.request(ListRuns(), print, print)


class Wordless(Plain):
    def __init__(self, app_state: object, theme: object) -> None:
        super().__init__(app_state, theme)
        self.button.setText("")
        self.button.setToolTip("")


class Unreachable(Plain):
    def __init__(self, app_state: object, theme: object) -> None:
        super().__init__(app_state, theme)
        self.button.setFocusPolicy(Qt.FocusPolicy.NoFocus)


class Wide(Plain):
    def __init__(self, app_state: object, theme: object) -> None:
        super().__init__(app_state, theme)
        self.button.setMinimumWidth(2000)


class Endless(Plain):
    def build_more(self) -> bool:
        return True


class Raises(Plain):
    def __init__(self, app_state: object, theme: object) -> None:
        raise KeyError("coil log")


class Bare(QWidget):
    def __init__(self, app_state: object, theme: object) -> None:
        super().__init__()


def test_a_plain_page_passes(qapp: object) -> None:
    check_page(Plain)


@pytest.mark.parametrize(
    ("page", "says"),
    [
        (Begins, "asks the bench worker for ListRuns as it is shown: a person's click begins such work"),
        (Wordless, "has no words: give it a text or an accessible name"),
        (Unreachable, "is not found by Tab"),
        (Wide, "the smallest window has 1024 × 700: let texts wrap"),
        (Endless, "says for ever that a part was missing"),
        (Raises, "fails as it is built: KeyError: 'coil log'"),
        (Bare, "has no layout"),
        (lambda app_state, theme: "a text", "makes no QWidget but str"),
        ("Coil log", "There is no page 'Coil log'; there are Start, Bench"),
    ],
)
def test_a_page_that_breaks_its_protocol(page: object, says: str, qapp: object) -> None:
    with pytest.raises(AssertionError, match=says):
        check_page(page)
