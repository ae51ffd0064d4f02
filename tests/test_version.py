"""What is kept on this computer is called by the sources that made it: a version alone says the same for many days."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import pytest

from labcal.session import figures, working_out
from labcal.store import write_bundle
from labcal.testing.made_up_runs import made_up_run
from labcal.version import ROOMS, sources, sources_of

Change = Callable[[Path], object]


@pytest.fixture
def room(tmp_path: Path) -> Path:
    for name in ("fit/ml.py", "tables/supply.toml", "gui/window.py"):
        path = tmp_path / "labcal" / name
        path.parent.mkdir(parents=True)
        path.write_text(f"# {name}\n")
    return tmp_path / "labcal"


def another_digit(room: Path) -> None:
    (room / "fit/ml.py").write_text("# fit/ml.pz\n")


def another_table(room: Path) -> None:
    (room / "tables/supply.toml").write_text("")


def another_name(room: Path) -> None:
    (room / "fit/ml.py").rename(room / "fit/mm.py")


def one_more(room: Path) -> None:
    (room / "fit/empty.py").touch()


def the_window(room: Path) -> None:
    (room / "gui/window.py").write_text("")


def an_editor_s_lock(room: Path) -> None:
    (room / "fit/.#ml.py").symlink_to("somebody@here.1234")


def what_python_makes(room: Path) -> None:
    (room / "fit/ml.pyc").touch()


@pytest.mark.parametrize(
    ("change", "same"),
    [
        (another_digit, False),
        (another_table, False),
        (another_name, False),
        (one_more, False),
        (the_window, True),
        (what_python_makes, True),
        pytest.param(an_editor_s_lock, True, marks=pytest.mark.skipif(os.name != "posix", reason="links are POSIX's")),
    ],
)
def test_whatever_works_something_out_is_in_it(room: Path, change: Change, same: bool) -> None:
    before = sources_of([room])
    change(room)
    assert (sources_of([room]) == before) is same


def test_it_is_of_the_very_files_that_are_loaded() -> None:
    root = Path(working_out.__file__).parents[2]
    assert sources() == sources_of(root / room for room in ROOMS) != sources_of(root / room for room in ROOMS[:2])


def test_figures_of_another_day_are_worked_out_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write_bundle(made_up_run(rows=30).run, tmp_path / "run")
    run = str(tmp_path / "run")
    before = figures.place_of(run)
    monkeypatch.setattr(working_out, "sources", lambda: "another day")
    assert figures.place_of(run) != before
    assert working_out.version() == "0.1.0"  # what leaves the lab says the version
