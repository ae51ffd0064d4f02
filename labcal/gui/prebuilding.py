"""What the window does ahead, while nobody waits for it: imports of its pages, and plots."""

from __future__ import annotations

from contextlib import suppress

from labcal import plugin_loading
from labcal.errors import InputError
from labcal.gui.pages.registry import pages

SPARE_PLOTS = 4  # of a page, at most, when it is built


def import_pages() -> None:
    """What the pages are made of takes a second to import: in a thread of its own, the window is alive meanwhile."""
    from labcal.store.items import prepare

    for entry in pages().values():
        with suppress(InputError):  # its card says so
            plugin_loading.load(entry)
    prepare()


def preallocate_plot() -> bool:
    """Make one more plot for the next page, unless there are enough; says whether there are."""
    from labcal.gui.widgets.plots import preallocate_plots

    return preallocate_plots(SPARE_PLOTS)
