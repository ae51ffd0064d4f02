"""Windows whose workers are all deaf, with settings of their own, and how one is taken apart again."""

from contextlib import contextmanager
from functools import cache

import pytest
from pyqtgraph import PlotWidget
from PySide6.QtCore import QSettings
from shiboken6 import delete, isValid

from labcal.gui.theming.theme import LIGHT
from labcal.gui.viewmodels.app_state import AppState
from labcal.testing.pages import DeafWorker


def take_apart(window):
    """Close a window and delete what Qt has of it, in Qt's order: the collector's, of plots, brings Qt down.

    What lived on would be styled and translated with each window that comes after.
    """
    if isValid(window):
        window.leave()
        of_plots = [plot.getPlotItem() for plot in window.findChildren(PlotWidget)]
        menus = [menu for item in of_plots for menu in (item.ctrlMenu, item.vb.menu) if menu is not None]
        delete(window)
        for menu in menus:  # nothing of the window holds them
            delete(menu)


def settings_in(folder):
    settings = QSettings(str(folder / "window.ini"), QSettings.Format.IniFormat)
    settings.setValue("pace", "at once")
    settings.setValue("seed", 3)
    return settings


def build_what_is_in_sight(window):
    """In place of all pages: most tests look at one or two."""
    for lazy_page in window.lazy_pages.values():
        if lazy_page.isVisible():
            lazy_page.built()


@cache
def every_procedure():
    """Looked up once: they are the same for every window."""
    from labcal.gui.ipc.bench_commands import procedures
    from labcal.gui.ipc.messages import ListProcedures

    return procedures(None, ListProcedures())


@contextmanager
def deaf_window_at(home):
    """A window whose workers are all deaf: no process is started."""
    from labcal.gui.ipc.messages import ListProcedures
    from labcal.gui.viewmodels import app_state
    from labcal.gui.window import Window

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(app_state, "Client", DeafWorker)
        patch.setattr(Window, "prebuild", build_what_is_in_sight)
        window = Window(AppState(settings_in(home)), LIGHT)
    window.show()
    window.size_at_first = window.size()
    window.open_page("Run")
    window.page("Run")
    window.procedures = every_procedure()
    window.app_state.quick_worker.answer(ListProcedures, window.procedures)
    try:
        yield window
    finally:
        take_apart(window)
