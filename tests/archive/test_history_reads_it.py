"""The window's History on a real PostgreSQL: found, sorted, drawn and fetched; away in words; nothing is written."""

from __future__ import annotations

import json
import os
import socket
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from conftest import Bundle, rows_of
from made_lab import GOLDEN
from postgres import Server
from PySide6.QtCore import QSettings, Qt

from labcal.errors import InputError
from labcal.files.home import home
from labcal.gui.pages.history import HistoryPage
from labcal.gui.theming.theme import LIGHT
from labcal.gui.viewmodels.app_state import AppState
from labcal.session import archiving, import_bundle
from labcal.store import load_bundle
from labcal.system.window_watch import once

CANARY = "c4nary"
LONG_MS = 180_000  # for a busy machine; what does not come true fails
HERE, ARCHIVE = 0, 1
Wait = Callable[[Callable[[], bool]], None]


@pytest.fixture
def wait(qtbot: Any) -> Wait:
    return lambda true: qtbot.waitUntil(true, timeout=LONG_MS)


@contextmanager
def history(place: Path) -> Iterator[HistoryPage]:
    app_state = AppState(QSettings(str(place / "window.ini"), QSettings.Format.IniFormat))
    page = HistoryPage(app_state, LIGHT)
    page.show()
    try:
        yield page
    finally:
        app_state.close()
        page.close()


def look_at(page: HistoryPage, place: int) -> None:
    page.place.setCurrentIndex(place)
    page.place.activated.emit(place)


def column(page: HistoryPage, number: int) -> list[str]:
    return [page.table.text(row, number) for row in range(page.table.rowCount())]


def test_runs_of_all_sites_are_found_sorted_and_fetched_and_nothing_is_written(
    postgres: Server, database: str, url: str, bundle: Bundle, tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch, wait: Wait,
) -> None:  # fmt: skip
    other = url.replace("site=aalto", "site=glasgow")
    archiving.push(url, [str(bundle()), str(bundle("x-1", "SN-3"))])
    archiving.push(other, [str(bundle(serial="SN-2"))])
    there = rows_of(postgres, database)
    monkeypatch.setenv("LABCAL_ARCHIVE", url.replace("//keeper@", f"//keeper:{CANARY}@"))
    monkeypatch.setenv("LABCAL_HOME", str(tmp_path / "another bench"))
    with history(tmp_path) as page:
        look_at(page, ARCHIVE)
        wait(lambda: page.table.rowCount() == 3)
        assert page.empty.isHidden()
        page.sort_by(5)
        assert column(page, 5) == ["aalto", "aalto", "glasgow"]
        assert page.table.model().headerData(5, Qt.Orientation.Horizontal) == "site"
        page.search.setText("demo-0 glasgow")
        assert column(page, 1) == ["SN-2"]
        page.search.setText("demo-0")
        page.table.selectRow(column(page, 5).index("glasgow"))
        assert [one.dut_serial for one in page.chosen_runs()] == ["SN-2"]  # though another is called the same
        assert not any(one.isVisible() for one in (page.open, page.compare, page.correct, page.take))
        out = tmp_path / "fetched.zip"
        page.export_to(page.chosen_runs()[0], "bundle", str(out))
        wait(out.exists)
        assert load_bundle(out).sha256 == load_bundle(bundle(serial="SN-2")).sha256
        process = page._app_state.archived.worker.pid
        assert CANARY not in Path(f"/proc/{process}/cmdline").read_text()
        look_at(page, HERE)
        wait(lambda: page.table.rowCount() == 0)
        assert page.open.isVisible()
    assert rows_of(postgres, database) == there
    assert not (home() / "runs.sqlite").exists()


def test_the_trend_of_a_dut_is_that_of_all_benches(
    url: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, wait: Wait
) -> None:
    stated = json.loads((GOLDEN / "calibration-2.json").read_text())
    for site, offset, day in (("aalto", 0.0, 1), ("glasgow", 40.0, 2)):
        path = tmp_path / site / "cal.json"
        path.parent.mkdir()
        moved = [k + offset for k in stated["k_nT"]]
        path.write_text(json.dumps(stated | {"k_nT": moved, "issued_utc": f"2026-05-0{day}T10:00:00Z"}))
        path.with_name("cal.json.sshsig").write_text("no one's\n")
        assert archiving.push(url.replace("site=aalto", f"site={site}"), [str(path)]).refused == ()
    monkeypatch.setenv("LABCAL_ARCHIVE", url)
    with history(tmp_path) as page:
        page._app_state.lab.update(dut_serial=stated["dut"]["serial"])
        look_at(page, ARCHIVE)
        wait(lambda: len(page.trend._files) == 2)
        x = [next(one.value for one in file.figures if one.quantity == "offset x") for file in page.trend._files]
        assert abs(x[1] - x[0]) > 30
        assert page.trend._times[1] - page.trend._times[0] == 86_400


def test_an_archive_that_is_away_is_said_in_words_and_read_when_it_is_back(
    postgres: Server, database: str, url: str, bundle: Bundle, tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch, wait: Wait,
) -> None:  # fmt: skip
    archiving.push(url, [str(bundle())])
    monkeypatch.setenv("LABCAL_ARCHIVE", url)
    with history(tmp_path) as page, postgres.connect() as connection:
        connection.execute(f"ALTER DATABASE {database} RENAME TO hidden")
        look_at(page, ARCHIVE)
        wait(lambda: "The archive was not read." in page.empty.text())
        connection.execute(f"ALTER DATABASE hidden RENAME TO {database}")
        assert "the archive cannot be reached" in page.empty.text()
        assert (page.empty.isVisible(), page.table.rowCount()) == (True, 0)
        page.refresh()
        wait(lambda: page.table.rowCount() == 1)
        assert not page.empty.isVisible()


def test_one_that_never_answers_keeps_nobody_waiting(
    bundle: Bundle, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, wait: Wait
) -> None:
    import_bundle(bundle())
    with socket.create_server(("127.0.0.1", 0)) as silent:
        place = f"postgresql://keeper@127.0.0.1:{silent.getsockname()[1]}/lab?connect_timeout=600"
        monkeypatch.setenv("LABCAL_ARCHIVE", place)
        with history(tmp_path) as page:
            wait(lambda: page.table.rowCount() == 1)
            look_at(page, ARCHIVE)
            assert (page.empty.text(), page.table.rowCount()) == ("Asking the archive …", 0)
            look_at(page, HERE)
            wait(lambda: not page._app_state.quick_worker.busy)
            import_bundle(bundle("x-1"))
            page.refresh()
            wait(lambda: page.table.rowCount() == 2)
            assert page._archived.asked  # and goes on waiting


def test_a_database_without_a_catalogue_gets_none_by_being_looked_at(postgres: Server) -> None:
    empty = postgres.database()
    with pytest.raises(InputError, match="its owner makes it by `labcal archive init`"):
        archiving.archived_runs(postgres.url(empty))
    with postgres.connect(empty) as connection:
        assert connection.execute("SELECT to_regnamespace('labcal')").fetchone() == (None,)


def test_without_an_archive_there_is_nothing_to_choose(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("LABCAL_ARCHIVE", raising=False)
    with history(tmp_path) as page:
        assert not page.place.isVisible()
        assert page.search.isVisible()


@pytest.mark.skipif(not Path("/proc/self/environ").exists(), reason="there is no /proc here")
def test_the_window_is_told_the_url_where_nobody_else_reads_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    place = f"postgresql://keeper:{CANARY}@db.example/lab"
    monkeypatch.setenv("LABCAL_ARCHIVE", place)
    looked = (
        "import sys; from pathlib import Path; "
        f"Path({str(tmp_path / 'line')!r}).write_text(sys.stdin.read()); "
        f"Path({str(tmp_path / 'argv')!r}).write_text(str(sys.argv)); "
        f"Path({str(tmp_path / 'seen')!r}).write_bytes(Path('/proc/self/environ').read_bytes())"
    )
    assert once([sys.executable, "-c", looked]).code == 0
    assert (tmp_path / "line").read_text() == f"{place}\n"
    assert "'--archive'" in (tmp_path / "argv").read_text()
    assert not any(CANARY in (tmp_path / name).read_text() for name in ("argv", "seen"))
    assert os.environ["LABCAL_ARCHIVE"] == place


BEGUN = """
import ctypes, subprocess, sys
sys.modules["PySide6.QtWidgets"] = None  # it ends where Qt does not load
sys.argv = ["labcal.gui", *sys.argv[1:]]
from labcal.gui.__main__ import main
from labcal.gui.ipc.named_archive import named
code = main()
opened = subprocess.run(["env"], capture_output=True, text=True, check=True).stdout
print(code, named(), "LABCAL_ARCHIVE" in opened, ctypes.CDLL(None).prctl(3, 0, 0, 0, 0))
"""


@pytest.mark.skipif(sys.platform != "linux", reason="prctl is Linux's")
@pytest.mark.parametrize("by", ["a line", "the environment"])
def test_what_the_window_opens_does_not_have_the_url_and_no_dump_either(by: str) -> None:
    place = f"postgresql://keeper:{CANARY}@db.example/lab"
    words = [sys.executable, "-c", BEGUN, *(["--archive"] if by == "a line" else [])]
    environment = {name: value for name, value in os.environ.items() if name != "LABCAL_ARCHIVE"}
    environment |= {"LABCAL_ARCHIVE": place} if by == "the environment" else {}
    done = subprocess.run(words, env=environment, input=f"{place}\n", capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["2", place, "False", "0"], done.stderr
