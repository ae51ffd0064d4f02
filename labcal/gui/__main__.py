"""`python -m labcal.gui [--bench FILE]`: what `labcal gui` starts."""

from __future__ import annotations

import argparse
import sys

NEEDED = "libglib2.0-0 libgl1 libegl1 libfontconfig1 libxkbcommon0 libdbus-1-3 libxcb-cursor0"


def main() -> int:
    """Open the window; exit 2 with one sentence where Qt's system libraries are missing."""
    parser = argparse.ArgumentParser(prog="labcal gui", description="The technician's window.")
    parser.add_argument("--bench", help="the bench file; else the last one that was used")
    given = parser.parse_args()
    try:
        from PySide6.QtWidgets import QApplication
    except ImportError as error:
        print(f"labcal gui: Qt does not load ({error}); on Debian: apt-get install {NEEDED}", file=sys.stderr)
        return 2
    from PySide6.QtCore import QLocale

    from labcal.gui.reopened import Shown
    from labcal.gui.translations.translate import install_translator
    from labcal.gui.viewmodels.app_state import window_settings
    from labcal.gui.window import open_window

    application = QApplication(sys.argv[:1])
    application.setApplicationName("labcal")
    chosen = str(window_settings().value("language", "") or "")
    install_translator(application, QLocale(chosen) if chosen else QLocale.system())
    shown = Shown(open_window(given.bench))
    sys.excepthook = shown.window.app_state.handle_exception
    code = application.exec()
    shown.window.app_state.close()
    return code


if __name__ == "__main__":
    sys.exit(main())
