"""The window under test: its own home, its own settings, the simulated bench at once."""

from pathlib import Path

import pytest
from PySide6.QtCore import QSettings

from labcal.gui.desk import Desk
from labcal.gui.theme import LIGHT

BENCH = Path(__file__).parents[2] / "examples" / "simulated.toml"


@pytest.fixture
def desk(qtbot, tmp_path, monkeypatch):
    monkeypatch.setenv("LABCAL_HOME", str(tmp_path))
    settings = QSettings(str(tmp_path / "window.ini"), QSettings.Format.IniFormat)
    settings.setValue("pace", "at once")
    settings.setValue("seed", 3)
    made = Desk(settings)
    yield made
    made.close()


@pytest.fixture
def window(qtbot, desk):
    from labcal.gui.window import Window

    made = Window(desk, LIGHT)
    qtbot.addWidget(made)
    made.show()
    desk.open_bench(str(BENCH))
    desk.who(operator="J. Doe")
    qtbot.waitUntil(lambda: bool(desk.facts), timeout=20_000)
    return made
