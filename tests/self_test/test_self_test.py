"""Installation qualification: each check fails where what it names is broken, and the page keeps what was found."""

import hashlib
import os
import subprocess
import sys
from base64 import urlsafe_b64encode
from datetime import UTC, datetime
from pathlib import Path
from types import SimpleNamespace

import pytest

from labcal import self_test
from labcal.certificate.report.html import html
from labcal.cli import execute as labcal
from labcal.errors import InstrumentError
from labcal.self_test import installed, page, simulated_line, surroundings
from labcal.self_test.result import Check, Computer, Qualification, guarded

COMPUTER = Computer("0.1.0", Path("labcal"), "3.11.7", "Linux", "bench-pc", "jane", datetime(2026, 3, 2, 8, tzinfo=UTC))
GOOD = Check("versions", "pass", "all in range")
BAD = Check("files", "FAIL", "1 of 9 files differ", "Install labcal again.")


@pytest.fixture
def packages(tmp_path, monkeypatch):
    """Two installed packages: `bench-part` needs `bench-base` 2, and of a Windows package nothing."""
    monkeypatch.syspath_prepend(tmp_path)
    installed_as(tmp_path, "bench-part", "1.0", ["bench-base>=2,<3", 'colour; sys_platform == "nowhere"'])
    installed_as(tmp_path, "bench-base", "2.1", [])
    return tmp_path


def installed_as(folder, name, version, needs):
    """A package's module, METADATA and RECORD, as pip leaves them."""
    module = f"{name.replace('-', '_')}.py"
    about = folder / f"{name.replace('-', '_')}-{version}.dist-info"
    about.mkdir()
    (folder / module).write_text("here = True\n")
    needed = "".join(f"Requires-Dist: {one}\n" for one in needs)
    (about / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n{needed}")
    digest = urlsafe_b64encode(hashlib.sha256((folder / module).read_bytes()).digest()).rstrip(b"=").decode()
    record = (
        f"{module},sha256={digest},12\n__pycache__/of-{name}.pyc,sha256=made-anew-by-pip,1\n{about.name}/RECORD,,\n"
    )
    (about / "RECORD").write_text(record)


def test_what_is_installed_as_it_was_packed_passes(packages):
    assert installed.check_versions("bench-part") == Check("", "pass", "labcal 1.0, 1 packages beside it, all in range")
    assert installed.check_files("bench-part").said.startswith("2 files are as they were packed")


@pytest.mark.parametrize("harm", ["changed", "gone"])
def test_a_file_that_is_not_as_it_was_packed_is_named(packages, harm):
    file = packages / "bench_base.py"
    file.write_text("here = False\n") if harm == "changed" else file.unlink()
    found = installed.check_files("bench-part")
    assert found.result == "FAIL"
    assert found.said == "1 of 2 files differ from their package's RECORD: bench-base: bench_base.py"


def test_a_package_that_is_missing_or_out_of_range_is_named(packages):
    (packages / "bench_base-2.1.dist-info" / "METADATA").write_text(
        "Name: bench-base\nVersion: 3.0\nRequires-Dist: gone"
    )
    found = installed.check_versions("bench-part")
    assert found.result == "FAIL"
    assert found.said == "bench-part needs bench-base <3,>=2, 3.0 is installed; gone is not installed"


def test_what_runs_from_a_folder_that_is_worked_on_is_not_shown(packages):
    (packages / "bench_part-1.0.dist-info" / "direct_url.json").write_text('{"dir_info": {"editable": true}}')
    assert installed.check_files("bench-part").result == "not shown"


def test_a_check_that_cannot_be_made_has_failed():
    def broken():
        raise InstrumentError("the supply is silent", fault="silent")

    assert guarded("preflight", broken) == Check("preflight", "FAIL", "InstrumentError: the supply is silent")
    assert not Qualification(COMPUTER, (GOOD, BAD)).passed
    assert Qualification(COMPUTER, (GOOD, Check("ports", "not shown", "none"))).passed


def demo_that(tmp_path, verdict="explained", cause=("offset-current", "i_eps"), after=27.5, missed=()):
    """A demo that ended so."""
    accepted = [SimpleNamespace(effect=cause[0], channels=cause[1:])]
    rms = [SimpleNamespace(holdout_rms_nT=value) for value in (228.0, after)]
    closed = SimpleNamespace(verdict=verdict, accepted=accepted, before=rms[0], after=rms[1], noise_floor_nT=27.0)
    valid = SimpleNamespace(valid=True)
    return SimpleNamespace(folder=tmp_path, rows=9, limits_missed=missed, closed=closed, verification=valid)


@pytest.mark.parametrize(
    ("how", "result"),
    [
        ({}, "pass"),
        ({"verdict": "partly-explained"}, "FAIL"),
        ({"cause": ("offset-temperature", "temp_dut")}, "FAIL"),
        ({"after": 32.0}, "FAIL"),
    ],
)
def test_the_loop_passes_where_it_names_what_is_there_and_comes_down_to_the_noise(tmp_path, how, result):
    assert simulated_line.check_loop(demo_that(tmp_path, **how)).result == result


def test_a_limit_that_the_simulated_lab_misses_is_named(tmp_path):
    found = simulated_line.check_preflight(demo_that(tmp_path, missed=(SimpleNamespace(name="squareness"),)), 9.0)
    assert (found.result, "squareness" in found.said) == ("FAIL", True)


@pytest.mark.parametrize(("blind", "result"), [(False, "pass"), (True, "FAIL")])
def test_a_signature_that_holds_of_a_changed_file_is_none(tmp_path, monkeypatch, blind, result):
    whole = b'{"run_sha256":"ab"}'
    (tmp_path / "calibration.json").write_bytes(whole)

    def verify(path, trust):
        return SimpleNamespace(valid=blind or path.read_bytes() == whole)

    monkeypatch.setattr(simulated_line.session, "verify", verify)
    assert simulated_line.check_signature(demo_that(tmp_path)).result == result
    assert (tmp_path / "calibration.json").read_bytes() == whole


def test_ports_that_this_user_may_not_open_are_named_with_the_group(tmp_path, monkeypatch):
    port = tmp_path / "ttyUSB0"
    port.touch()
    assert surroundings.check_ports([f"{tmp_path}/none*"]).result == "not shown"
    if sys.platform != "win32":
        assert surroundings.check_ports([str(port)]).result == "pass"
        monkeypatch.setattr(surroundings, "not_allowed", lambda port: f"{port} is for group dialout")
        found = surroundings.check_ports([str(port)])
        assert (found.result, found.todo) == ("FAIL", f"{port} is for group dialout")


def test_no_room_for_runs_is_a_failure(monkeypatch, home_of_its_own):
    assert surroundings.check_folder().result == "pass"
    monkeypatch.setattr(surroundings, "ROOM_BYTES", 1 << 60)
    assert surroundings.check_folder().result == "FAIL"


@pytest.mark.parametrize(
    ("display", "where"), [("", "off screen, for there is no display here"), (":9", "on this screen")]
)
def test_the_window_is_opened_where_there_is_a_screen_and_says_where(tmp_path, monkeypatch, display, where):
    asked = {}

    def run(command, env, **_):
        asked.update(env)
        Path(command[-1]).write_bytes(b"PNG")
        return SimpleNamespace(returncode=0, stderr="")

    for name in ("WAYLAND_DISPLAY", "QT_QPA_PLATFORM", "DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    if display:
        monkeypatch.setenv("DISPLAY", display)
    monkeypatch.setenv("LABCAL_PASSPHRASE", "a canary in the mine")
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setattr(surroundings.subprocess, "run", run)
    found = surroundings.check_window(tmp_path / "w")
    assert (found.result, where in found.said) == ("pass", True)
    assert asked.get("QT_QPA_PLATFORM") == (None if display else "offscreen")
    assert asked["LABCAL_HOME"] == str(tmp_path / "w")  # not the lab's own settings
    assert "LABCAL_PASSPHRASE" not in asked


def test_a_window_that_does_not_open_says_which_libraries_to_install(tmp_path, monkeypatch):
    monkeypatch.setattr(sys, "platform", "linux")
    died = SimpleNamespace(returncode=-6, stderr="qt.qpa.plugin: …\nno Qt platform plugin could be initialized\n")
    monkeypatch.setattr(surroundings.subprocess, "run", lambda *_, **__: died)
    found = surroundings.check_window(tmp_path / "w")
    assert found.said == "it ended with -6: no Qt platform plugin could be initialized"
    assert "libxcb-cursor0" in found.todo


@pytest.mark.slow
def test_the_window_opens_once_with_all_its_pages(tmp_path):
    picture = tmp_path / "window.png"
    command = [sys.executable, "-P", "-m", "labcal.gui", "--once", str(picture)]
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "LABCAL_HOME": str(tmp_path)}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=120)
    if "Qt does not load" in done.stderr:
        pytest.skip("Qt's system libraries are not installed")
    assert (done.returncode, picture.read_bytes()[:4]) == (0, b"\x89PNG"), done.stderr


def test_the_page_says_every_check_and_what_to_do():
    made = html(self_test.qualification_page(Qualification(COMPUTER, (GOOD, BAD))))
    for words in (
        "NOT PASSED",
        "bench-pc",
        "all in range",
        "1 of 9 files differ",
        "Install labcal again.",
        "2026-03-02",
    ):
        assert words in made
    assert "NOT PASSED" not in html(self_test.qualification_page(Qualification(COMPUTER, (GOOD,))))


@pytest.mark.parametrize(("checks", "code"), [((GOOD,), 0), ((GOOD, BAD), 1)])
def test_the_command_says_each_check_keeps_the_page_and_its_exit_code_is_the_result(
    tmp_path, monkeypatch, capsys, home_of_its_own, checks, code
):
    def qualify(begin, on_check):
        begin("hashing")
        for check in checks:
            on_check(check)
        return Qualification(COMPUTER, checks)

    monkeypatch.setattr(self_test, "qualify", qualify)
    monkeypatch.setattr(page, "write_report", lambda report, path: path.write_text(html(report)))  # a PDF takes seconds
    assert labcal(["self-test"]) == code
    said = capsys.readouterr().out
    assert "✓ versions: all in range" in said
    assert ("✕ files: 1 of 9 files differ\n  Install labcal again." in said) == bool(code)
    kept = home_of_its_own / "self-tests" / "self-test-20260302T080000Z.pdf"
    assert said.splitlines()[-1] == str(kept)
    assert ("NOT PASSED" in kept.read_text()) == bool(code)
    assert labcal(["self-test", "--out", str(tmp_path / "iq.pdf")]) == code
    assert (tmp_path / "iq.pdf").read_bytes() == kept.read_bytes()
    (tmp_path / "iq.pdf").write_text("somebody's own")
    assert labcal(["self-test", "--out", str(tmp_path / "iq.pdf")]) == 2
    assert labcal(["self-test", "--out", str(tmp_path / "iq.html")]) == 2
    assert "a qualification is a .pdf" in capsys.readouterr().err


@pytest.mark.slow
def test_the_page_is_a_pdf(tmp_path):
    found = Qualification(COMPUTER, (GOOD, BAD))
    assert page.write_page(found, page.place_for(tmp_path / "iq.pdf")).read_bytes().startswith(b"%PDF")


@pytest.mark.slow
def test_the_simulated_line_of_a_whole_installation_passes(tmp_path):
    made = list(simulated_line.check_line(tmp_path / "demo"))
    assert [(check.name, check.result) for check in made] == [
        ("simulated preflight", "pass"), ("closed loop", "pass"), ("signature", "pass"),
    ]  # fmt: skip
