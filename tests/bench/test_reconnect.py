"""A plug that is pulled and put in again: a real pty that goes and comes back, with the same instrument or another."""

from __future__ import annotations

import os
import pty
import sys
import threading
import tty
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from datetime import UTC, datetime
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from drivers.emulators.hmr2300 import Hmr2300Emulator
from drivers.emulators.tti_pl import TtiEmulator
from drivers.emulators.zaber import ZaberEmulator
from labcal.bench import Bench, open_bench
from labcal.bench.clock import RealClock, VirtualClock
from labcal.bench.coils.state import NOT_CONFIRMED
from labcal.bench.streams import reconnect
from labcal.bench.streams.reconnect import BACK_S, Reconnecting, bring_back
from labcal.errors import InstrumentError, Stopped
from labcal.record.stream import Block
from labcal.twin import open_twin

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="Windows has no ptys")
EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"
PATIENCE_S = 60.0


class Plug:
    """A serial adapter at a fixed path that can be pulled out and put in."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def put_in(self, emulator: Any) -> None:
        self._master, self._slave = pty.openpty()
        tty.setraw(self._slave)
        os.set_blocking(self._master, False)
        self._out = threading.Event()
        self._thread = threading.Thread(target=self._pump, args=(emulator,), daemon=True)
        self._thread.start()
        self.path.symlink_to(os.ttyname(self._slave))

    def pull(self) -> None:
        self.path.unlink()
        self._out.set()
        self._thread.join()  # before its descriptors are given to somebody else
        os.close(self._slave)
        os.close(self._master)

    def _pump(self, emulator: Any) -> None:
        clock = RealClock()
        while not self._out.wait(0.002):
            with suppress(BlockingIOError):
                emulator.take(clock.now(), os.read(self._master, 4096))
            with suppress(BlockingIOError):  # nobody reads
                for _, piece in emulator.emit(clock.now()):
                    os.write(self._master, piece)


class OtherSensor(Hmr2300Emulator):
    """Another HMR2300."""

    def _reply(self, t_s: float, text: str) -> bytes:
        return super()._reply(t_s, text).replace(b"12345", b"54321")


def sensor(kind: type[Hmr2300Emulator] = Hmr2300Emulator) -> Hmr2300Emulator:
    return kind(open_twin({}, 1), {}, SimpleNamespace(id=0))


def supply() -> TtiEmulator:
    return TtiEmulator(open_twin({}, 1), {"coil-x": {}}, SimpleNamespace())


@contextmanager
def bench_with(plug: Plug, role: str, silent_s: float = PATIENCE_S) -> Iterator[Bench]:
    """The example bench, with one instrument on a real line; its sensors may be silent for so long."""
    text = EXAMPLE.read_text().replace('role = "reference"', f'role = "reference"\n#{role}', 1)
    driver = {"reference": "hmr2300", "platform": "zaber", "coil-x": "tti-pl"}[role]
    head, tail = f'driver = "{driver}"\nlink = ', f'\nrole = "{role}"'
    text = text[: text.rindex("[twin]")].replace(
        f'{head}"emulated://"{tail}', f'{head}"serial://{plug.path}?baud=115200"{tail}'
    )
    text = text.replace('kind = "vector"', f'kind = "vector"\nsilent_s = {silent_s}')
    text = text.replace('serial = "SIM-0001"\nmodel', f'silent_s = {silent_s}\nserial = "SIM-0001"\nmodel', 1)
    path = plug.path.with_name("bench.toml")
    path.write_text(text)
    with open_bench(path) as bench:
        yield bench


def streamed_until(bench: Bench, fault: str) -> list[Block]:
    """Blocks of the reference until an event of this fault comes; the clock is only there to end what hangs."""
    blocks, deadline = list[Block](), bench.clock.now() + PATIENCE_S
    while bench.clock.now() < deadline:
        blocks += [b for b in bench.stream_until(bench.clock.now() + 0.1) if b.stream == "reference"]
        if fault in [event.data["fault"] for event in bench.news()]:
            return blocks
    raise AssertionError(f"{fault} did not come")


def test_a_sensor_that_was_pulled_is_identified_and_started_again_and_another_one_is_refused(tmp_path: Path) -> None:
    plug = Plug(tmp_path / "ttyUSB0")
    plug.put_in(sensor())
    with bench_with(plug, "reference") as bench:
        bench.start()
        plug.pull()
        streamed_until(bench, "link lost")
        plug.put_in(sensor())
        streamed_until(bench, "reconnected")
        before = bench.clock.now()
        while not (again := [b for b in bench.stream_until(bench.clock.now() + 0.2) if b.stream == "reference"]):
            assert bench.clock.now() < before + PATIENCE_S
        assert again[0].t_s[0] > before
        plug.pull()
        streamed_until(bench, "link lost")
        plug.put_in(sensor(OtherSensor))
        with pytest.raises(InstrumentError, match=r"54321 answers, before it was .*12345") as caught:
            streamed_until(bench, "reconnected")
        assert caught.value.fault == "another instrument"
    plug.pull()


def test_a_stage_that_was_pulled_is_read_again_once_it_is_back(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(reconnect, "BACK_S", PATIENCE_S)
    plug, lab = Plug(tmp_path / "ttyUSB0"), open_twin({}, 1)
    stage = ZaberEmulator(lab, {}, SimpleNamespace(address=1, axis=1))
    plug.put_in(stage)
    with bench_with(plug, "platform") as bench:
        angle = bench.platform.angle_deg()
        plug.pull()
        back = threading.Timer(0.3, plug.put_in, [stage])
        back.start()
        assert bench.platform.angle_deg() == pytest.approx(angle, abs=0.01)
        back.join()
    plug.pull()


def test_a_stage_is_named_as_lost_while_its_line_is_tried_and_stands_as_soon_as_it_is_read(tmp_path: Path) -> None:
    plug, lab = Plug(tmp_path / "ttyUSB0"), open_twin({}, 1)
    stage = ZaberEmulator(lab, {}, SimpleNamespace(address=1, axis=1))
    plug.put_in(stage)
    with bench_with(plug, "platform") as bench:
        said: list[str] = []

        def look() -> None:
            said.append({one.name: one.fault for one in bench.state().instruments}["stage"])

        bench.platform.angle_deg()
        plug.pull()
        back = threading.Timer(0.3, plug.put_in, [stage])
        back.start()
        bench.look = look
        bench.platform.state()
        back.join()
        assert said[0] == "link lost", "before its patience is over"
        bench.look = lambda: None
        assert {one.name: one.fault for one in bench.state().instruments}["stage"] == ""
        plug.pull()
        with pytest.raises(InstrumentError):
            bench.platform.state()
        assert {one.name: one.fault for one in bench.state().instruments}["stage"] == "link lost"
        plug.put_in(stage)
        bench.reconnect("stage")
    plug.pull()


def test_no_try_at_a_stage_begins_after_its_patience() -> None:
    """One that hangs takes as long again."""
    clock, tried = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC)), list[float]()

    def reopen() -> None:
        tried.append(clock.now())
        raise InstrumentError("out", fault="link lost")

    with pytest.raises(InstrumentError):
        bring_back(reopen, clock, InstrumentError("out", fault="link lost"))
    assert clock.now() <= BACK_S
    assert tried[-1] <= BACK_S


AWAY_S, SHORT_S = 1.2, 0.4  # out for three times as long as it may be while nobody is asked


@pytest.mark.parametrize(("role", "name"), [("reference", "reference"), ("platform", "stage")])
def test_while_a_person_is_asked_with_the_coils_at_zero_a_cable_may_be_out_and_after_that_not(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, role: str, name: str
) -> None:
    monkeypatch.setattr(reconnect, "BACK_S", SHORT_S)
    plug, lab = Plug(tmp_path / "ttyUSB0"), open_twin({}, 1)
    there = sensor() if role == "reference" else ZaberEmulator(lab, {}, SimpleNamespace(address=1, axis=1))
    plug.put_in(there)
    with bench_with(plug, role, SHORT_S) as bench:
        bench.start()
        bench.stream_until(bench.clock.now() + 0.5)
        bench.asking = True
        plug.pull()
        bench.stream_until(bench.clock.now() + AWAY_S)
        assert {one.name: one.fault for one in bench.state().instruments}[name] == "link lost"
        plug.put_in(there)
        until_back(bench, name)
        assert role == "reference" or bench.state().platform.moving is False, "no moment at which it is not known"
        assert next(event.data["fault"] for event in bench.news()) == "link lost"
        plug.pull()
        bench.stream_until(bench.clock.now() + AWAY_S)
        bench.asking = False
        with pytest.raises(InstrumentError) as caught:
            bench.stream_until(bench.clock.now() + 60.0)
        assert caught.value.fault == "link lost"
        plug.put_in(there)
        bench.asking = True
        until_back(bench, name)  # else the way to rest has nobody to speak to
    plug.pull()


def test_a_supply_may_be_out_at_such_a_question_and_the_run_goes_on_once_it_answers(tmp_path: Path) -> None:
    plug = Plug(tmp_path / "ttyUSB0")
    plug.put_in(supply())
    with bench_with(plug, "coil-x") as bench:
        bench.start()
        bench.stream_until(bench.clock.now() + 1.5)
        bench.asking = True
        plug.pull()
        until_gone(bench, "supply_x")
        bench.stream_until(bench.clock.now() + 3.0)
        assert bench.sentence() == NOT_CONFIRMED
        assert "supply_x" in bench.still_wrong()  # no answer that energises is taken
        plug.put_in(supply())
        until_back(bench, "supply_x")
        bench.stream_until(bench.clock.now() + 1.5)
        assert all(coil.zero for coil in bench.state().coils)
        assert bench.hands_near
        bench.asking = False
        bench.cage.set_currents([0.1, 0.0, 0.0], confirm_signs=False)  # the run goes on
        bench.cage.zero()
    plug.pull()


def until_gone(bench: Bench, name: str) -> None:
    """Wait until it is missed."""
    deadline = bench.clock.now() + PATIENCE_S
    while not {one.name: one.fault for one in bench.state().instruments}[name]:
        assert bench.clock.now() < deadline
        bench.stream_until(bench.clock.now() + 0.1)


def until_back(bench: Bench, name: str) -> None:
    """Wait until nothing is wrong with it; the clock is only there to end what hangs."""
    deadline = bench.clock.now() + 60.0
    while {one.name: one.fault for one in bench.state().instruments}[name]:
        assert bench.clock.now() < deadline
        bench.stream_until(bench.clock.now() + 0.1)


class Lost:
    """A sensor whose line is lost for good; what `reopen` does is given."""

    name = "sensor"

    def __init__(self, *faults: str) -> None:
        self.faults, self.opened = list(faults), 0

    def read_until(self, t_s: float) -> list[Block]:
        raise InstrumentError("out", fault="link lost")

    def start(self) -> None:
        pass

    def events(self) -> list[Any]:
        return []

    def reopen(self) -> None:
        self.opened += 1
        raise InstrumentError("no", fault=self.faults.pop(0) if len(self.faults) > 1 else self.faults[0])


def test_a_sensor_that_does_not_come_back_is_a_lost_link() -> None:
    lost = Lost("link lost", "silent", "in use")
    stream = Reconnecting(lost, lost.reopen, 5.0)
    for t in (0.0, 0.2, 1.0, 2.0, 4.9):
        assert stream.read_until(t) == []
    with pytest.raises(InstrumentError, match="out") as caught:
        stream.read_until(5.1)
    assert caught.value.fault == "link lost"
    assert lost.opened == 3


def test_what_keeps_a_sensor_from_sending_is_known_until_it_can_send_again() -> None:
    lost = Lost("link lost")
    stream = Reconnecting(lost, lambda: None, 5.0)
    stream.read_until(1.0)
    assert (stream.wrong, [event.text for event in stream.news()]) == ("link lost", ["sensor: out"])
    stream.read_until(3.0)
    (back,) = stream.news()
    assert (stream.wrong, back.t_s, back.text) == (
        "",
        3.0,
        "sensor: it answers again, 2.0 s after its loss was noticed",
    )


def test_another_instrument_ends_the_waiting_at_once() -> None:
    lost, clock = Lost("link lost", "another instrument"), VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
    with pytest.raises(InstrumentError) as caught:
        bring_back(lost.reopen, clock, InstrumentError("out", fault="link lost"))
    assert caught.value.fault == "another instrument"
    assert clock.now() < BACK_S


def test_who_wants_the_end_does_not_wait_for_a_stage_that_is_out() -> None:
    lost, clock = Lost("link lost"), VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
    wanted_s = clock.now() + 0.7

    def look() -> None:
        if clock.now() >= wanted_s:
            raise Stopped("stopped by the operator")

    with pytest.raises(Stopped):
        bring_back(lost.reopen, clock, InstrumentError("out", fault="link lost"), look)
    assert clock.now() < wanted_s + 0.1
