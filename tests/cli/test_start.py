"""The program's first moments, and what is said twice or to nobody."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import IO

import pytest

from labcal.bench.config import read_config
from labcal.cli import execute as labcal

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="signals as POSIX has them")
SIMULATED = Path(__file__).resolve().parents[2] / "examples" / "simulated.toml"
CALIBRATION = SIMULATED.parent / "short-preflight" / "calibration.json"
LOADING = """
import signal, sys, importlib.abc
signal.signal(signal.SIGINT, signal.default_int_handler)  # as at a terminal: behind `nohup` it is ignored
class Waits(importlib.abc.MetaPathFinder):  # says that the commands are being loaded, and takes its time over it
    def find_spec(self, name, path=None, target=None):
        if name == "labcal.cli":
            import time
            print("loading", flush=True)
            time.sleep(60)
sys.meta_path.insert(0, Waits())
from labcal.start import main
main()
"""


def test_ctrl_c_while_the_program_loads_is_no_traceback() -> None:
    with subprocess.Popen(
        [sys.executable, "-c", LOADING], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "loading\n"
        process.send_signal(signal.SIGINT)
        _, told = process.communicate(timeout=30)
    assert (process.returncode, told) == (-signal.SIGINT, "")


def test_a_setting_that_is_there_twice_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    words = ["--set", "duration_s=10", "--set", "duration_s=20"]
    assert labcal(["run", "ambient", "--bench", str(SIMULATED), *words]) == 2
    assert "--set duration_s is there twice" in capsys.readouterr().err


def test_without_bench_it_is_the_one_of_this_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert labcal(["run", "ambient"]) == 2
    assert "no bench.toml lies in this folder" in capsys.readouterr().err
    (tmp_path / "bench.toml").write_bytes(SIMULATED.read_bytes())
    assert labcal(["run", "ambient", "--set", "duration_s=1"]) == 2
    assert "duration_s" in capsys.readouterr().err


@pytest.mark.parametrize("name", ["a" * 101, "ada\x1b[31m", "ada\nlovelace"])
def test_an_operator_is_one_printable_line(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert labcal(["run", "ambient", "--bench", str(SIMULATED), "--operator", name]) == 2
    assert "one printable line of at most 100" in capsys.readouterr().err


@pytest.mark.parametrize(
    "words",
    [
        ["run", "ambient", "--bench", str(SIMULATED), "--operator"],
        ["run", "ambient", "--bench", str(SIMULATED), "--because", "it holds", "--override"],
        ["bench", "check", str(SIMULATED), "--clear-as"],
        ["bench", "cage", "a-run", "--out", "cage.json", "--as"],
        ["approve", "calibration.json", "--as"],
    ],
)
@pytest.mark.parametrize("typed", ["12|;", "<b>", "..."])
def test_a_slip_of_the_keys_is_nobody_wherever_a_person_is_named(
    words: list[str], typed: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("calibration.json").write_bytes(CALIBRATION.read_bytes())
    assert labcal([*words, typed]) == 2
    assert f"“{typed}” is no name: letters, digits, blanks, and" in capsys.readouterr().err


def test_a_folder_is_no_bench_file_and_its_own_name_says_so(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert labcal(["bench", "check", str(tmp_path)]) == 2
    assert f"{tmp_path}: is not a regular file" in capsys.readouterr().err


def test_a_run_whose_progress_nobody_reads_any_more_is_stopped_and_not_failed(tmp_path: Path) -> None:
    words = ["run", "ambient", "--bench", str(SIMULATED), "--clock", "real", "--progress", "json"]
    words += ["--set", "mains_s=5"]  # what is said next comes after it
    with subprocess.Popen(
        [sys.executable, "-P", "-m", "labcal", *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        env={**os.environ, "LABCAL_HOME": str(tmp_path)},
    ) as process:  # fmt: skip
        assert process.stderr is not None
        assert process.stderr.readline().startswith('{"item"')
        process.stderr.close()
        assert process.wait(timeout=120) == 130


def test_a_log_that_is_a_pipe_keeps_no_guardian_from_starting(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from labcal.bench.guardian import spawn
    from labcal.bench.guardian.briefing import Briefing

    class Begun(Exception):
        pass

    def popen(*_: object, stderr: IO[bytes], **__: object) -> None:
        raise Begun(stderr.name)

    monkeypatch.setenv("LABCAL_HOME", str(tmp_path))
    monkeypatch.setattr(spawn.subprocess, "Popen", popen)
    os.mkfifo(tmp_path / "guardian.log", 0o600)
    with pytest.raises(Begun, match=os.devnull):
        spawn.spawn(Briefing(SIMULATED, read_config(SIMULATED), "0"))
