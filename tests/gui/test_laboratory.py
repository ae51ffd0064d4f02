"""Whose lab it is stands on the Start page: the name of the bench file or of labcal's folder, and the logo there."""

from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtGui import QColor, QImage

from labcal.gui.ipc.bench_commands import read_bench
from labcal.gui.ipc.messages import ReadBench
from labcal.gui.widgets.laboratory import HIGH, WIDE, Logo

BENCH = Path(__file__).parents[2] / "examples" / "simulated.toml"
STATED = 'name = "Field Laboratory"\ncity = "Bern"\ncountry = "CH"\n'


def name_of(bench):
    return read_bench(None, ReadBench(str(bench))).laboratory


def test_the_name_is_that_of_the_bench_file_else_of_the_folder(home_of_its_own, tmp_path):
    own = tmp_path / "own.toml"
    text = BENCH.read_text(encoding="utf-8")
    own.write_text(f"{text}\n[laboratory]\n{STATED.replace('Field', 'Cage')}", encoding="utf-8")
    assert (name_of(BENCH), name_of(own)) == ("", "Cage Laboratory")
    (home_of_its_own / "laboratory.toml").write_text(STATED, encoding="utf-8")
    assert (name_of(BENCH), name_of(own)) == ("Field Laboratory", "Cage Laboratory")
    (home_of_its_own / "laboratory.toml").write_text("name = 7", encoding="utf-8")
    assert name_of(BENCH) == ""


def test_the_start_page_says_it(still):
    still.open_page("Start")
    start, facts = still.page("Start"), still.app_state.facts
    assert not start.laboratory.isVisible()
    still.app_state.facts = replace(facts, laboratory="Field <b>Laboratory</b>")
    still.app_state.bench_changed.emit()
    assert start.laboratory.isVisible()
    assert start.laboratory.text() == "Field <b>Laboratory</b>"
    still.app_state.facts = facts
    still.app_state.bench_changed.emit()


@pytest.mark.parametrize("name", ["logo.svg", "logo.png"])
def test_the_logo_of_the_folder_is_shown_small_and_whole(qtbot, home_of_its_own, name):
    logo = Logo()
    qtbot.addWidget(logo)
    assert logo.isHidden()
    draw(home_of_its_own / name)
    logo.look()
    assert not logo.isHidden()
    assert (logo.pixmap().width(), logo.pixmap().height()) == (WIDE, WIDE // 4)
    assert logo.pixmap().toImage().pixelColor(20, 10).green() > 100
    assert HIGH >= WIDE // 4


def test_what_is_no_picture_is_no_logo(qtbot, home_of_its_own):
    (home_of_its_own / "logo.png").write_bytes(b"no picture")
    logo = Logo()
    qtbot.addWidget(logo)
    assert logo.isHidden()


def draw(file):
    if file.suffix == ".svg":
        rectangle = '<rect width="400" height="100" fill="#00c000"/>'
        words = f'<svg xmlns="http://www.w3.org/2000/svg" width="400" height="100">{rectangle}</svg>'
        return file.write_text(words, encoding="utf-8")
    picture = QImage(400, 100, QImage.Format.Format_RGB32)
    picture.fill(QColor("#00c000"))
    return picture.save(str(file))
