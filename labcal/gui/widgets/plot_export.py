"""A picture saved, or its numbers copied, by one click."""

from __future__ import annotations

from collections.abc import Callable
from itertools import zip_longest
from pathlib import Path

import numpy as np
import pyqtgraph as pg
from PySide6.QtWidgets import QApplication, QFileDialog, QPushButton, QWidget

from labcal.files.atomic import replacing
from labcal.files.outputs import claim
from labcal.files.spreadsheet import shielded
from labcal.files.text_safety import one_line
from labcal.gui.translations.translate import translated
from labcal.gui.widgets.common import button

PICTURE = "PNG (*.png)"


def export_buttons(parent: QWidget, picture: Callable[[], QWidget]) -> tuple[QPushButton, QPushButton]:
    """Two buttons for what `picture` gives when they are clicked."""

    def save_as() -> None:
        out, _ = QFileDialog.getSaveFileName(parent, title, str(Path.home() / "picture.png"), PICTURE)
        if out:
            save(picture(), out)

    title = translated("Save the picture")
    saver = button(translated("Save …"), translated("Write this picture to a .png file, as it is shown"))
    copier = button(
        translated("Copy"), translated("Every point that is drawn to the clipboard, as columns x and y of each curve")
    )
    saver.clicked.connect(save_as)
    copier.clicked.connect(lambda: QApplication.clipboard().setText(numbers(picture())))
    return saver, copier


def save(picture: QWidget, out: str) -> None:
    """Write a picture to the .png file `out`, whole or not at all; a dialogue has asked for just this name.

    Raises InputError where no picture may lie there.
    """
    named = out if out.lower().endswith(".png") else f"{out}.png"
    [output] = claim("picture", Path(named), force=named == out)
    with output.writing() as file, replacing(file) as part:
        picture.grab().save(str(part), "PNG")


def numbers(picture: QWidget) -> str:
    """The points of every curve and cloud in `picture`, columns apart by tabs, with the axes' names above."""
    columns: list[list[str]] = []
    plots = [picture] if isinstance(picture, pg.PlotWidget) else picture.findChildren(pg.PlotWidget)
    for plot in plots:
        names = [shielded(one_line(plot.getPlotItem().getAxis(side).labelText)) for side in ("bottom", "left")]
        for item in plot.getPlotItem().items:
            columns += [[name, *texts(values)] for name, values in zip(names, points(item), strict=False)]
    return "\n".join("\t".join(row) for row in zip_longest(*columns, fillvalue=""))


def points(item: object) -> tuple[object, ...]:
    """The x and y of a curve, a cloud or bars; nothing of what is only a line or a band."""
    if isinstance(item, pg.BarGraphItem):
        return item.opts["x0"], item.opts["height"]
    if isinstance(item, (pg.PlotDataItem, pg.PlotCurveItem, pg.ScatterPlotItem)):
        return tuple(item.getData())
    return ()


def texts(values: object) -> list[str]:
    """Numbers as a table takes them; nothing where there is none."""
    return ["" if np.isnan(value) else f"{value:.9g}" for value in np.asarray([] if values is None else values, float)]
