"""The coils: refusals, ramps, reversals, and a way to zero that no single fault can stop."""

from __future__ import annotations

from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from labcal.bench import Bench, open_bench
from labcal.bench.clock import VirtualClock
from labcal.bench.coils.polarity import ReversedSupply
from labcal.bench.coils.zero import wait_for_zero
from labcal.errors import InputError, InstrumentError, LimitError

EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"


def opened(path: Path = EXAMPLE) -> Bench:
    return open_bench(path, clock=VirtualClock(datetime(2026, 1, 1, tzinfo=UTC)), seed=1)


@pytest.fixture
def bench() -> Iterator[Bench]:
    with opened() as bench:
        yield bench


def lab_of(bench: Bench) -> Any:
    assert bench.simulated_operator is not None
    return bench.simulated_operator._lab


def changed(tmp_path: Path, old: str, new: str) -> Path:
    path, text = tmp_path / "bench.toml", EXAMPLE.read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1))
    return path


def test_a_current_beyond_its_limit_is_refused_with_both_numbers(bench: Bench) -> None:
    with pytest.raises(LimitError, match=r"coil y: -2\.6 A.*2\.5 A"):
        bench.cage.set_currents([0.0, -2.6, 0.0])
    assert all(coil.current.target == 0 for coil in lab_of(bench).coils.values())


@pytest.mark.parametrize("bad", [[np.nan, 0, 0], [np.inf, 0, 0]])
def test_what_is_no_number_is_refused(bench: Bench, bad: list[float]) -> None:
    with pytest.raises(LimitError):
        bench.cage.set_currents(bad)


def test_a_bench_that_cannot_ramp_down_in_time_is_refused_when_it_is_loaded(tmp_path: Path) -> None:
    path = changed(tmp_path, "ramp_A_per_s = 2.0", "ramp_A_per_s = 1.0")
    with pytest.raises(InputError, match=r"2\.50 s to ramp down") as caught:
        opened(path)
    assert caught.value.line is not None


def test_the_current_ramps_and_never_jumps(bench: Bench) -> None:
    lab = lab_of(bench)
    bench.cage.set_currents([1.8, -0.5, 0.0])
    before = bench.clock.now()
    bench.cage.set_currents([-1.8, 0.5, 0.2])
    t = np.arange(before, bench.clock.now(), 0.001)
    current = lab.coils["x"].at(t)
    change = np.abs(current[600:] - current[:-600]).max()  # in 0.6 s, in steps of 0.2 A
    assert change <= 2.0 * 0.6 + 0.2 + 0.01
    assert current[0] == pytest.approx(1.8, abs=0.01)
    assert current[-1] == pytest.approx(-1.8, abs=0.01)


def test_contacts_never_move_under_current(bench: Bench) -> None:
    rng = np.random.default_rng(0)
    for _ in range(20):
        bench.cage.set_currents(rng.uniform(-1.1, 1.1, 3))
    lab = lab_of(bench)
    assert sum(len(coil.sign.values) - 1 for coil in lab.coils.values()) > 10
    assert all(coil.hot_switches == [] for coil in lab.coils.values())


def test_no_output_opens_under_current(bench: Bench, monkeypatch: pytest.MonkeyPatch) -> None:
    opened_at: list[float] = []
    for coil in lab_of(bench).coils.values():
        drive = coil.drive

        def watched(
            t_s: float, current_A: float, voltage_V: float, on: bool, coil: Any = coil, drive: Any = drive
        ) -> bool:
            if not on:
                opened_at.append(abs(coil.current.now(t_s)))
            return bool(drive(t_s, current_A, voltage_V, on))

        monkeypatch.setattr(coil, "drive", watched)
    rng = np.random.default_rng(3)
    for turn in range(12):
        bench.cage.set_currents(rng.uniform(-1.1, 1.1, 3))
        if turn % 4 == 3:
            bench.cage.zero()
    assert len(opened_at) > 20
    assert max(opened_at) < 0.005


def test_contacts_that_stay_where_they_are_end_with_an_open_output(
    bench: Bench, monkeypatch: pytest.MonkeyPatch
) -> None:
    supply = bench.cage.supplies["x"]
    assert isinstance(supply, ReversedSupply)
    bench.cage.set_currents([0.5, 0.0, 0.0])
    monkeypatch.setattr(supply._relay, "set_polarity", lambda axis, sign: None)
    with pytest.raises(InstrumentError, match="did not switch") as caught:
        bench.cage.set_currents([-0.5, 0.0, 0.0])
    assert caught.value.fault == "polarity not confirmed"
    assert abs(supply.measure_current()) == 0.0
    assert lab_of(bench).coils["x"].current.target == 0.0


def test_a_supply_that_cannot_drive_the_current_is_noticed(tmp_path: Path) -> None:
    path = changed(tmp_path, 'role = "coil-x"', 'role = "coil-x"\nsettings = { compliance_V = 3.0 }')
    with opened(path) as bench, pytest.raises(InstrumentError, match=r"1 A was set and 0\.5 A flows") as caught:
        bench.cage.set_currents([1.0, 0.0, 0.0])
    assert caught.value.fault == "wrong mode"


def test_a_dead_supply_does_not_keep_the_others_from_zero(monkeypatch: pytest.MonkeyPatch) -> None:
    bench = opened()
    bench.cage.set_currents([1.0, 1.0, 1.0])
    lab = lab_of(bench)

    def dead(*_: object, **__: object) -> bytes:
        raise InstrumentError("supply_y: no reply", fault="silent")

    link = bench._links["supply_y"]
    monkeypatch.setattr(link, "ask", dead)
    with pytest.raises(InstrumentError, match="supply_y"):
        bench.cage.zero()
    bench.clock.wait_until(bench.clock.now() + 0.5)
    t = np.array([bench.clock.now()])
    assert abs(lab.coils["x"].at(t)[0]) < 1e-6
    assert abs(lab.coils["z"].at(t)[0]) < 1e-6


def test_full_current_is_at_zero_within_two_seconds(bench: Bench) -> None:
    bench.cage.set_currents([1.9, -0.3, 0.3])
    begun = bench.clock.now()
    bench.cage.zero()
    assert bench.clock.now() - begun < 2.0


def test_another_instrument_after_a_replug_is_refused(bench: Bench, monkeypatch: pytest.MonkeyPatch) -> None:
    assert bench.reconnect("supply_x").serial == "512340"
    other = bench.instruments()["supply_y"]
    monkeypatch.setattr(bench.instruments()["supply_x"], "identify", other.identify)
    with pytest.raises(InstrumentError, match=r"512341 answers, before it was .*512340"):
        bench.reconnect("supply_x")


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ('driver = "zaber"', 'driver = "zabre"', "there is no driver 'zabre'"),
        ("settings = { rate = 20 }", "settings = { rate = 21 }", "rate 21"),
        ("settings = { rate = 20 }", "settings = { rat = 20 }", "rat is no setting"),
        ('driver = "zaber"', 'driver = "hmr2300"', "cannot be the platform"),
        ("surprise = true", "effects = { gremlins = {} }", "no such effect"),
        ("surprise = true", "surprize = true", "twin.surprize"),
    ],
)
def test_a_fault_in_the_file_is_one_sentence_with_its_line(tmp_path: Path, old: str, new: str, says: str) -> None:
    with pytest.raises(InputError) as caught:
        opened(changed(tmp_path, old, new))
    assert says in str(caught.value)
    assert caught.value.line is not None


def welded(monkeypatch: pytest.MonkeyPatch, bench: Bench, axis: str) -> None:
    """The relay of this axis reads back as set, and its contacts stay where they are."""
    monkeypatch.setattr(lab_of(bench).coils[axis], "reverse", lambda t_s, sign: None)


def test_a_welded_contact_is_seen_by_the_reference_at_small_current(
    bench: Bench, monkeypatch: pytest.MonkeyPatch
) -> None:
    bench.start()
    welded(monkeypatch, bench, "y")
    bench.cage.set_currents([0.5, 0.5, -0.5])
    with pytest.raises(InstrumentError, match=r"coil y.*step of -0\.04 A was seen") as caught:
        bench.cage.set_currents([-0.5, -0.5, 0.5])
    assert caught.value.fault == "polarity not confirmed"
    assert "welded" in caught.value.remedy
    assert abs(bench.cage.currents_A()).max() < 0.001
    reached = lab_of(bench).coils["y"].current.at(np.arange(0.0, bench.clock.now(), 0.01))
    assert reached.max() < 0.51  # never more than the set-point before


def test_every_reversal_is_looked_at_and_nothing_else(bench: Bench, monkeypatch: pytest.MonkeyPatch) -> None:
    bench.start()
    judged: list[tuple[int, ...]] = []
    judge = bench.cage._signs.judge
    monkeypatch.setattr(
        bench.cage._signs, "judge", lambda probe, *seen: (judged.append(probe.axes), judge(probe, *seen))
    )
    for currents in ([0.5, 0.5, 0.0], [1.0, 0.2, 0.01], [1.0, -0.2, 0.3], [-0.3, -0.4, 0.3], [0.3, 0.4, -0.01]):
        bench.cage.set_currents(currents)
    assert judged == [(0, 1), (2,), (1,), (0,), (0, 1)]
    bench.cage.zero()
    bench.cage.set_currents([0.3, 0.0, 0.0])
    assert judged[5:] == [(0,)]


def test_the_way_of_a_probe_never_leaves_the_straight_line(bench: Bench) -> None:
    rng = np.random.default_rng(1)
    for _ in range(500):
        start, target = rng.uniform(-1, 1, (2, 3))
        bench.cage._signs.forget()
        for probe in bench.cage._signs.probes(start, target):
            for point in (probe.before, probe.after):
                parts = (point - start) / (target - start)
                assert np.ptp(parts) < 1e-9
                assert -1e-9 < parts[0] < 1 + 1e-9


def test_without_a_reference_that_sees_the_coils_the_read_back_is_all_there_is(tmp_path: Path) -> None:
    with opened(changed(tmp_path, 'place = "dut"', 'place = "remote"')) as bench:
        bench.start()
        bench.cage.set_currents([0.5, -0.5, 0.0])
        assert bench.cage.currents_A() == pytest.approx([0.5, -0.5, 0.0], abs=0.01)


class SlowSupply:
    """A supply that takes longer to ask than zero may take."""

    zero_current_A, can_open, ramp_A_per_s, name = 0.01, True, 2.0, "slow"

    def __init__(self, clock: VirtualClock, currents_A: list[float]) -> None:
        self._clock, self._currents_A, self.said = clock, currents_A, list[str]()

    def measure_current(self) -> float:
        self._clock.wait_until(self._clock.now() + 0.8)
        return self._currents_A.pop(0) if len(self._currents_A) > 1 else self._currents_A[0]

    def set_current(self, current_A: float) -> None:
        self.said.append(f"{current_A:g} A")

    def output(self, on: bool) -> None:
        self.said.append(f"output {on}")


class Contacts:
    """Contacts that switch as told."""

    sign = 1

    def polarity(self, axis: str) -> int:
        return self.sign

    def set_polarity(self, axis: str, sign: int) -> None:
        self.sign = sign


def test_a_slow_line_is_no_current() -> None:
    clock = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
    assert wait_for_zero("x", SlowSupply(clock, [0.4, 0.4, 0.0]), clock) == 0.0
    supply, contacts = SlowSupply(clock, [0.0]), Contacts()
    ReversedSupply("x", supply, contacts, clock).set_current(-0.5)
    assert (contacts.sign, supply.said) == (-1, ["0 A", "output False", "output False", "0.5 A"])


def test_zero_is_read_back_where_the_contacts_do_not_answer_and_no_other_current() -> None:
    class Gone(Contacts):
        """Their link is lost."""

        def polarity(self, axis: str) -> int:
            raise InstrumentError("reversers: the link was lost.")

    clock = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
    assert ReversedSupply("x", SlowSupply(clock, [0.0]), Gone(), clock).measure_current() == 0.0
    with pytest.raises(InstrumentError, match="the link was lost"):
        ReversedSupply("x", SlowSupply(clock, [0.4]), Gone(), clock).measure_current()


def test_a_current_that_stays_is_told_on_a_slow_line_too() -> None:
    clock = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
    with pytest.raises(InstrumentError, match="still flows"):
        wait_for_zero("x", SlowSupply(clock, [0.4]), clock)
    contacts = Contacts()
    with pytest.raises(InstrumentError, match="the contacts were not moved"):
        ReversedSupply("x", SlowSupply(clock, [0.4]), contacts, clock).set_current(-0.5)
    assert contacts.sign == 1
