"""The field as a simulator outside wants it: followed, doubted, and the coils at zero when it is not to be believed."""

from __future__ import annotations

import re
import socket
import subprocess
import sys
from collections.abc import Callable, Sequence
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest

from labcal import session
from labcal.bench import open_bench
from labcal.bench.clock import Clock, RealClock, VirtualClock
from labcal.bench.links import EmulatedLink, Link
from labcal.bench.streams.field_datagrams import EndOfSource, WantedField, answer, parse
from labcal.bench.streams.field_source import FieldSource, open_line
from labcal.errors import InputError, InstrumentError, LimitError
from labcal.record.stream import Event, Measurement, Prompt
from labcal.runner import find
from labcal.runner.drive import Ending
from labcal.runner.prompts import first_choice
from labcal.testing.procedures import ProcedureTrial
from procedures.play_field import play_field

PAGE = Path(__file__).resolve().parents[2] / "docs" / "field-source.md"
RATE_HZ, GOES_WRONG = 10, 45
Says = Callable[[int], bytes]
BenchFile = Callable[..., Path]


def good(number: int) -> bytes:
    """A field of 40 µT that turns by 1 deg/s about x, in the quadrant where no coil changes its sign."""
    angle, t = np.radians(20 + number / RATE_HZ), number / RATE_HZ
    return b"labcal-field/1,%d,%.3f,5000.0,%.1f,%.1f\n" % (number, t, 4e4 * np.cos(angle), 4e4 * np.sin(angle))


def from_then_on(what: Says) -> Says:
    """Good, and `what` from number 45 on."""
    return lambda number: good(number) if number < GOES_WRONG else what(number)


def edited(place: int, text: bytes) -> Says:
    """A good datagram of which one word is another."""

    def says(number: int) -> bytes:
        words = good(number).split(b",")
        words[place] = text
        return b",".join(words)

    return says


class Simulator:
    """Sends ten datagrams a second from `start_s` on, and hears what it is told."""

    def __init__(self, says: Says, start_s: float = 6.0, late_s: Callable[[int], float] = lambda number: 0.0) -> None:
        self._says, self._start_s, self._late_s, self._next = says, start_s, late_s, 0
        self.told: list[bytes] = []
        self.wrong_s = start_s + GOES_WRONG / RATE_HZ

    def take(self, t_s: float, data: bytes) -> None:
        self.told.append(data)

    def emit(self, until_s: float) -> list[tuple[float, bytes]]:
        pieces = []
        while (due := self._start_s + self._next / RATE_HZ + self._late_s(self._next)) <= until_s:
            pieces += [(due, said)] if (said := self._says(self._next)) else []
            self._next += 1
        return pieces


class Played:
    """play-field with a simulator, on the simulated bench in simulated time."""

    def __init__(self, bench: Path, simulator: Simulator, monkeypatch: pytest.MonkeyPatch, **given: object) -> None:
        def line(url: str, clock: Clock) -> Link:
            return EmulatedLink(url, simulator, clock)

        monkeypatch.setattr("procedures.from_outside.open_line", line)
        said = {"source": "udp://127.0.0.1:5700", "duration_s": "10", "limit_nT": "5000"}
        said |= {key: str(value) for key, value in given.items()}
        self.simulator = simulator
        self._trial = ProcedureTrial(find("play-field"), said, bench, first_choice)
        self.ending: Ending = self._trial.run()
        self.left_A = self._trial.left_A
        self.events = [i for i in self._trial.items if isinstance(i, Event)]
        self.measured = {i.name: i for i in self._trial.items if isinstance(i, Measurement)}
        self.prompts = [i for i in self._trial.items if isinstance(i, Prompt)]

    def true_A(self, times_s: Sequence[float]) -> np.ndarray:
        """The true currents (n, 3), asked of the physics."""
        coils = self._trial.bench.simulated_operator._lab.coils
        return np.column_stack([coils[axis].at(times_s) for axis in "xyz"])


def played(bench_file: BenchFile, monkeypatch: pytest.MonkeyPatch, says: Says, **given: object) -> Played:
    return Played(bench_file(), Simulator(says), monkeypatch, **given)


def not_all(number: int) -> bytes:
    """Two are lost, one comes twice, one is somebody else's, and at 8 s the source says that it ends."""
    if number >= 80:
        return b"labcal-field/1,%d,end\n" % number
    return {31: b"", 32: b"", 36: good(35), 39: b"hello"}.get(number, good(number))


def test_the_coils_follow_and_what_they_do_is_measured(bench_file: BenchFile, monkeypatch: pytest.MonkeyPatch) -> None:
    done = Played(bench_file(), Simulator(not_all, late_s=lambda number: 0.04 * (number % 2)), monkeypatch)
    assert done.ending.status == "finished"
    assert [prompt.acts for prompt in done.prompts] == [True]
    assert done.left_A < 0.002
    of_each = [event.data for event in done.events if "latency_s" in event.data]
    latency = done.measured["latency"]
    assert latency.value == pytest.approx(np.mean([data["latency_s"] for data in of_each]))
    assert latency.unit == "s"
    assert min(data["latency_s"] for data in of_each) > 0.3  # no field stands before the coils have settled
    turns_nT_per_s = 4e4 * np.radians(1.0)
    longest_s = max(data["latency_s"] for data in of_each)
    assert 0.2 * turns_nT_per_s < done.measured["rms tracking error"].value < 1.5 * turns_nT_per_s * longest_s
    assert done.measured["jitter of the source"].value == pytest.approx(0.02, rel=0.05)
    (counts,) = (event.data for event in done.events if "lost" in event.data)
    assert (counts["lost"], counts["repeated"], counts["foreign"], counts["set"]) == (4, 1, 1, len(of_each))
    is_told_what_stands(done, len(of_each))


def is_told_what_stands(done: Played, n: int) -> None:
    """Every field that was set is answered, with what the currents that were read back make."""
    told = [said.decode().strip().split(",") for said in done.simulator.told]
    assert len(told) == n > 5
    for words in told:
        assert words[:2] == ["labcal-field/1", "set"]
        wanted = parse(good(int(words[2])), 0.0)
        assert isinstance(wanted, WantedField)
        assert np.array(words[4:], float) == pytest.approx(wanted.b_nT, abs=200)  # a milliampere is 50 nT


IN_THE_LAB = {
    "stops": (lambda number: b"", "no new field for 1.", 1.0),
    "jumps": (edited(4, b"-40000.0"), "jumps by", 0.0),
    "repeats": (lambda number: good(GOES_WRONG - 1), "no new field for 1.", 1.0),
    "sends NaN": (edited(4, b"nan"), "no number, time and three fields", 0.0),
    "is beyond limits": (edited(4, b"1e9"), "is beyond its limit", 0.0),
}


@pytest.mark.parametrize("what", IN_THE_LAB)
def test_a_source_that_is_not_to_be_believed_ends_at_zero_within_two_seconds(
    what: str, bench_file: BenchFile, monkeypatch: pytest.MonkeyPatch
) -> None:
    says, sentence, noticed_after_s = IN_THE_LAB[what]
    done = played(bench_file, monkeypatch, from_then_on(says))
    assert done.ending.status.startswith("failed: ")
    assert isinstance(done.ending.fault, InstrumentError | LimitError)
    assert sentence in str(done.ending.fault)
    assert done.left_A < 0.002
    wrong_s, zero_s = done.simulator.wrong_s, done.simulator.wrong_s + noticed_after_s + 2.0
    assert np.abs(done.true_A([wrong_s - 0.1])).max() > 0.5
    assert done.true_A([zero_s]) == pytest.approx(0.0, abs=0.002)
    assert np.abs(done.true_A(np.arange(0.0, zero_s, 0.01))).max() < 1.5  # the fields wanted need 1.3 A


def listened(says: Says, seconds: float = 8.0) -> FieldSource:
    """A source that is looked at every 20 ms, and may ask for 50 µT."""
    clock = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))

    def refuse(b_nT: np.ndarray) -> None:
        if np.linalg.norm(b_nT) > 5e4:
            raise LimitError("beyond")

    source = FieldSource(
        EmulatedLink("udp://127.0.0.1:5700", Simulator(says, 0.0), clock), clock,
        refuse=refuse, ramp_s=lambda step: float(np.abs(step).max()) / 1e5, silent_s=1.0, max_age_s=0.5,
    )  # fmt: skip
    source.begin()
    while clock.now() < seconds:
        clock.wait_until(clock.now() + 0.02)
        source.look()
    return source


WRONG: dict[str, tuple[Says, str, str]] = {
    "stops": (lambda number: b"", "no new field for 1.0", "silent"),
    "begins anew": (lambda number: good(number - GOES_WRONG), "no new field for 1.0", "silent"),
    "repeats": (lambda number: good(GOES_WRONG - 1), "no new field for 1.0", "silent"),
    "sends what is not ours": (lambda number: b"\xffFTW" * 20, "no new field for 1.0", "silent"),
    "jumps": (edited(4, b"-40000.0"), "jumps by", "jump"),
    "not a number": (edited(4, b"nan"), "no number, time and three fields", "wrong reply"),
    "no end": (edited(4, b"-inf"), "no number, time and three fields", "wrong reply"),
    "time is no number": (edited(2, b"nan"), "no number, time and three fields", "wrong reply"),
    "beyond nature": (edited(4, b"1e10"), "no number, time and three fields", "wrong reply"),
    "underscores": (edited(4, b"1_000"), "no number, time and three fields", "wrong reply"),
    "no number": (edited(1, b"x"), "no number, time and three fields", "wrong reply"),
    "nothing but its name": (lambda number: b"labcal-field/1,", "no number, time and three fields", "wrong reply"),
    "too many": (lambda number: good(number).strip() + b",1\n", "no number, time and three fields", "wrong reply"),
    "too long": (lambda number: good(number).strip() + b"0" * 300, "no number, time and three fields", "wrong reply"),
    "its time stands": (edited(2, b"4.4"), "its time does not go on", "stale"),
    "its time is slow": (lambda n: edited(2, b"%.3f" % (4.5 + (n - 45) * 0.03))(n), "s old, beside", "stale"),
    "its time runs": (lambda n: edited(2, b"%.3f" % (4.5 + (n - 45) * 0.4))(n), "ahead of ours", "stale"),
}


@pytest.mark.parametrize("what", WRONG)
def test_what_is_not_believed_is_said(what: str) -> None:
    says, sentence, fault = WRONG[what]
    with pytest.raises(InstrumentError, match=sentence) as caught:
        listened(from_then_on(says))
    assert caught.value.fault == fault
    assert caught.value.remedy


def test_a_field_beyond_a_limit_is_refused_even_where_a_newer_one_is_not() -> None:
    once = {GOES_WRONG: edited(3, b"60000.0")(GOES_WRONG)}
    with pytest.raises(LimitError):
        listened(lambda number: once.get(number, good(number)))


def test_a_source_that_is_good_is_believed_throughout() -> None:
    source = listened(good)
    assert source.counts.received == 80
    assert source.offsets.jitter_s == pytest.approx(0.0, abs=1e-9)
    assert [wanted.number for wanted in source.taken()] == list(range(1, 81))  # begin() drops what came before
    assert source.taken() == []


def test_nobody_sends_and_nothing_is_energised(bench_file: BenchFile, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("procedures.from_outside.FIRST_S", 3.0)
    done = played(bench_file, monkeypatch, lambda number: b"")
    assert "no new field for 3." in str(done.ending.fault)
    assert not [event for event in done.events if event.kind == "set-point"]


@pytest.mark.parametrize(
    ("data", "number"),
    [
        (b"labcal-field/1,7,1.5,-1e3,2.50,0", 7),
        (b"labcal-field/1,7,1.5,-1000.,2.5,0\r\n", 7),
        (b"labcal-field/1,0007,1.5,-1000,2.5,0\n", 7),
    ],
)
def test_numbers_as_programs_write_them(data: bytes, number: int) -> None:
    wanted = parse(data, 3.0)
    assert isinstance(wanted, WantedField)
    assert (wanted.number, wanted.t_s, wanted.b_nT.tolist(), wanted.arrived_s) == (number, 1.5, [-1e3, 2.5, 0], 3.0)


def test_words_of_the_protocol() -> None:
    assert parse(b"labcal-field/1,8,end\n", 0.0) == EndOfSource(8)
    assert parse(b"labcal-field/2,8,end\n", 0.0) is None
    assert answer(8, 0.4567, np.array([1.0, -2.04, 0.0])) == b"labcal-field/1,set,8,0.4567,1.0,-2.0,0.0\n"


def test_what_cannot_be_is_said_before_anything_is_measured(bench_file: BenchFile) -> None:
    given = {"source": "udp://127.0.0.1:5700"}
    with pytest.raises(InputError, match="say --clock real"):
        session.run("play-field", bench_file(), given).raise_fault()
    with pytest.raises(InputError, match="a file or a source, not both"):
        next(play_field(open_bench(bench_file()), file=Path("history.csv"), **given))
    with pytest.raises(InputError, match="expected udp://HOST:PORT"):
        open_line("tcp://127.0.0.1:5700", RealClock())
    with pytest.raises(InputError, match="states no port"):
        open_line("udp://127.0.0.1", RealClock())


def test_a_silence_in_the_first_ramp_ends_it(bench_file: BenchFile, monkeypatch: pytest.MonkeyPatch) -> None:
    two = Simulator(lambda number: good(number) if number < 2 else b"", start_s=8.0)
    done = Played(bench_file(), two, monkeypatch, silent_s=3)
    assert "no new field for 3." in str(done.ending.fault)
    assert done.true_A([8.1 + 3.0 + 2.0]) == pytest.approx(0.0, abs=0.002)
    assert np.abs(done.true_A(np.arange(8.0, 11.0, 0.01))).max() > 0.1


@pytest.mark.slow
def test_the_simulator_of_the_page_over_a_real_port_in_true_time(bench_file: BenchFile) -> None:
    (simulator,) = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    sends = simulator.replace("5005", str(port)).replace("60.0", "25.0")
    given = {"source": f"udp://127.0.0.1:{port}", "silent_s": "10", "max_age_s": "10", "limit_nT": "5000"}
    with subprocess.Popen([sys.executable, "-c", sends]) as process:
        outcome = session.run("play-field", bench_file(), given, clock=RealClock(), seed=3)
    assert process.returncode == 0
    assert outcome.status == "finished", outcome.fault
