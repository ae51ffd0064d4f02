"""The window opened once, every page built, a picture kept: what `labcal self-test` looks at."""

from __future__ import annotations

import sys
import time
from pathlib import Path

from PySide6.QtWidgets import QApplication, QWidget

from labcal.gui.widgets.fault_card import FaultCard
from labcal.gui.window import Window

PATIENCE_S = 60.0


def keep_picture(window: Window, file: Path) -> int:
    """Build all pages and save the first as PNG; exit code 1, with a sentence, where one cannot be shown."""
    for name, lazy_page in window.lazy_pages.items():
        window.open_page(name)
        lazy_page.built()
    if broken := [name for name, lazy_page in window.lazy_pages.items() if cannot_be_shown(lazy_page.built())]:
        print(f"pages that cannot be built: {', '.join(broken)}", file=sys.stderr)
        return 1
    window.open_page(next(iter(window.lazy_pages)))
    if not _shown(window):
        print("the window was opened, and not shown within a minute", file=sys.stderr)
        return 1
    if not window.grab().save(str(file), "PNG"):
        print(f"{file}: no picture could be written", file=sys.stderr)
        return 1
    return 0


def cannot_be_shown(page: QWidget) -> bool:
    """Whether a card that says so stands in the place of the page."""
    return any(card.fault is not None and card.fault.kind == "page" for card in page.findChildren(FaultCard))


def _shown(window: Window) -> bool:
    """Whether it came up and was styled, which it has some time for."""
    until = time.monotonic() + PATIENCE_S
    window.style_queue.finish()
    while not window.windowHandle().isExposed():
        if time.monotonic() > until:
            return False
        QApplication.processEvents()
        time.sleep(0.01)
    QApplication.processEvents()
    return True
