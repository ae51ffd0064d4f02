"""What a page of the window is, and where pages are found: ours, then those of the entry-point group `labcal.pages`.

A package adds a page by one line of its pyproject.toml; the name is what stands in the sidebar:

    [project.entry-points."labcal.pages"]
    "Coil log" = "coil_log.page:CoilLogPage"
"""

from __future__ import annotations

from importlib.metadata import EntryPoint, entry_points
from typing import Protocol, runtime_checkable

from PySide6.QtWidgets import QWidget

from labcal import plugin_loading
from labcal.errors import InputError
from labcal.gui.theming.theme import Theme
from labcal.gui.viewmodels.app_state import AppState

GROUP = "labcal.pages"
OUR_PAGES = tuple(
    EntryPoint(name, f"labcal.gui.pages.{name.lower()}:{name}Page", GROUP)
    for name in ("Start", "Bench", "Run", "Fit", "Loop", "Certificate", "History")
)  # in the order of the work


class Page(Protocol):
    """How a page is made: called once in the window's thread, when it is first wanted. A QWidget class can be one.

    What it shows it takes from `app_state`: its view models and their signals, and `app_state.request` for whatever
    takes time. A page does not wait, and drives no instrument itself. What stands in its layouts is styled as ours is.
    """

    def __call__(self, app_state: AppState, theme: Theme, /) -> QWidget:
        """The page's widget, drawn in the colours of `theme`."""
        ...


@runtime_checkable
class Themed(Protocol):
    """A page, or any widget in it, that draws for itself. Style sheets need none of this."""

    def set_theme(self, theme: Theme) -> None:
        """Draw in the colours of `theme` from here on."""
        ...


@runtime_checkable
class BuiltInParts(Protocol):
    """A page that takes more than a few milliseconds to build, and does it in pieces."""

    def build_more(self) -> bool:
        """Build another part; says whether any was missing."""
        ...


def pages() -> dict[str, EntryPoint]:
    """Every page there is by its name in the sidebar; one whose name is taken has its module beside it."""
    found = {entry.name: entry for entry in OUR_PAGES}
    for entry in sorted(entry_points(group=GROUP), key=lambda e: (e.name, e.value)):
        found[entry.name if entry.name not in found else f"{entry.name} ({entry.module})"] = entry
    return found


def build_page(entry: EntryPoint, app_state: AppState, theme: Theme) -> QWidget:
    """The page that `entry` names. Raises InputError with the place of the fault where it cannot be built."""
    make: Page = plugin_loading.load(entry)
    with plugin_loading.blamed(plugin_loading.named(entry), "as it is built"):
        page = make(app_state, theme)
        if not isinstance(page, QWidget):
            raise InputError(f"{plugin_loading.named(entry)} makes no QWidget but {type(page).__name__}")
        return page


def build_more(entry: EntryPoint, page: QWidget) -> bool:
    """Build another part of a page that is built in parts; says whether any was missing. Raises InputError."""
    with plugin_loading.blamed(plugin_loading.named(entry), "as it is built"):
        return isinstance(page, BuiltInParts) and page.build_more()
