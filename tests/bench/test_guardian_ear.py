"""What the guardian hears: nothing that is said keeps it from hearing the next, and only its session sets currents."""

from __future__ import annotations

import json
import os
import select
import socket
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import closing, suppress
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest
from served_lab import EXAMPLE, until

from labcal.bench.guardian import server, wire
from labcal.bench.guardian.client import Connection
from labcal.bench.guardian.server import CALLERS, LINE_BYTES, ORDERS, Server
from labcal.bench.links import ports
from labcal.bench.links.holders import Process
from labcal.errors import InstrumentError

BENCH = "f" * 64
LONG_S = 60.0


class Coils:
    """Takes orders and keeps them."""

    def __init__(self) -> None:
        self.coils: dict[str, Any] = {}
        self.unresolved: dict[str, Any] = {}
        self.energised = self.in_hand = False
        self.heard = list[tuple[Any, ...]]()

    def zero(self, why: str, *, by_session: bool = False) -> list[Any]:
        self.heard.append(("zero", why, by_session))
        return []

    def give_back(self) -> None:
        self.given_back = len(self.heard)

    def set_current(self, axis: str, current_A: float) -> None:
        self.heard.append((axis, current_A))

    def facts(self) -> dict[str, Any]:
        return {}

    def ignore(self, *_: Any, **__: Any) -> None: ...

    identify = reopen = modbus = set_point = measure_current = read = output = order_zero = ignore


class Ear:
    """A guardian that listens, without supplies."""

    def __init__(self) -> None:
        self.coils = Coils()
        self.listener, self.card = wire.listen()
        self.server = Server(self.coils, self.listener, self.card["token"], BENCH)
        self.server.ready.set()
        self.server.start()

    def call(self, first: bytes | None = None) -> socket.socket:
        """A caller; it says the token, or `first`."""
        caller = wire.connect(self.card, LONG_S)
        with suppress(ConnectionError):  # whoever says too much may be hung up on in mid-word
            caller.sendall(wire.packed({"token": self.card["token"]}) if first is None else first)
        return caller

    def asked(self, *messages: Any) -> list[Any]:
        """What a new caller is answered."""
        with self.call() as caller:
            return [told(caller, message) for message in messages]


def told(caller: socket.socket, message: Any) -> Any:
    caller.sendall(json.dumps(message).encode() + b"\n")
    return json.loads(caller.makefile("rb").readline())


def hung_up(caller: socket.socket) -> bool:
    """Whether the guardian closes the line; what it answers before is read away."""
    try:
        while select.select([caller], [], [], LONG_S)[0]:
            if not caller.recv(65536):
                return True
    except OSError:
        return True
    return False


@pytest.fixture
def ear() -> Iterator[Ear]:
    ear = Ear()
    yield ear
    wire.unlisten(ear.listener, ear.card)


@pytest.mark.parametrize(
    "first",
    [b"\n", b"5\n", b"[]\n", b'{"token": 1}\n', '{"token": "é"}\n'.encode(), b"[" * 60_000 + b"\n", b"\xff\xfe\n",
     b"x" * (LINE_BYTES + 1)],
    ids=range(8),
)  # fmt: skip
def test_who_does_not_know_the_token_is_hung_up_on(ear: Ear, first: bytes) -> None:
    with ear.call(first) as caller:
        assert hung_up(caller)
    assert ear.asked({"order": "status"})[0]["value"] == {"energised": False, "in_hand": False, "unresolved": []}


@pytest.mark.parametrize(
    "line", [b"5\n", b"{\n", b"[" * 60_000 + b"\n", b"null\n", b'"order"\n', b"x" * (LINE_BYTES + 1)], ids=range(6)
)
def test_a_session_that_talks_nonsense_is_gone(ear: Ear, line: bytes) -> None:
    with ear.call() as caller:
        assert "value" in told(caller, {"order": "hello", "with": {"who": "session 1", "bench": BENCH}})
        session = ear.server.session
        with suppress(ConnectionError):
            caller.sendall(line)
        assert hung_up(caller)
    assert session is not None
    until(lambda: session.gone)


def test_a_person_hears_of_zero_before_the_panels_are_given_back(ear: Ear, monkeypatch: pytest.MonkeyPatch) -> None:
    heard, given_back = threading.Event(), threading.Event()

    def slow() -> None:  # as on a line that takes a second for it
        assert heard.wait(LONG_S)
        given_back.set()

    monkeypatch.setattr(ear.coils, "give_back", slow)
    assert ear.asked({"order": "zero"})[0]["value"] == []
    assert not given_back.is_set()
    heard.set()
    assert given_back.wait(LONG_S)


@pytest.mark.parametrize(
    "order",
    [{"order": {}}, {"order": "__class__"}, {"order": "set_current"}, {"order": "set_current", "with": 5},
     {"order": "set_current", "with": {"axis": "x", "current_A": "1"}}, {"order": "facts", "with": {"x": 1}},
     {"order": "set_current", "with": {"axis": [1], "current_A": 1.0}}, {"order": "hello", "with": {}}],
    ids=range(8),
)  # fmt: skip
def test_an_order_that_is_none_is_answered_with_an_error_and_the_next_is_heard(ear: Ear, order: Any) -> None:
    with ear.call() as caller:
        told(caller, {"order": "hello", "with": {"who": "session 1", "bench": BENCH}})
        assert "error" in told(caller, order)
        assert "value" in told(caller, {"order": "set_current", "with": {"axis": "x", "current_A": 0.5}})
    assert ear.coils.heard == [("x", 0.5)]


def test_a_window_that_drives_the_bench_is_called_one(ear: Ear, monkeypatch: pytest.MonkeyPatch) -> None:
    worker = Process(7, os.getuid(), "python3 -P -m labcal.gui.ipc.worker", datetime.now(UTC))
    monkeypatch.setattr(server, "process", lambda pid: worker)
    with ear.call() as caller:
        told(caller, {"order": "hello", "with": {"who": "session 7", "bench": BENCH}})
        (second,) = ear.asked({"order": "hello", "with": {"who": "session 8", "bench": BENCH}})
    assert second["error"]["what"] == "labcal's window (session 7) drives this bench."


def test_only_the_session_sets_currents_and_anybody_says_zero(ear: Ear) -> None:
    with ear.call() as caller:
        told(caller, {"order": "hello", "with": {"who": "session 7", "bench": BENCH}})
        for order in ("set_current", "output", "modbus", "reopen"):
            (answer,) = ear.asked({"order": order, "with": {"axis": "x", "current_A": 0.5}})
            assert answer["error"]["fault"] == "forbidden"
        (second,) = ear.asked({"order": "hello", "with": {"who": "session 8", "bench": BENCH}})
        assert second["error"]["what"] == "session 7 drives this bench."
        ear.asked({"order": "zero"}, {"order": "zero", "with": {"why": "a person"}})
        until(lambda: ear.coils.given_back == 2)  # after the answer
        told(caller, {"order": "zero", "with": {"why": "the session"}})
    assert ear.coils.given_back == 2  # after zero, and not under the session's hands
    assert ear.coils.heard == [
        ("zero", "a caller said so", False),
        ("zero", "a person", False),
        ("zero", "the session", True),
    ]


def test_a_session_that_hung_up_is_gone_at_once_and_nothing_of_it_is_obeyed_any_more(
    ear: Ear, monkeypatch: pytest.MonkeyPatch
) -> None:
    begun, go_on = threading.Event(), threading.Event()

    def slow(axis: str, current_A: float) -> None:
        begun.set()
        assert go_on.wait(LONG_S)
        ear.coils.heard.append((axis, current_A))

    monkeypatch.setattr(ear.coils, "set_current", slow)
    ear.server._orders["set_current"] = slow
    with ear.call() as caller:
        told(caller, {"order": "hello", "with": {"who": "session 7", "bench": BENCH}})
        for current_A in (0.5, 0.6):
            caller.sendall(wire.packed({"order": "set_current", "with": {"axis": "x", "current_A": current_A}}))
        assert begun.wait(LONG_S)
    session = ear.server.session
    assert session is not None
    until(lambda: session.gone)  # while its first order is still under way
    assert ear.coils.heard == []
    go_on.set()
    until(lambda: session.room._value == ORDERS)  # both were worked off
    assert ear.coils.heard == [("x", 0.5)]


@pytest.mark.parametrize("bench", [BENCH, "of another file"])
def test_who_may_not_begin_is_told_what_is_not_at_zero_and_which_guardian_tries(ear: Ear, bench: str) -> None:
    ear.coils.unresolved = {"x": InstrumentError("coil x does not answer.", fault="silent", remedy="Plug it in.")}
    (answer,) = ear.asked({"order": "hello", "with": {"who": "session 1", "bench": bench}})
    assert answer["error"]["what"] == "coil x does not answer."
    assert f"kill {os.getpid()}" in answer["error"]["mends"]
    assert ear.server.dismissed.is_set() == (bench != BENCH)


def test_a_crowd_that_says_nothing_is_held_to_its_places(ear: Ear) -> None:
    crowd = [ear.call(b"") for _ in range(CALLERS)]
    with ear.call(b"") as one_more:
        assert hung_up(one_more)
    for caller in crowd:
        caller.close()


CRASHES = """
import runpy, sys
from labcal.bench.guardian import controller
controller.Guardian.zero = lambda *_, **__: (sys.stdin.readline(), 1 / 0)
sys.argv = ["guardian", sys.argv[1]]
runpy.run_module("labcal.bench.guardian", run_name="__main__")
"""


def test_a_guardian_that_fails_lets_go_of_its_ports_though_somebody_waits_for_it(tmp_path: Path) -> None:
    link = f"tcp://{'-'.join(tmp_path.parts[-3:])}:1"  # nobody else tests with it
    text = EXAMPLE.read_text(encoding="utf-8")
    file = tmp_path / "bench.toml"
    file.write_text(text[: text.rindex("[twin]")].replace("emulated://", link, 1), encoding="utf-8")
    command = [sys.executable, "-c", CRASHES, str(file)]
    with subprocess.Popen(command, stdin=-1, stdout=-1, stderr=-1, text=True) as guardian:
        assert guardian.stdin is not None
        until(lambda: "address" in (ports.holder(link) or {}))
        card = ports.holder(link) or {}
        assert card["bench"] == str(file.resolve())
        with closing(Connection(card)) as caller:
            caller.order("status")
            guardian.stdin.write("\n")
            guardian.stdin.flush()
            assert guardian.wait(LONG_S) == 1
    assert ports.holder(link) is None
