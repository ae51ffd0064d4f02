"""The examples of docs/procedures.md, run as a new user would."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import pytest

from labcal.cli import execute
from labcal.runner import procedures

ROOT = Path(__file__).resolve().parents[2]
TEXT = (ROOT / "docs" / "procedures.md").read_text(encoding="utf-8")
OWN, FROM_PYTHON = re.findall(r"```python\n(.*?)```", TEXT, re.DOTALL)


Labcal = Callable[..., SimpleNamespace]


@pytest.fixture
def labcal(capsys: pytest.CaptureFixture[str]) -> Labcal:
    """Runs a command; its exit code, and what it said."""

    def run(*words: str) -> SimpleNamespace:
        code, said = execute(list(words)), capsys.readouterr()
        return SimpleNamespace(returncode=code, stdout=said.out, stderr=said.err)

    return run


def test_ones_own_procedure_in_twenty_lines_runs_and_its_last_line_is_the_run_id(
    labcal: Labcal, tmp_path: Path
) -> None:
    path = tmp_path / "my_test.py"
    path.write_text(OWN, encoding="utf-8")
    bench = str(ROOT / "examples" / "simulated.toml")
    done = labcal("run", str(path), "--bench", bench, "--yes", "--set", "top_nT=20000", "--progress", "json")
    assert done.returncode == 0, done.stderr
    assert re.fullmatch(r"\d{8}T\d{6}-[0-9a-f]{4}\n", done.stdout)
    assert '"name": "z at step 3"' in done.stderr
    assert json.loads(done.stderr.splitlines()[-1]) == {"item": "end", "text": "finished; coils at zero"}
    shown = labcal("show", done.stdout.strip())
    assert "my-test" in shown.stdout
    path.write_text(OWN.replace("top_nT * step", "top_nT * stp"), encoding="utf-8")
    wrong = labcal("run", str(path), "--bench", bench, "--yes")
    assert wrong.returncode == 2
    assert "my_test.py, line 18: NameError: name 'stp' is not defined" in wrong.stderr
    assert "labcal's own" not in wrong.stderr
    refused = labcal("run", str(path), "--bench", bench, "--yes", "--set", "top_nT=99000")
    assert (refused.returncode, refused.stdout) == (2, "")
    assert "top_nT = 99000.0 is refused: expected a number from 1000 to 60000 nT" in refused.stderr


def test_the_lines_of_python_run(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.chdir(ROOT)
    exec(compile(FROM_PYTHON, "docs/procedures.md", "exec"), {})
    assert "finished" in capsys.readouterr().out


def test_every_procedure_of_ours_is_in_the_table() -> None:
    ours = [name for name, found in procedures().items() if found.function.__module__.startswith("procedures.")]
    assert not [name for name in ours if f"`{name}`" not in TEXT]


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("def my_test(bench:\n", "line 1: is not Python"),
        ("1 / 0\n", "cannot be loaded: ZeroDivisionError"),
        ("x = 1\n", "holds no procedures"),
        ("def my_test(bench):\n    yield 42\n", "line 2: TypeError: a procedure yields items of a run, and 42 is none"),
        (None, "there is no such file"),
    ],
)
def test_a_file_that_is_no_procedure_is_refused_in_a_sentence(
    labcal: Labcal, tmp_path: Path, bench_file: Callable[..., Path], text: str | None, says: str
) -> None:
    path = tmp_path / "my_test.py"
    if text is not None:
        path.write_text(text, encoding="utf-8")
    done = labcal("run", str(path), "--bench", str(bench_file()), "--yes")
    assert done.returncode == 2
    assert says in done.stderr
    assert "Traceback" not in done.stderr
