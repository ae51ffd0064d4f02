"""The platform turned by hand: a move is a question, and only an answer ends it."""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest

from drivers.manual import ManualPlatform
from labcal.bench import Bench, open_bench
from labcal.bench.clock import VirtualClock
from labcal.bench.coverage import missing_sectors
from labcal.bench.driver_kit.testing import scripted
from labcal.bench.links import open_link
from labcal.bench.rotation import Rotation, rotate_once
from labcal.bench.steps import record, to_angle
from labcal.errors import InstrumentError, LimitError
from labcal.record.stream import Block, Prompt, SegmentOpened

EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"


def test_a_move_asks_and_is_not_over_before_the_answer() -> None:
    with scripted(ManualPlatform, []) as platform:
        platform.move_to(-30.0, 5.0)
        assert "330.0° on its dial" in platform.question()
        assert platform.moving()
        platform.confirm("330.2")
        assert not platform.moving()
        assert platform.angle_deg() == pytest.approx(-29.8)


@pytest.mark.parametrize(("answer", "angle"), [("", 365.0), ("done", 365.0), ("4.9°", 364.9), ("5,1", 365.1)])
def test_a_reading_lies_on_the_turn_that_was_asked_for(answer: str, angle: float) -> None:
    with scripted(ManualPlatform, []) as platform:
        platform.move_to(365.0, 5.0)
        platform.confirm(answer)
        assert platform.angle_deg() == pytest.approx(angle)


@pytest.mark.parametrize(
    ("answer", "fault"),
    [("abort", "aborted"), ("Stop", "aborted"), ("33", "not arrived"), ("nan", "wrong reply"),
     ("30 or so", "wrong reply"), ("1e3", "wrong reply"), ("\x00\xff", "wrong reply")],
)  # fmt: skip
def test_an_abort_another_angle_and_nonsense_leave_the_angle_unknown(answer: str, fault: str) -> None:
    with scripted(ManualPlatform, []) as platform:
        platform.move_to(30.0, 5.0)
        with pytest.raises(InstrumentError) as caught:
            platform.confirm(answer)
        assert caught.value.fault == fault
        assert platform.moving()


def test_the_link_to_a_person_carries_nothing() -> None:
    clock = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
    link = open_link("manual://", clock)
    link.never.add(ManualPlatform.never)
    assert link.receive(1.0) == []
    with pytest.raises(InstrumentError, match="never sent"):
        link.send(b"turn")


def test_before_the_first_reading_its_angle_is_not_known() -> None:
    with scripted(ManualPlatform, []) as platform:
        platform.home()
        assert platform.moving()
        platform.confirm("0.1")
        platform.home()
        assert platform.state() == (pytest.approx(0.1), False)


def test_the_dials_uncertainty_is_that_of_a_rectangle() -> None:
    with scripted(ManualPlatform, [], dial_deg=0.3) as platform:
        drawn = np.random.default_rng(5).uniform(-0.3, 0.3, 20_000)
        assert platform.u_reading_deg == pytest.approx(drawn.std(), rel=0.02)


@pytest.fixture
def bench(tmp_path: Path) -> Bench:
    text = EXAMPLE.read_text().replace('driver = "zaber"', 'driver = "manual"')
    path = tmp_path / "bench.toml"
    path.write_text(text + "\n[twin.platform]\nmisreading_deg = 0.1\n")
    return open_bench(path, clock=VirtualClock(datetime(2026, 1, 1, tzinfo=UTC)), seed=3)


def answered(bench: Bench, work, answers=lambda prompt: "") -> list:
    """Run `work` as a person at the simulated bench would; what it yielded."""
    seen, answer = [], None
    while True:
        try:
            item = work.send(answer)
        except StopIteration:
            return seen
        seen.append(item)
        answer = None
        if isinstance(item, Prompt):
            answer = answers(item)
            bench.simulated_operator.do(item)


def test_hands_turn_it_once_around_with_misreadings_within_the_dial(bench: Bench) -> None:
    with bench:
        bench.start()
        answered(bench, to_angle(bench, 0.0))
        seen = answered(bench, rotate_once(bench, Rotation("turn", (0, 0, 1), "nominal", 5.0)))
        blocks = [item for item in seen if isinstance(item, Block)]
        (opened,) = (item.segment for item in seen if isinstance(item, SegmentOpened))
        asked = [item.drawing["angle_deg"] for item in seen if isinstance(item, Prompt)]
        assert asked == pytest.approx(np.arange(7.5, 360.0, 15.0))
        assert missing_sectors(blocks) == []
        assert opened.angle_noise_deg == pytest.approx(0.1 / np.sqrt(3))
        placed = np.array([piece[1] for piece in bench.simulated_operator._lab.platform.pieces])
        off = placed[-len(asked) :] - asked
        assert 0.0 < np.abs(off).max() <= 0.1
        assert all(item.acts for item in seen if isinstance(item, Prompt))


def test_while_hands_are_on_it_no_angle_is_recorded_and_no_motor_runs(bench: Bench) -> None:
    with bench:
        bench.start()
        answered(bench, to_angle(bench, 0.0))
        answered(bench, record(bench, 1.0))
        bench.platform.move_to(90.0, 5.0)
        blocks = bench.stream_until(bench.clock.now() + 3.0)
        assert not [b for b in blocks if b.stream == "angle" and b.t_s[-1] > bench.clock.now() - 2.5]
        motor = [b for b in blocks if b.columns == ("motor_on",)]
        assert motor
        assert not np.concatenate([b.values for b in motor]).any()


def test_an_abort_ends_the_turn_as_a_named_fault(bench: Bench) -> None:
    with bench:
        bench.start()
        answered(bench, to_angle(bench, 0.0))
        turn = rotate_once(bench, Rotation("turn", (0, 0, 1), "nominal", 5.0))
        with pytest.raises(InstrumentError) as caught:
            answered(bench, turn, lambda prompt: "abort" if prompt.key == "turn-52.5" else "")
        assert caught.value.fault == "aborted"


def test_it_is_not_asked_beyond_the_cables(bench: Bench) -> None:
    with bench, pytest.raises(LimitError, match="cables"):
        answered(bench, to_angle(bench, 405.0))
