"""Instruments are identified at the same time where their lines are apart, and a line is looked at by one at a time."""

from __future__ import annotations

import socket
import threading
from datetime import UTC, datetime
from typing import Any

import pytest

from labcal.bench.clock import RealClock, VirtualClock
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.identification import Identifications, identified
from labcal.bench.links import open_link
from labcal.errors import InstrumentError

LONG_S = 60.0  # a busy machine gets there within it


class Waits:
    """Answers once as many have been asked as `all_asked` waits for; keeps the thread that asked."""

    def __init__(self, name: str, all_asked: Any = None, fault: str = "") -> None:
        self.name, self._all_asked, self._fault, self.thread = name, all_asked, fault, 0

    def identify(self) -> Identity:
        self.thread = threading.get_ident()
        if self._all_asked is not None:
            self._all_asked.wait(LONG_S)
        if self._fault:
            raise InstrumentError(f"{self.name}: nothing came", fault=self._fault)
        return Identity("maker", self.name, "1")


def test_those_on_lines_apart_are_asked_at_the_same_time_and_the_rest_here() -> None:
    barrier, clock, names = threading.Barrier(4), RealClock(), "abcd"
    there: dict[str, Any] = {name: Waits(name, barrier) for name in names}
    who = identified(there, {name: f"tcp://{name}" for name in "abd"}, clock)
    assert list(who) == list(names)
    assert there["c"].thread == threading.get_ident()
    assert len({one.thread for one in there.values()}) == 4


def test_those_on_one_line_are_asked_one_after_another() -> None:
    there: dict[str, Any] = {name: Waits(name) for name in "abc"}
    identified(there, {"a": "tcp://1", "b": "tcp://1", "c": "tcp://2"}, RealClock())
    assert there["a"].thread == there["b"].thread != threading.get_ident()


def test_in_simulated_time_all_are_asked_here() -> None:
    there: dict[str, Any] = {name: Waits(name) for name in "ab"}
    identified(there, {"a": "tcp://1", "b": "tcp://2"}, VirtualClock(datetime(2026, 1, 1, tzinfo=UTC)))
    assert {one.thread for one in there.values()} == {threading.get_ident()}


@pytest.mark.parametrize("apart", ["", "ab", "abcd"])
def test_the_first_of_the_file_that_is_at_fault_is_told(apart: str) -> None:
    there: dict[str, Any] = {name: Waits(name, fault="silent" if name in "bd" else "") for name in "abcd"}
    with pytest.raises(InstrumentError, match="b: nothing came"):
        identified(there, dict.fromkeys(apart, "tcp://1"), RealClock())


def test_those_that_were_asked_while_others_were_not_there_yet_are_asked_once() -> None:
    asked = list[str]()

    class Counts(Waits):
        def identify(self) -> Identity:
            asked.append(self.name)
            return super().identify()

    there, lines, begun = {name: Counts(name) for name in "abc"}, {"a": "tcp://1", "b": "tcp://1"}, Identifications()
    begun.begin({name: there[name] for name in lines}, lines, RealClock())
    who = identified(begun.instead(there), lines, RealClock())
    assert [one.model for one in who.values()] == list("abc")
    assert sorted(asked) == list("abc")


def test_one_that_was_silent_when_it_was_asked_too_early_is_asked_again() -> None:
    there: dict[str, Any] = {name: Waits(name, fault="silent" if name in "bc" else "") for name in "abc"}
    lines, begun = {"b": "tcp://1", "c": "tcp://1"}, Identifications()
    begun.begin({name: there[name] for name in lines}, lines, RealClock())
    with pytest.raises(InstrumentError, match="b: nothing came"):
        identified(begun.instead(there), lines, RealClock())
    there["b"]._fault = there["c"]._fault = ""
    assert list(identified(begun.instead(there), lines, RealClock())) == list("abc")


def test_in_simulated_time_nobody_is_asked_before_the_others_are_there() -> None:
    there: dict[str, Any] = {"a": Waits("a")}
    begun = Identifications()
    begun.begin(there, {"a": "tcp://1"}, VirtualClock(datetime(2026, 1, 1, tzinfo=UTC)))
    assert begun.instead(there) == there


def test_while_others_are_asked_waiting_here_looks_at_every_line_and_waiting_there_at_none() -> None:
    clock, seen, looked = RealClock(), set[int](), threading.Event()

    def look() -> None:
        seen.add(threading.get_ident())
        looked.set()

    class WaitsOnTheClock(Waits):
        def identify(self) -> Identity:
            clock.wait_until(clock.now() + 0.02)
            looked.wait(LONG_S)
            return super().identify()

    clock.while_waiting(look)
    identified({"a": WaitsOnTheClock("a")}, {"a": "tcp://1"}, clock)
    assert seen == {threading.get_ident()}
    clock.wait_until(clock.now() + 0.01)


def test_a_line_that_is_looked_at_elsewhere_loses_nothing_and_keeps_its_order() -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        link: Any = open_link(f"tcp://127.0.0.1:{server.getsockname()[1]}", RealClock())
        port, reading, go_on = link._port, threading.Event(), threading.Event()
        parts = [b"first ", b"second"]

        def read() -> bytes:
            part = parts.pop(0) if parts else b""
            if part == b"first ":
                reading.set()
                go_on.wait(LONG_S)
            return part

        port.read = read
        elsewhere = threading.Thread(target=link.look, daemon=True)
        elsewhere.start()
        assert reading.wait(LONG_S)
        threading.Timer(0.1, go_on.set).start()
        assert b"".join(piece for _, piece in link.receive(0.0)) == b"first second"
        elsewhere.join()
        link.close()
