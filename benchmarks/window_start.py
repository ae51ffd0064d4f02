"""From `labcal gui` to the first window: seconds until the frame is painted, and until the Start page stands in it.

    QT_QPA_PLATFORM=offscreen python benchmarks/window_start.py [TIMES]

The first time is with caches as cold as they happen to be, the others warm. Exit 1 where the window of one of the
others came after more than 2 s.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

BENCH = Path(__file__).parents[1] / "examples" / "simulated.toml"
IN_TIME_S = 2.0


def command_line() -> None:
    """Be `labcal gui`, which starts `watched` in place of the window."""
    begin = subprocess.Popen
    watched_window = [sys.executable, __file__, "watched"]

    def watched_instead(command: list[str], **how: Any) -> Any:
        is_window = "labcal.gui" in command
        return begin([*watched_window, *command[command.index("labcal.gui") + 1 :]] if is_window else command, **how)

    subprocess.Popen = watched_instead  # type: ignore[assignment, misc]
    from labcal.cli import main

    sys.argv = ["labcal", "gui", "--bench", str(BENCH)]
    main()


def watched() -> int:
    """Be the window: say when it and its first page were painted, and close it."""
    from labcal.gui import __main__ as program
    from labcal.gui import window as windows

    true_open = windows.open_window
    windows.open_window = lambda bench: _watch(true_open(bench))
    sys.argv = ["labcal gui", *sys.argv[2:]]
    return program.main()


def _watch(window: Any) -> Any:
    from PySide6.QtCore import QEvent, QObject, QTimer

    class Painted(QObject):
        """Says when a widget was first painted."""

        def eventFilter(self, watched: QObject, event: QEvent) -> bool:
            if event.type() == QEvent.Type.Paint:
                watched.removeEventFilter(self)
                QTimer.singleShot(0, window, lambda: print(time.monotonic(), time.process_time(), flush=True))
            return False

    def look() -> None:
        if window.lazy_pages["Start"].ready:
            window.lazy_pages["Start"].page.question.installEventFilter(painted)
            QTimer.singleShot(500, window, window.close)
        else:
            QTimer.singleShot(1, window, look)

    painted = Painted(window)
    window.centralWidget().installEventFilter(painted)
    look()
    return window


def once() -> tuple[float, float, float]:
    """Seconds to the window, of them the window's own work, and to its first page."""
    with tempfile.TemporaryDirectory(prefix="labcal-start-") as home:
        begun = time.monotonic()
        command = [sys.executable, __file__, "command line"]
        said = subprocess.run(command, env=os.environ | {"LABCAL_HOME": home}, check=True, stdout=subprocess.PIPE)
    shown, worked, first_page, _ = (float(word) for word in said.stdout.split())
    return shown - begun, worked, first_page - begun


def main() -> int:
    """Start it several times."""
    took = [once() for _ in range(int(sys.argv[1]) if len(sys.argv) > 1 else 4)]
    for shown, worked, first_page in took:
        print(f"window after {shown:.2f} s ({worked:.2f} s of its own work), its first page after {first_page:.2f} s")
    return int(max(shown for shown, _, _ in took[1:] or took) > IN_TIME_S)


if __name__ == "__main__":
    sys.exit(command_line() if "command line" in sys.argv[1:] else watched() if "watched" in sys.argv[1:] else main())
