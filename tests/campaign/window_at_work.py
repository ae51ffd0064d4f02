"""The window, without a screen, that holds a field on the bench of its first argument; prints its worker's process."""

from __future__ import annotations

import sys

from PySide6.QtCore import QSettings, QTimer
from PySide6.QtWidgets import QApplication

from labcal.gui.desk import Desk
from labcal.gui.theme import LIGHT
from labcal.gui.window import Window

app = QApplication([])
desk = Desk(QSettings(sys.argv[2], QSettings.Format.IniFormat))
window = Window(desk, LIGHT)
window.show()
desk.open_bench(sys.argv[1])
desk.who(operator="J. Doe")
begun = []


def look():
    if desk.facts and not begun:
        begun.append(True)
        desk.start("field-hold", {"duration_s": "600"})
    if desk.run.state == "asking":
        print(desk.bench_worker.pid, flush=True)
        desk.run.answer(desk.run.prompt.choices[0])
    if desk.run.state == "ended":
        sys.exit(desk.run.status)


timer = QTimer()
timer.timeout.connect(look)
timer.start(50)
app.exec()
