"""`labcal gui` with its window killed in a run, on supplies of real lines: the run goes on, and is come back to."""

import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
from served_lab import LABCAL, Served, at_zero, example, guardians, until

from labcal import session
from labcal.files.home import home

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(sys.platform == "win32", reason="needs SIGKILL and ptys, which Windows lacks"),
]
WINDOW = Path(__file__).parent / "watched_window.py"
WATCH = "import sys; from labcal.system.window_watch import watch; sys.exit(watch(['--'], print, sys.argv[1:]))"
HELD = "duration_s=600"


@pytest.fixture
def lab(tmp_path, monkeypatch):
    monkeypatch.setenv("QT_QPA_PLATFORM", "offscreen")
    served = Served(tmp_path, monkeypatch, example())
    yield served
    served.close()
    until(lambda: not guardians())


@pytest.fixture
def watched(lab, tmp_path):
    """The window as it is watched; each of its starts does one deed."""
    begun = []

    def begin(*deeds):
        command = [sys.executable, "-c", WATCH, sys.executable, str(WINDOW), str(lab.file), str(tmp_path)]
        begun.append(
            subprocess.Popen([*command, "field-hold", HELD, *deeds], stdout=subprocess.PIPE, stderr=None, text=True)
        )
        return begun[0]

    yield begin
    for one in begun:
        one.terminate()
        one.wait()
        one.stdout.close()


def said(watched, word):
    """What follows the next line that begins with `word`."""
    heard = []
    for line in watched.stdout:
        heard.append(line)
        if line.startswith(word):
            return line.split()[1:]
    raise AssertionError(f"it never said {word}, but {heard}")


def on(lab):
    return max(lab.currents().values()) > 0.5


def test_the_run_goes_on_at_the_same_page_and_is_switched_off_from_the_new_window(lab, watched):
    window = watched("crash", "off")
    _, page, worker, *order = said(window, "there")
    until(lambda: on(lab))
    assert "broke off (SIGKILL)" in " ".join(said(window, "labcal gui:"))
    assert on(lab)
    assert said(window, "there") == ["1", page, worker, *order]  # the same process, the same page
    ended = " ".join(said(window, "ended"))
    assert ended.startswith("failed: aborted by the operator")  # for the record, and for the person:
    assert ended.endswith("field-hold: stopped by COILS OFF")
    assert at_zero(lab)
    assert window.wait(60) == 0
    [bundle] = (home() / "crashes").iterdir()
    with zipfile.ZipFile(bundle) as kept:
        assert '"worker": ' + worker in kept.read("state.json").decode()
        assert "J. Doe" not in "".join(kept.read(name).decode() for name in kept.namelist())


def test_labcal_bench_off_works_while_there_is_no_window(lab, watched):
    window = watched("crash", "late")
    said(window, "there")
    until(lambda: on(lab))
    said(window, "late")
    assert on(lab)
    off = subprocess.run([*LABCAL, "bench", "off", str(lab.file)], capture_output=True, text=True, check=False)
    assert at_zero(lab), off.stderr
    until(lambda: [one.status.partition(":")[0] for one in session.runs()] == ["failed"])


@pytest.mark.parametrize("deed", ["cannot", "never"])
def test_where_no_window_comes_back_the_coils_go_to_zero_and_the_run_may_be_gone_on_with(lab, watched, deed):
    window = watched("crash", deed)
    _, _, worker, *_ = said(window, "there")
    until(lambda: on(lab))
    until(lambda: at_zero(lab))
    until(lambda: [one.status for one in session.runs()] == ["interrupted"])
    until(lambda: not os.path.exists(f"/proc/{worker}"))
