"""`python -m labcal.gui [--bench FILE]`: what `labcal gui` starts; with `--once PNG`, what `labcal self-test` does."""

from __future__ import annotations

import argparse
import gc
import os
import signal
import sys
from pathlib import Path

from labcal.files.home import SECRETS
from labcal.gui.ipc import named_archive
from labcal.system.garbage import collect_if_due
from labcal.system.private_memory import kept_private
from labcal.system.qt_packages import QT_PACKAGES

GARBAGE_MS = 500  # between two looks whether there is enough of it


def main() -> int:
    """Open the window; exit 2 with one sentence where Qt's system libraries are missing, or one is open already."""
    parser = argparse.ArgumentParser(prog="labcal gui", description="The technician's window.")
    parser.add_argument("--bench", help="the bench file; else the last one that was used")
    parser.add_argument("--once", type=Path, metavar="PNG", help="build every page, keep a picture, and close")
    parser.add_argument("--state", type=Path, help="keep here where the window stands, for who watches it")
    parser.add_argument("--after-crash", metavar="REPORT", help="the window before this one broke off")
    parser.add_argument("--page", default="", help="and stood on this page")
    parser.add_argument("--worker", type=int, default=0, metavar="PID", help="and its run goes on in this process")
    parser.add_argument("--archive", action="store_true", help="the archive's URL is a line on standard input")
    given = parser.parse_args()
    named_archive.take(sys.stdin.readline().strip() if given.archive else "")
    if named_archive.named() or any(name in os.environ for name in SECRETS):
        kept_private()
    gc.disable()  # see labcal.system.garbage
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # what is loaded has nothing to put in order yet
    try:
        from PySide6.QtWidgets import QApplication
    except ImportError as error:
        needed = " ".join(QT_PACKAGES)
        print(f"labcal gui: Qt does not load ({error}); on Debian: apt-get install {needed}", file=sys.stderr)
        return 2
    from PySide6.QtCore import QLocale, QTimer

    from labcal.gui.once import keep_picture
    from labcal.gui.one_window import OneWindow, to_front
    from labcal.gui.reopened import Shown
    from labcal.gui.standing import Standing, come_back
    from labcal.gui.theming.font import interface_font
    from labcal.gui.translations.translate import install_translator
    from labcal.gui.viewmodels.one_dut import KEPT
    from labcal.gui.viewmodels.window_settings import window_settings
    from labcal.gui.window import open_window

    application = QApplication(sys.argv[:1])
    application.setApplicationName("labcal")
    application.setFont(interface_font(application.font()))
    garbage = QTimer(application)
    garbage.timeout.connect(collect_if_due)
    garbage.start(GARBAGE_MS)
    chosen = str(window_settings().value("language", "") or "")
    install_translator(application, QLocale(chosen) if chosen else QLocale.system())
    only = OneWindow()
    if given.once is None and (other := only.take()):
        print(f"labcal gui: {other}", file=sys.stderr)
        return 2
    if not given.after_crash:
        window_settings().remove(KEPT)
    window = open_window(given.bench, watched=given.state is not None, worker=given.worker)
    shown = Shown(window, lambda window: Standing(window, given.state))
    only.knocked.connect(lambda: to_front(shown.window))
    sys.excepthook = shown.window.app_state.handle_exception
    # Ctrl-C is no exception within whatever Qt just calls, where it would be lost, but what closing the window is.
    signal.signal(signal.SIGINT, lambda *_: QTimer.singleShot(0, lambda: shown.window.leave(resumed_later=True)))
    if given.after_crash:
        come_back(shown.window, given.page, given.after_crash, ran=bool(given.worker))
    try:
        return application.exec() if given.once is None else keep_picture(shown.window, given.once)
    finally:
        shown.window.app_state.close()
        only.let_go()


if __name__ == "__main__":
    sys.exit(main())
