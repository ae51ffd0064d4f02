import runpy
import subprocess
import sys

import pytest

from labcal import cli
from labcal.cli import app
from labcal.errors import InputError, InstrumentError, LimitError, Stopped


@pytest.fixture(autouse=True)
def commands_registered(capsys):
    cli.execute(["--version"])
    capsys.readouterr()


@pytest.mark.parametrize(
    ("fault", "code", "words"),
    [
        (InputError("is no bundle", file="run.zip", line=3, column="dut_x"), 2, "run.zip, line 3, column dut_x: is no"),
        (InstrumentError("supply x is silent.", remedy="Check its plug."), 3, "supply x is silent. Check its plug."),
        (LimitError("3 A is beyond 2 A"), 2, "3 A is beyond 2 A"),
        (Stopped("by the operator"), 130, "stopped"),
        (KeyboardInterrupt(), 130, "stopped"),
        (FileNotFoundError(2, "No such file or directory", "nowhere.csv"), 2, "nowhere.csv: No such file"),
        (OSError(24, "Too many open files", "/run"), 2, "labcal: the system gives labcal no more: Too many open files"),
    ],
)
def test_every_fault_ends_in_one_sentence_and_its_code(monkeypatch, capsys, fault, code, words):
    monkeypatch.setattr(cli, "app", raiser(fault))
    assert cli.execute([]) == code
    said = capsys.readouterr().err
    assert words in said
    assert said.count("\n") == 1


def test_ctrl_c_within_a_command_is_told(monkeypatch, capsys):
    monkeypatch.setattr("labcal.cli.numbers.claim", raiser(KeyboardInterrupt()))
    assert cli.execute(["numbers"]) == 130
    assert capsys.readouterr().err == "labcal: stopped\n"


def test_ctrl_c_while_the_commands_load_is_told(monkeypatch, capsys):
    monkeypatch.setattr("builtins.__import__", raiser(KeyboardInterrupt()))
    assert cli.execute([]) == 130
    assert capsys.readouterr().err == "labcal: stopped\n"


def test_a_fault_of_our_own_is_a_sentence_and_a_file_with_the_details(monkeypatch, capsys, home_of_its_own):
    monkeypatch.setattr(cli, "app", raiser(ZeroDivisionError("division by zero")))
    assert cli.execute([]) == 2
    said = capsys.readouterr().err
    assert "Traceback" not in said
    assert "last-fault.txt" in said
    assert "ZeroDivisionError" in (home_of_its_own / "last-fault.txt").read_text()


def test_an_unknown_command_is_a_wrong_request():
    assert cli.execute(["calibrat"]) == 2


def test_help_is_quick_to_load(monkeypatch):
    import subprocess
    import sys

    code = "import sys, labcal.cli.commands; print(*sorted({m.split('.')[0] for m in sys.modules}))"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert not {"scipy", "matplotlib", "h5py", "magpylib", "pandas", "PySide6", "numpy"} & set(loaded)
    assert app.registered_commands


def raiser(fault):
    def call(*_, **__):
        raise fault

    return call


@pytest.mark.parametrize("words", [["fit"], ["export", "r", "--format", "xml", "--out", "x"], ["show", "r", "--nope"]])
def test_a_wrong_word_is_one_sentence_that_says_where_help_is(words, capsys):
    assert cli.execute(words) == 2
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    assert f"`labcal {words[0]} --help`" in said


@pytest.mark.parametrize("words", [["run", "preflight"], ["run", "nowhere", "--bench", "nowhere.toml"]])
def test_where_a_run_cannot_begin_one_sentence_is_said_and_no_empty_line(words, capsys):
    assert cli.execute(words) == 2
    said = capsys.readouterr().err
    assert said.startswith("labcal: ")
    assert said.count("\n") == 1


def test_a_run_id_that_is_no_text_is_a_sentence(capsys):
    assert cli.execute(["show", "\udcff"]) == 2
    assert "no UTF-8" in capsys.readouterr().err


def test_the_module_is_the_same_command_line(monkeypatch, capsys):
    monkeypatch.setattr(sys, "argv", ["labcal", "--version"])
    with pytest.raises(SystemExit) as end:
        runpy.run_module("labcal", run_name="__main__")
    assert end.value.code == 0
    assert "labcal" in capsys.readouterr().out


def test_without_a_standard_output_it_ends_without_a_fault():
    closed = "import sys; sys.stdout = None; sys.argv = ['labcal', '--version']; from labcal.cli import main; main()"
    assert subprocess.run([sys.executable, "-c", closed], check=False).returncode == 0
