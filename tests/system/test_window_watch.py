"""A window that breaks off: a report without secrets is kept, and it is started again where it stood."""

import signal
import sys
import zipfile

import pytest

from labcal.system import window_watch
from labcal.system.window_watch import once, watch

CANARY = "a canary in the mine"
# A window of ours: each time it is started it notes its arguments, then does the next of what it is to do.
STAND_IN = """
import json, os, sys
place, *given = sys.argv[1:]
state = given[given.index("--state") + 1]
started = os.path.join(place, "started")
number = len(open(started).readlines()) if os.path.exists(started) else 0
open(started, "a").write(json.dumps(given) + "\\n")
open(os.path.join(place, "environment"), "w").write(json.dumps(dict(os.environ)))
open(state, "w").write(json.dumps({"page": "Fit", "run": {"id": "run-7"}, "bench": "bench.toml"}))
deed = open(os.path.join(place, "deeds")).read().split()[number]
print("doing", deed, file=sys.stderr, flush=True)
if deed == "leak": print(open(os.path.join(place, "canary")).read(), file=sys.stderr, flush=True)
if deed in ("abort", "leak"): os.abort()
if deed == "plugin": print("This application failed: no Qt platform plugin could be initialized.", file=sys.stderr, flush=True); os.abort()
if deed == "term": os.kill(os.getpid(), 15)
sys.exit(int(deed))
"""  # noqa: E501
pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="abort() there has another exit code")


@pytest.fixture
def window(tmp_path, monkeypatch, home_of_its_own):
    """Watch a stand-in window that does these deeds one after another; returns exit code, what was said, its starts."""
    (tmp_path / "window.py").write_text(STAND_IN)
    (tmp_path / "canary").write_text(CANARY)
    monkeypatch.setenv("LABCAL_PASSPHRASE", CANARY)

    def run(*deeds):
        (tmp_path / "deeds").write_text(" ".join(deeds))
        said = []
        code = watch(["--bench", "b.toml"], said.append, [sys.executable, str(tmp_path / "window.py"), str(tmp_path)])
        return code, said, (tmp_path / "started").read_text().splitlines()

    return run


def reports(home):
    return sorted((home / "crashes").iterdir()) if (home / "crashes").is_dir() else []


def test_it_is_started_again_at_its_page_and_what_it_said_is_kept(window, home_of_its_own):
    (home_of_its_own / "guardian.log").write_text("coils at zero\n")
    code, said, starts = window("abort", "0")
    [report] = reports(home_of_its_own)
    assert code == 0
    assert said == [
        f"labcal gui: the window broke off (SIGABRT) and is started again; kept: {report}",
        "doing 0",
    ]
    assert len(starts) == 2
    assert f'"--after-crash", "{report}", "--page", "Fit"' in starts[1]
    assert '"--bench", "b.toml"' in starts[1]
    with zipfile.ZipFile(report) as archive:
        kept = {name: archive.read(name).decode() for name in archive.namelist()}
    assert "doing abort" in kept["log.txt"]
    assert "Fatal Python error: Aborted" in kept["log.txt"]  # where it was when it broke off
    assert "run-7" in kept["state.json"]
    assert "coils at zero" in kept["guardian.log"]
    assert "SIGABRT" in kept["crash.json"]
    assert report.stat().st_mode & 0o077 == 0


def test_the_report_holds_no_passphrase_and_the_window_never_had_it(window, home_of_its_own, tmp_path):
    (home_of_its_own / "keys").mkdir()
    (home_of_its_own / "keys" / "jane.pem").write_text("PRIVATE")
    _, said, _ = window("leak", "0")
    assert CANARY not in (tmp_path / "environment").read_text()
    [report] = reports(home_of_its_own)
    with zipfile.ZipFile(report) as archive:
        kept = "".join(archive.read(name).decode() for name in archive.namelist())
    assert "doing leak" in kept
    assert CANARY not in kept + "".join(said)
    assert "PRIVATE" not in kept


def test_what_a_library_makes_of_an_address_is_no_way_round_it() -> None:
    told = window_watch.without_secrets("could not connect: postgresql+psycopg://ada:c4nary@db/lab")
    assert told == "could not connect: postgresql+psycopg://ada:***@db/lab"


@pytest.mark.parametrize(("deed", "code"), [("0", 0), ("2", 2), ("term", 128 + signal.SIGTERM)])
def test_one_that_was_closed_or_cannot_open_stays_closed(window, home_of_its_own, deed, code):
    assert window(deed)[0] == code
    assert not reports(home_of_its_own)


def test_one_that_breaks_off_at_once_again_and_again_is_given_up(window, home_of_its_own):
    code, said, starts = window("abort", "abort", "abort", "0")
    assert (code, len(starts)) == (2, 3)
    assert said[-1].startswith("labcal gui: the window broke off 3 times as soon as it was open; please report it with")


def test_one_that_lived_is_started_again_however_often(window, monkeypatch):
    monkeypatch.setattr(window_watch, "AT_ONCE_S", 0.0)
    code, _, starts = window("abort", "abort", "1", "abort", "0")
    assert (code, len(starts)) == (0, 5)


def test_without_a_screen_it_says_what_to_install(window, home_of_its_own):
    code, said, starts = window("plugin")
    assert (code, len(starts)) == (2, 1)
    assert "libxcb-cursor0" in said[0]
    assert not reports(home_of_its_own)


@pytest.mark.parametrize(
    ("log", "display", "says"),
    [
        (
            "qt.qpa.xcb: could not connect to display :91\nqt.qpa.plugin: From 6.5.0, xcb-cursor0",
            ":91",
            "the screen :91",
        ),
        (
            "qt.qpa.xcb: could not connect to display \nqt.qpa.plugin: From 6.5.0",
            "",
            "there is no screen: DISPLAY names",
        ),
        (
            "qt.qpa.plugin: From 6.5.0, xcb-cursor0 or libxcb-cursor0 is needed",
            ":0",
            "Qt reaches no screen; on Debian:",
        ),
    ],
)
def test_without_a_screen_it_says_whether_that_is_the_display_or_a_library(log, display, says):
    assert window_watch.no_screen(log, {"DISPLAY": display}).startswith(says)


def test_a_state_that_is_damaged_is_none():
    script = "import os, sys; open(sys.argv[-1], 'w').write('{\"page'); os.abort()"
    assert once([sys.executable, "-c", script]).state == {}
