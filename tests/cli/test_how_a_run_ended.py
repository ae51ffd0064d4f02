"""The last line of `labcal run` says what the store had to do with it, and only where it can be done how to go on."""

import json
from io import StringIO
from pathlib import Path

import pytest
from rich.console import Console
from rich.progress import Progress

from labcal import cli, session
from labcal.cli.progress import Bar
from labcal.errors import InstrumentError
from labcal.record.stream import NOT_KEPT, Event
from labcal.runner import Outcome

ENDING = "interrupted by its store: s: the store was locked by process 42 (python); every row is kept by now"
LOCKED = InstrumentError("s: the store was locked by process 42 (python).", fault="store locked")


@pytest.mark.parametrize(
    ("resumable", "end"),
    [(True, "; `labcal run preflight --resume R1 --bench 'my bench.toml'` goes on with it"), (False, "")],
)
@pytest.mark.parametrize("as_json", [True, False])
def test_an_interrupted_run_says_why_and_how_to_go_on(monkeypatch, capsys, resumable, end, as_json):
    outcome = Outcome("R1", "interrupted", LOCKED, ending=ENDING, resumable=resumable)
    monkeypatch.setattr(session, "run", lambda *_, **__: outcome)
    words = ["run", "preflight", "--bench", "my bench.toml", "--yes", "--progress", "json" if as_json else "none"]
    assert cli.execute(words) == 3
    said = capsys.readouterr()
    last, fault = said.err.splitlines()
    ended = "broken off by its store: s: the store was locked by process 42 (python); every row is kept by now"
    assert (json.loads(last)["text"] if as_json else last) == f"{ended}; coils not read back in this session{end}"
    assert fault == f"labcal: {LOCKED}"
    assert said.out == "R1\n"


def test_a_run_that_goes_on_is_named_by_its_number_alone(monkeypatch, capsys):
    outcome = Outcome("R1", "interrupted", LOCKED, ending=ENDING, resumable=True)
    monkeypatch.setattr(session, "resume", lambda *_, **__: outcome)
    assert cli.execute(["run", "--resume", "R1", "--bench", str(Path("b.toml")), "--progress", "none"]) == 3
    assert "`labcal run --resume R1 --bench b.toml` goes on with it" in capsys.readouterr().err


def test_the_bar_says_at_once_that_the_store_is_waited_for():
    with Progress(console=Console(file=(shown := StringIO()), width=200)) as progress:
        Bar(progress).on_item(Event(1.0, NOT_KEPT, "the end of the run waits: s: the store was locked."))
    assert "! the end of the run waits: s: the store was locked." in shown.getvalue()


@pytest.mark.parametrize(
    "lab", ["coils NOT confirmed at zero", "coils NOT confirmed at zero; NOT at zero by the reference: it sees 5 nT"]
)
def test_what_its_end_says_of_the_coils_is_said_once(monkeypatch, capsys, lab):
    ending = "failed: coils NOT confirmed at zero: tcp://a:1: no reply"
    monkeypatch.setattr(Outcome, "at_rest", lab)
    monkeypatch.setattr(session, "run", lambda *_, **__: Outcome("R1", "failed", LOCKED, ending=ending))
    assert cli.execute(["run", "preflight", "--bench", "b.toml", "--yes", "--progress", "none"]) == 3
    ended = "broken off: coils NOT confirmed at zero: tcp://a:1: no reply"
    assert capsys.readouterr().err.splitlines()[0] == ended + lab.removeprefix("coils NOT confirmed at zero")
