"""The commands as a person types them: exit codes, one sentence, nothing half-written."""

from __future__ import annotations

import os
from pathlib import Path
from unittest.mock import patch

import pytest

from labcal.cli import execute


@pytest.fixture(autouse=True)
def passphrase(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("LABCAL_PASSPHRASE", "correct horse")


def run(*words: object) -> int:
    """A command as a process runs it: what it does to its environment is its own."""
    with patch.dict(os.environ):
        return execute([str(word) for word in words])


def test_the_whole_way_of_a_file(draft: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    assert run("keys", "new", "--name", "ada") == 0
    assert run("keys", "new", "--name", "bob") == 0
    capsys.readouterr()
    assert run("keys", "list", "--allowed-signers") == 0
    (tmp_path / "allowed").write_text(capsys.readouterr().out)
    assert run("verify", draft) == 1
    assert run("approve", draft, "--as", "bob") == 0
    assert run("sign", draft, "--key", "ada") == 0
    assert run("sign", draft, "--key", "bob") == 0
    assert run("verify", draft) == 0
    assert "VALID: signed by ada, bob." in capsys.readouterr().out
    assert run("verify", draft, "--allowed-signers", tmp_path / "allowed") == 0
    draft.write_bytes(draft.read_bytes() + b" ")
    assert run("verify", draft) == 1


def test_another_lab_trusts_what_this_one_prints(
    draft: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    run("keys", "new", "--name", "ada")
    run("sign", draft, "--key", "ada")
    capsys.readouterr()
    run("keys", "list", "--allowed-signers")
    (tmp_path / "allowed").write_text(capsys.readouterr().out)
    monkeypatch.setenv("LABCAL_HOME", str(tmp_path / "other"))
    assert run("verify", draft) == 1
    assert run("keys", "trust", tmp_path / "allowed") == 0
    assert run("verify", draft) == 0
    assert run("keys", "revoke", "ada") == 0
    assert run("verify", draft) == 1
    assert run("keys", "list") == 0
    assert "revoked" in capsys.readouterr().out


def test_a_wrong_passphrase_is_one_sentence_and_exit_2(
    draft: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    run("keys", "new", "--name", "ada")
    monkeypatch.setenv("LABCAL_PASSPHRASE", "no")
    capsys.readouterr()
    assert run("sign", draft, "--key", "ada") == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.count("\n") == 1
    assert "the passphrase is wrong" in said.err
    assert [p.name for p in draft.parent.iterdir()] == ["cal.json"]


@pytest.mark.parametrize(
    "words",
    [
        ("keys", "new", "--name", "../x"),
        ("keys", "trust", "absent"),
        ("sign", "absent.json", "--key", "ada"),
        ("sign", "{draft}", "--key", "nobody"),
        ("verify", "absent.json"),
        ("verify", "{draft}", "--allowed-signers", "absent"),
        ("verify", "{draft}", "--allowed-signers", "{draft}"),
        ("verify", "{draft}", "--run", "no-such-run"),
        ("approve", "absent.json", "--as", "bob"),
        ("approve", "{draft}"),
    ],
)
def test_wrong_requests_are_one_sentence_and_exit_2(
    draft: Path, capsys: pytest.CaptureFixture[str], words: tuple[str, ...]
):
    assert run(*(word.format(draft=draft) for word in words)) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err
    assert "Traceback" not in said.err


def test_an_empty_passphrase_is_refused(monkeypatch: pytest.MonkeyPatch, home_of_its_own: Path):
    monkeypatch.setenv("LABCAL_PASSPHRASE", "")
    assert run("keys", "new", "--name", "ada") == 2
    assert not list(home_of_its_own.rglob("*.pem"))


def test_a_new_passphrase_is_asked_twice(monkeypatch: pytest.MonkeyPatch, home_of_its_own: Path):
    monkeypatch.delenv("LABCAL_PASSPHRASE")
    assert run("keys", "new", "--name", "ada") == 2  # no terminal to ask
    monkeypatch.setattr("sys.stdin.isatty", lambda: True)
    answers = iter(["one of them", "the other one", "the same one", "the same one"])
    monkeypatch.setattr("getpass.getpass", lambda question: next(answers))
    assert run("keys", "new", "--name", "ada") == 2
    assert not list(home_of_its_own.rglob("*.pem"))
    assert run("keys", "new", "--name", "ada") == 0
    assert list(home_of_its_own.rglob("ada.pem"))
