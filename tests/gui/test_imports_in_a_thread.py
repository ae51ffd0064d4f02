"""The pages' modules are imported by a thread while the window asks Qt for types of its own."""

import os
import subprocess
import sys

import pytest

BOTH_ASK = """
import faulthandler, random, sys, threading
faulthandler.enable()
sys.setswitchinterval(1e-6)
import labcal.gui
from PySide6 import QtCore, QtGui, QtWidgets
app = QtWidgets.QApplication([])

def imports():
    import pyqtgraph
    import labcal.gui.pages.run, labcal.gui.pages.fit, labcal.gui.pages.history

thread = threading.Thread(target=imports)
thread.start()
modules = (QtWidgets, QtGui, QtCore)
names = [name for module in modules for name in dir(module) if name.startswith("Q")]
random.Random(int(sys.argv[1])).shuffle(names)
asked = 0
while thread.is_alive():
    app.processEvents()
    for module in modules:
        getattr(module, names[asked % len(names)], None)
    asked += 1
thread.join()
"""


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(20))
def test_no_two_threads_make_one_type_of_qt(seed: int) -> None:
    """With PySide's types made when they are asked for, one in ten to twenty of these ends in a segmentation fault."""
    done = subprocess.run(
        [sys.executable, "-c", BOTH_ASK, str(seed)],
        env={**os.environ, "QT_QPA_PLATFORM": "offscreen"}, capture_output=True, text=True, check=False, timeout=120,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr[-2000:]
