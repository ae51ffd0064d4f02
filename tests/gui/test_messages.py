"""What crosses between window and workers: whole there and back, one handler a command, and nothing else is heard."""

import io
import json
import os
import time
import typing
from dataclasses import fields, is_dataclass, replace
from functools import partial
from types import UnionType

import numpy as np
import pytest
from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QLabel
from shiboken6 import delete

from labcal.bench.coils.state import CoilReading, LabState
from labcal.bench.parameters import Limits, ParameterSpec
from labcal.errors import InputError
from labcal.gui.ipc import answers, worker
from labcal.gui.ipc.channel import Channel
from labcal.gui.ipc.client import TIME_SLICE_S, Client
from labcal.gui.ipc.codec import decode, encode
from labcal.gui.ipc.lines import answer_type, kinds, read_answer, read_event, read_request, write_line
from labcal.gui.ipc.listeners import while_there
from labcal.gui.ipc.messages import (
    Command,
    Done,
    Failed,
    FitRun,
    LinesTaken,
    ListRuns,
    NewKey,
    Progress,
    Recorded,
    Request,
    Sign,
    StateRead,
    Word,
)
from labcal.gui.ipc.wire import BROKEN, Fault
from labcal.record import Segment
from labcal.record.stream import Block, Event, Item, Measurement, Prompt, SegmentClosed, SegmentOpened, Step

ITEMS = (
    Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), np.array([1.0, 2.0]), np.array([[1.0, np.nan, 3.0]] * 2)),
    SegmentOpened(2.0, Segment("x-20uT", "rotation")),
    SegmentClosed(3.0),
    Step(0.0, 1, 2, "zero", 60.0, ("zero", "x"), 20.0),
    Measurement(4.0, "closure x", 3.0, 1.0, "nT", 50.0),
    Event(5.0, "set-point", "on", {"read_back_A": [1, 0, 0]}),
    Prompt(6.0, "mount-x", "Mount it.", ("done",), True, {"body_from_cage": [[1.0, 0.0, 0.0]] * 3}),
)
SPEC = ParameterSpec("rate_deg_per_s", "number", 2.0, limits=Limits(0.1, 36.0, "deg/s"), choices=("a",))


def sample(hint, depth=0):
    """Some value of a type, every field filled."""
    origin, args = typing.get_origin(hint), typing.get_args(hint)
    made = {str: "words", int: 3, float: 2.5, bool: True, typing.Any: {"a": [1]}, ParameterSpec: SPEC}
    if hint in made:
        return made[hint]
    if hint == Item or hint in typing.get_args(Item):
        return ITEMS[4]
    if origin is np.ndarray:
        return np.array([[1.0, np.nan], [3.0, 4.0]])
    if origin is typing.Literal:
        return args[-1]
    if origin in (typing.Union, UnionType):
        return sample(next(one for one in args if one is not type(None)))
    if origin is tuple:
        return (sample(args[0]),) * 2 if args[-1] is ... else tuple(map(sample, args))
    if origin is not None:
        return {"a name": sample(args[1])}
    hints = typing.get_type_hints(hint)
    return hint(**{field.name: sample(hints[field.name]) for field in fields(hint)})


def same(one, other):
    """Whether two values are equal, arrays within them too."""
    if isinstance(one, np.ndarray):
        return np.array_equal(one, other, equal_nan=True)
    if is_dataclass(one):
        return type(one) is type(other) and all(same(getattr(one, f.name), getattr(other, f.name)) for f in fields(one))
    if isinstance(one, tuple):
        return len(one) == len(other) and all(map(same, one, other))
    if isinstance(one, dict):
        return one.keys() == other.keys() and all(same(one[key], other[key]) for key in one)
    return one == other


def by_name(kinds):
    return {"argvalues": kinds.values(), "ids": kinds}


@pytest.mark.parametrize("kind", **by_name(kinds(Command)))
def test_every_command_and_its_answer_come_back_the_same(kind):
    asked = Request(7, sample(kind))
    assert read_request(write_line(asked)) == asked
    told = sample(answer_type(kind))
    done = read_event(write_line(Done(7, encode(told))))
    assert same(read_answer(asked.command, done.answer), told)


@pytest.mark.parametrize("kind", **by_name(kinds(Word)))
def test_every_word_into_a_run_comes_back_the_same(kind):
    assert read_request(write_line(sample(kind))) == sample(kind)


@pytest.mark.parametrize(
    "event",
    [Progress("folds 3 of 5"), Failed(3, Fault("limit", "too far", "Turn back.", "trace")), Recorded(ITEMS),
     StateRead(LabState((CoilReading("x", 0.5, 0.5, read_s=3.0),)))],
    ids=lambda event: type(event).__name__,
)  # fmt: skip
def test_every_event_comes_back_the_same(event):
    assert same(read_event(write_line(event)), event)


def test_nothing_was_said_for_is_nothing():
    nothing = answers.Ended("r1", "finished")
    assert decode(answers.Ended, encode(nothing), "") == nothing
    assert decode(answers.Checked | None, None, "") is None


def test_every_command_has_exactly_one_handler_that_takes_it_and_gives_its_answer():
    pairs = [pair for one in worker.ROOMS for pair in one.HANDLERS]
    assert sorted(kind.__name__ for kind, _ in pairs) == sorted(kinds(Command))
    assert len({do for _, do in pairs}) == len(pairs)
    for kind, do in pairs:
        told = typing.get_type_hints(do)
        assert told["asked"] is kind
        assert told["return"] == answer_type(kind), kind


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("no JSON", "is not JSON: 'no JSON'"),
        ("[" * 100_000, "is not JSON"),
        ("[1]", "is no message: '[1]'"),
        ('{"id": 1}', "is no message"),
        ('{"is": "Explode", "id": 1}', "no worker knows the message 'Explode'"),
        ('{"is": "FitRun", "with": {"run": "r1", "method": "ml"}}', "FitRun bears no number"),
        ('{"is": "FitRun", "id": true, "with": {"run": "r1", "method": "ml"}}', "FitRun bears no number"),
        ('{"is": "FitRun", "id": 1, "with": {"run": "r1"}}', "FitRun has no 'method', which it needs"),
        ('{"is": "FitRun", "id": 1, "with": {"run": "r1", "method": "ml", "x": 1}}', "FitRun has no field 'x'"),
        ('{"is": "FitRun", "id": 1, "with": {"run": 7, "method": "ml"}}', "FitRun.run is not of type str but 7"),
        ('{"is": "FitRun", "id": 1, "with": []}', "FitRun is not an object but []"),
        ('{"is": "TryCause", "id": 1, "with": {"run": "r", "effect": "e", "channels": "i"}}', "channels is not a list"),
        ('{"is": "ExportRun", "id": 1, "with": {"run": "r", "format": "doc", "out": "o"}}', "one of bundle, csv, hdf5"),
        ('{"is": "Note", "with": {"text": "t", "data": {"a": 1}}}', "Note.data.a is not of type str but 1"),
        ('{"is": "Request", "id": 1}', "no worker knows the message 'Request'"),
    ],
)  # fmt: skip
def test_what_is_no_message_is_refused_with_a_sentence(line, words):
    with pytest.raises(InputError) as told:
        read_request(line)
    assert words in str(told.value)
    assert len(str(told.value)) < 200


@pytest.mark.parametrize(
    ("line", "words"),
    [
        (b"\xff\xfe no text", "is not JSON"),
        (b'{"is": "FitRun", "with": {}}', "the window knows no message 'FitRun'"),
        (b'{"is": "Recorded", "with": {"items": [["no kind", 1.0]]}}', "Recorded.items is not an item of the timeline"),
        (b'{"is": "StateRead", "with": {"state": {"coils": [{"axis": "x", "zero": 1}]}}}', "zero is not of type bool"),
    ],
)
def test_what_no_worker_says_is_refused_with_a_sentence(line, words):
    with pytest.raises(InputError) as told:
        read_event(line)
    assert words in str(told.value)


def test_an_answer_that_is_none_is_refused_with_a_sentence():
    with pytest.raises(InputError, match=r"the answer to FitRun\.residual is not an array but \{'shape': \[2\]"):
        read_answer(FitRun("r1", "ml"), {"fit": {"ok": True}, "residual": {"shape": [2], "f8": "AAAA"}})


def test_what_cannot_cross_is_no_answer():
    with pytest.raises(TypeError, match="a set cannot cross"):
        encode({"a": {1, 2}})


def test_no_passphrase_stands_in_what_is_shown_of_a_message():
    assert "secret" not in repr([NewKey("j", "secret"), Sign("c.json", "j", "secret")])
    assert "secret" in write_line(Request(1, Sign("c.json", "j", "secret")))


def test_a_worker_refuses_a_broken_line_by_its_number_and_goes_on():
    hears, says = os.pipe()
    said = io.StringIO()
    with os.fdopen(hears) as heard:
        channel = Channel(heard, said)
        requests = channel.requests()
        channel.run_begins(simulated=True)  # a hang-up ends no process
        good = Request(5, ListRuns())
        os.write(says, b'{"is": "FitRun", "id": 4, "with": {}}\nrubbish\n' + f"{write_line(good)}\n".encode())
        assert next(requests) == good
        os.close(says)
        assert list(requests) == []
    refused = [read_event(line) for line in said.getvalue().splitlines()]
    assert [(one.number, one.fault.kind) for one in refused] == [(4, "input"), (0, "input")]
    assert "FitRun has no 'method'" in refused[0].fault.text


WAITS = "import sys; sys.stdin.read()"
SPOILT = """
import sys
line = sys.stdin.readline()
print({answer!r}, flush=True)
sys.stdin.read()
"""


@pytest.mark.parametrize(
    ("answer", "words"),
    [
        ("rubbish", "The work said what this window cannot read"),
        (json.dumps({"is": "Done", "with": {"number": 1, "answer": [{"run_id": 3}]}}), "which it needs"),
    ],
)
def test_a_worker_that_says_no_message_is_a_fault_and_nothing_waits_for_ever(qtbot, patience, answer, words):
    client, told = Client(None, ("-c", SPOILT.format(answer=answer))), []
    client.request(ListRuns(), told.append, told.append)
    qtbot.waitUntil(lambda: bool(told), timeout=patience)
    client.close(500)
    QCoreApplication.processEvents()
    ((fault),) = told
    assert fault.kind in BROKEN
    assert words in fault.text + fault.details
    assert not client.busy


TALKS = """
import sys
sys.stdin.readline()
sys.stdout.write(open({file!r}, encoding="utf-8").read())
sys.stdout.flush()
sys.stdin.read()
"""


def test_of_states_that_come_faster_than_they_are_shown_the_newest_is_and_before_what_was_said_after_it(
    qtbot, patience, tmp_path
):
    said = [StateRead(LabState((CoilReading("x", None, float(n), True, True, float(n)),))) for n in range(400)]
    said[300:300] = [Progress("half-way")]
    file = tmp_path / "said"
    file.write_text("".join(f"{write_line(one)}\n" for one in said), encoding="utf-8")
    client, seen = Client(None, ("-c", TALKS.format(file=str(file)))), []
    client.states.connect(lambda state: seen.append(state.coils[0].current_A))
    client.progress.connect(seen.append)
    client.request(ListRuns(), seen.append, seen.append)
    qtbot.waitUntil(lambda: bool(seen) and seen[-1] == 399.0, timeout=patience)
    client.close(500)
    assert seen[seen.index("half-way") - 1] >= 299.0
    assert len(seen) < 200
    assert [one for one in seen if one != "half-way"] == sorted(one for one in seen if one != "half-way")


def test_how_the_lab_is_waits_behind_nothing_that_this_window_has_not_taken(qtbot, patience, tmp_path):
    rows = [Progress(str(n)) for n in range(20)]
    states = [StateRead(LabState((CoilReading("x", None, float(n)),))) for n in (1, 2)]
    file, seen = tmp_path / "said", []
    file.write_text("".join(f"{write_line(one)}\n" for one in (*rows, *states)), encoding="utf-8")

    def slow(words):
        time.sleep(TIME_SLICE_S / 4)
        seen.append(words)

    client = Client(None, ("-c", TALKS.format(file=str(file))))
    client.states.connect(lambda state: seen.append(state.coils[0].current_A))
    client.progress.connect(slow)
    client.request(ListRuns(), seen.append, seen.append)
    qtbot.waitUntil(lambda: len(seen) == len(rows) + 1, timeout=patience)
    client.close(500)
    assert seen[0] == 2.0  # the newest, before every row
    assert seen[1:] == [one.text for one in rows]


def test_the_window_says_what_it_has_taken_with_the_states_that_others_overtook(qtbot, patience, tmp_path):
    said = [*(StateRead(LabState((CoilReading("x", None, float(n)),))) for n in range(3)), Progress("on")]
    file, seen, words = tmp_path / "said", [], []
    file.write_text("".join(f"{write_line(one)}\n" for one in said), encoding="utf-8")
    client = Client(None, ("-c", TALKS.format(file=str(file))))
    client.progress.connect(seen.append)
    client.request(ListRuns(), seen.append, seen.append)
    send, client.send = client.send, lambda word: (words.append(word), send(word))
    qtbot.waitUntil(lambda: LinesTaken(len(said)) in words, timeout=patience)
    client.close(500)


def test_whoever_breaks_over_an_answer_keeps_nobody_waiting_for_theirs(qtbot, patience, tmp_path):
    file, heard = tmp_path / "said", []
    file.write_text("".join(f"{write_line(Done(n, []))}\n" for n in (1, 2, 3)), encoding="utf-8")
    client = Client(None, ("-c", TALKS.format(file=str(file))))
    with qtbot.captureExceptions() as broken:
        client.request(ListRuns(), lambda _: 1 / 0, heard.append)
        client.request(ListRuns(), heard.append, heard.append)
        client.request(ListRuns(), heard.append, heard.append)
        qtbot.waitUntil(lambda: len(heard) == 2, timeout=patience)
    client.close(500)
    assert heard == [(), ()]
    assert [kind for kind, *_ in broken] == [ZeroDivisionError]


def test_an_answer_for_what_is_gone_is_heard_by_nobody(qapp):
    label, heard = QLabel(), []

    def known(words):
        heard.append(label.setText(words))

    for listener in (label.setText, known, partial(known), lambda words: known(words)):
        while_there(listener)("here")
    delete(label)
    for listener in (label.setText, known, partial(known), lambda words: known(words)):
        while_there(listener)("too late")
    assert heard == [None, None, None]


def how_it_ended(qtbot, patience, program, kill=False):
    client, told = Client(None, ("-c", program)), []
    client.request(ListRuns(), told.append, told.append)
    if kill:
        client.kill()
    qtbot.waitUntil(lambda: bool(told), timeout=patience)
    client.close(500)
    QCoreApplication.processEvents()
    return told[0]


def test_a_worker_that_is_gone_says_whether_it_was_killed_and_by_what_signal(qtbot, patience):
    ended = how_it_ended(qtbot, patience, "raise SystemExit(9)")
    assert (ended.kind, ended.text) == ("ended", "The work ended by itself (exit 9).")
    assert how_it_ended(qtbot, patience, WAITS, kill=True).text == "The work was ended by this window."


@pytest.mark.skipif(os.name != "posix", reason="Windows has no signals")
@pytest.mark.parametrize(("number", "words"), [(9, "(signal 9, SIGKILL)"), (15, "(signal 15, SIGTERM)")])
def test_a_signal_is_no_exit_code(qtbot, patience, number, words):
    ended = how_it_ended(qtbot, patience, f"import os; os.kill(os.getpid(), {number})")
    assert ended.text == f"The work was killed {words}."


def test_a_fault_of_a_handler_is_told_and_an_answer_that_cannot_cross_as_well(monkeypatch):
    broken = {ListRuns: lambda channel, asked: {1, 2}, FitRun: lambda channel, asked: 1 / 0}
    monkeypatch.setattr(worker, "HANDLERS", broken)
    for command, words in ((ListRuns(), "a set cannot cross"), (FitRun("r", "ml"), "division by zero")):
        failed = worker.carried_out(None, Request(1, command))
        assert (failed.number, failed.fault.kind) == (1, "crash")
        assert words in failed.fault.details  # for who mends labcal


def test_messages_cannot_be_changed_on_their_way():
    with pytest.raises(AttributeError):
        FitRun("r1", "ml").method = "ekf"
    assert replace(FitRun("r1", "ml"), method="ekf").method == "ekf"
