"""What finds cut text by geometry finds it: in labels, and in what is painted into plots, tables and drawings."""

from geometry import faults
from PySide6.QtCore import QRectF
from PySide6.QtWidgets import QApplication, QHeaderView, QLabel, QPushButton, QVBoxLayout, QWidget

from labcal.gui.theming.theme import LIGHT
from labcal.gui.widgets.measurement_table import Table
from labcal.gui.widgets.mounting_view import Mounting
from labcal.gui.widgets.plots import plot


def test_what_is_cut_and_what_overlaps_is_found(qtbot):
    holder = QWidget()
    qtbot.addWidget(holder)
    QVBoxLayout(holder)
    whole, cut, over = QLabel("whole"), QLabel("a text that is cut"), QPushButton("over it")
    for n, one in enumerate((whole, cut, over)):
        one.setParent(holder)
        one.setGeometry(10, 10 + 60 * n, 200, 40)
    holder.resize(300, 300)
    holder.show()
    assert faults(holder) == []
    cut.setFixedWidth(20)
    assert [one.split(" needs ")[0] for one in faults(holder)] == ["QLabel 'a text that is cut'"]
    cut.setFixedWidth(200)
    over.move(100, 20)
    assert ["lie over each other" in one for one in faults(holder)] == [True]
    over.move(250, 200)
    assert ["is cut by what holds it" in one for one in faults(holder)] == [True]


def test_what_is_painted_and_cut_is_found(qtbot):
    picture, table = plot(LIGHT, "time  s", "field of the reference  nT"), Table(("name",))
    qtbot.addWidget(holder := QWidget())
    for n, one in enumerate((picture, table)):
        one.setParent(holder)
        one.setGeometry(10, 10 + 220 * n, 280, 200)
    holder.resize(300, 440)
    holder.show()
    table.setRowCount(1)
    table.set_cell(0, 0, "a name that is as long as this one is not")
    settled(picture)
    assert faults(holder) == []
    table.item(0, 0).setToolTip("")
    table.horizontalHeader().setStretchLastSection(False)
    table.horizontalHeader().setSectionResizeMode(0, QHeaderView.ResizeMode.Fixed)
    table.setColumnWidth(0, 60)
    picture.getPlotItem().getAxis("left").label.setScale(3.0)
    name, cell = faults(holder)
    assert "reaches out of its plot" in name
    assert "is cut" in cell
    drawing = Mounting(LIGHT)
    drawing.names = {"body X": QRectF(0, 0, 50, 20), "cage X": QRectF(40, 0, 50, 20)}
    drawing.setParent(holder)
    drawing.show()
    assert "'body X' and 'cage X' lie over each other" in faults(holder)


def settled(picture):
    """Plots lay out what is within them when they are drawn."""
    for _ in range(3):
        picture.grab()
        QApplication.processEvents()
