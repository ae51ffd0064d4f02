"""What is given up when a gate closes: its reply, which still comes, answers nothing that is asked later."""

from __future__ import annotations

import threading
import time
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest

from drivers import korad_ka3005p
from labcal.bench.clock import RealClock, VirtualClock
from labcal.bench.config import read_config
from labcal.bench.guardian.gate import Gate, GatedLink, GatedLoader
from labcal.bench.links.deny import DenyList
from labcal.bench.links.modbus import ModbusLink
from labcal.errors import InstrumentError

EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"
SLOW_S = 0.2  # of this instrument, to answer


class SlowLine:
    """A line to an instrument that answers every message with `answer(message)`, `SLOW_S` later."""

    url, emulated, never = "test://", True, DenyList()

    def __init__(self, answer: Any) -> None:
        self._answer, self._due = answer, list[tuple[float, bytes]]()
        self.sent = list[bytes]()

    def send(self, data: bytes) -> None:
        self.sent.append(data)
        self._due.append((time.monotonic() + SLOW_S, self._answer(data)))

    def receive(self, until_s: float) -> list[tuple[float, bytes]]:
        time.sleep(max(0.0, until_s - time.monotonic()))
        came = [due for due in self._due if due[0] <= time.monotonic()]
        self._due = [due for due in self._due if due not in came]
        return came

    def give_back(self, t_s: float, data: bytes) -> None:
        self._due.insert(0, (t_s, data))


def given_up(gate: Gate, ask: Any) -> None:
    """Another thread asks, and the gate closes while it waits."""
    raised = list[InstrumentError]()

    def asking() -> None:
        try:
            ask()
        except InstrumentError as error:
            raised.append(error)

    thread = threading.Thread(target=asking)
    thread.start()
    time.sleep(SLOW_S / 4)
    gate.close()
    thread.join()
    assert [error.fault for error in raised] == ["taken to zero"]


def text_line() -> tuple[SlowLine, Gate, GatedLink]:
    slow: Any = SlowLine(lambda said: b"answer to " + said)
    gate = Gate()
    return slow, gate, GatedLink(slow, gate, RealClock())


def test_the_reply_to_a_question_that_was_given_up_is_not_the_answer_to_the_next() -> None:
    slow, gate, link = text_line()
    given_up(gate, lambda: link.ask(b"the set-point?\n", end=b"\n", timeout_s=2.0))
    with gate.passing():
        link.send(b"zero\n")
        slow._due.pop()  # a set has no answer
        assert link.ask(b"what flows?\n", end=b"\n", timeout_s=2.0) == b"answer to what flows?\n"
    assert link.ask(b"who?\n", end=b"\n", timeout_s=2.0) == b"answer to who?\n"


def test_zero_is_sent_without_waiting_for_it() -> None:
    slow, gate, link = text_line()
    given_up(gate, lambda: link.ask(b"the set-point?\n", end=b"\n", timeout_s=2.0))
    begun = time.monotonic()
    with gate.passing():
        link.flush()
        link.send(b"zero\n")
    assert slow.sent[-1] == b"zero\n"
    assert time.monotonic() - begun < SLOW_S / 2


def test_where_that_reply_never_comes_the_next_one_counts() -> None:
    slow, gate, link = text_line()
    given_up(gate, lambda: link.ask(b"the set-point?\n", end=b"\n", timeout_s=2.0))
    slow._due.clear()
    with gate.passing():
        assert link.ask(b"what flows?\n", end=b"\n", timeout_s=2.0) == b"answer to what flows?\n"


@pytest.mark.parametrize("registers", [(b"\x01\x03\x02\x07\x62\x3b\x9d", b"\x01\x03\x02\x00\x00\xb8\x44")])
def test_of_registers_likewise_though_their_frames_are_alike(registers: tuple[bytes, bytes]) -> None:
    held, zero = registers
    slow: Any = SlowLine(lambda said: held if said[2:4] == b"\x00\x01" else zero)
    gate, clock = Gate(), RealClock()
    master = ModbusLink(GatedLink(slow, gate, clock), clock, timeout_s=2.0)
    given_up(gate, lambda: master.read_holding(1, 2, 1))
    with gate.passing():
        assert master.read_holding(1, 1, 1) == [0x0762]


def test_a_healthy_line_waits_for_nothing() -> None:
    _, _, link = text_line()
    begun = time.monotonic()
    for _ in range(3):
        assert link.ask(b"who?\n", end=b"\n", timeout_s=2.0) == b"answer to who?\n"
    assert time.monotonic() - begun < 3 * SLOW_S + 0.25


def test_supplies_on_one_line_each_answer_for_themselves_behind_it(tmp_path: Path) -> None:
    text = EXAMPLE.read_text()
    for address, axis in enumerate("xyz", 6):
        head = f"[instruments.supply_{axis}]\n"
        ours = f'{head}driver = "genesys"\nlink = "emulated://pair"\nsettings = {{ address = {address} }}\n'
        text = text.replace(f'{head}driver = "tti-pl"\nlink = "emulated://"\n', ours)
    (path := tmp_path / "bench.toml").write_text(text)
    loader = GatedLoader(path, read_config(path), VirtualClock(datetime(2026, 1, 1, tzinfo=UTC)), 1)
    supplies: list[Any] = [loader.instrument(f"supply_{axis}") for axis in "xyz"]
    for current_A, supply in enumerate(supplies):
        supply.identify()
        supply.output(True)
        supply.set_current(current_A)
    loader.clock.wait_until(loader.clock.now() + 3.0)
    assert [round(supply.measure_current(), 2) for supply in supplies] == [0.0, 1.0, 2.0]


def test_of_replies_without_an_end_likewise_and_the_supply_is_not_blamed() -> None:
    slow: Any = SlowLine(lambda said: {b"ISET1?": b"0.500K", b"IOUT1?": b"0.001"}.get(said, b""))
    gate, clock = Gate(), RealClock()
    settings = korad_ka3005p.Settings(gap_s=0.01, timeout_s=15.0)
    supply = korad_ka3005p.KoradSupply("supply_x", GatedLink(slow, gate, clock), clock, settings)
    given_up(gate, supply.set_point)
    with gate.passing():
        supply.write_current(0.0)
        assert slow.sent == [b"ISET1?", b"ISET1:0.000"]
        assert supply.measure_current() == 0.001
    assert supply.set_point() == 0.5
