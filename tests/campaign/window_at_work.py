"""The window, without a screen, that holds a field on the bench of its first argument; prints its worker's process."""

from __future__ import annotations

import sys

from PySide6.QtCore import QSettings, QTimer
from PySide6.QtWidgets import QApplication

from labcal.gui.theming.theme import LIGHT
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.window import Window

app = QApplication([])
app_state = AppState(QSettings(sys.argv[2], QSettings.Format.IniFormat))
window = Window(app_state, LIGHT)
window.show()
app_state.open_bench(sys.argv[1])
app_state.set_identity(operator="J. Doe")
begun = []


def look():
    if app_state.facts and not begun:
        begun.append(True)
        app_state.start("field-hold", {"duration_s": "600"})
    if app_state.run.state == "asking":
        print(app_state.bench_worker.pid, flush=True)
        app_state.run.answer(app_state.run.prompt.choices[0])
    if app_state.run.state == "ended":
        sys.exit(app_state.run.status)


timer = QTimer()
timer.timeout.connect(look)
timer.start(50)
app.exec()
