"""Which file is which is read by its name: no column of the dialog is cut, and nothing said of hands lies below it."""

import pytest
from PySide6.QtCore import QPoint, QRect
from PySide6.QtWidgets import QApplication, QFileDialog, QTreeView
from test_tenth_walk import in_language as in_language

LONG = "2026-11-30T203705-EM-07-preflight-bundle.json"  # as a run is exported


@pytest.mark.parametrize("size", [(1024, 700), (1280, 800), (1920, 1080)], ids=str)
@pytest.mark.parametrize("code", ["en", "de"])
def test_names_and_headings_of_its_columns_are_whole(new_window, qtbot, patience, tmp_path, in_language, size, code):
    (folder := tmp_path / "runs").mkdir()
    (folder / LONG).write_text("{}")
    in_language(code)
    new_window.resize(*size)
    new_window.show()
    QApplication.processEvents()  # a window is laid out long before anybody opens a file in it
    dialog = QFileDialog(new_window, "Import a run", str(folder))
    dialog.setOption(QFileDialog.Option.DontUseNativeDialog)
    dialog.setViewMode(QFileDialog.ViewMode.Detail)
    dialog.show()
    tree = dialog.findChild(QTreeView, "treeView")
    qtbot.waitUntil(lambda: tree.model().rowCount(tree.rootIndex()) == 1, timeout=min(patience, 10_000))
    qtbot.wait(50)
    header = tree.header()
    needed = [max(tree.sizeHintForColumn(n), header.sectionSizeHint(n)) for n in range(header.count())]
    assert [
        n for n, least in enumerate(needed) if not header.isSectionHidden(n) and header.sectionSize(n) < least
    ] == []
    assert header.length() <= tree.viewport().width()
    assert (dialog.width(), dialog.height()) <= (size[0], size[1])
    for one in (new_window.top, new_window.side):  # what is said of hands, and COILS OFF
        assert not dialog.frameGeometry().intersects(QRect(one.mapToGlobal(QPoint(0, 0)), one.size()))
    dialog.close()
