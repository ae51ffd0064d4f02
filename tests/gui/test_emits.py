import subprocess
import sys

PROGRAM = """
from PySide6.QtCore import QCoreApplication, QObject, Signal
class Source(QObject):
    happened = Signal(object)
app, source, seen = QCoreApplication([]), Source(), []
source.happened.connect(lambda item: seen.append(item))
for n in range(20_000):
    source.happened.emit(True)
print(len(seen))
"""


def test_twenty_thousand_emits_leave_the_interpreter_whole():
    done = subprocess.run([sys.executable, "-c", PROGRAM], capture_output=True, text=True, timeout=60, check=False)
    assert (done.returncode, done.stdout.strip()) == (0, "20000"), done.stderr


def test_without_qt_the_window_says_what_to_install(tmp_path):
    (tmp_path / "PySide6.py").write_text("raise ImportError('libGL.so.1: cannot open shared object file')")
    program = (
        f"import sys; sys.path.insert(0, {str(tmp_path)!r}); sys.argv = ['x']; "
        "from labcal.gui.__main__ import main; sys.exit(main())"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 2
    assert "libGL.so.1" in done.stderr
    assert "apt-get install" in done.stderr
    assert "Traceback" not in done.stderr
