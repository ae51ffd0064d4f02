"""The example bench end to end: real drivers, real bytes, emulated instruments on the twin, virtual clock."""

from __future__ import annotations

from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest

from labcal.bench import Bench, open_bench
from labcal.bench.clock import VirtualClock
from labcal.errors import LimitError

EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"


def opened(seed: int = 3) -> Bench:
    return open_bench(EXAMPLE, clock=VirtualClock(datetime(2026, 1, 1, tzinfo=UTC)), seed=seed)


@pytest.fixture
def bench() -> Iterator[Bench]:
    with opened() as bench:
        bench.platform.home()
        yield bench


def reference_mean(bench: Bench, seconds: float) -> np.ndarray:
    blocks = bench.stream_until(bench.clock.now() + seconds)
    return np.vstack([b.values for b in blocks if b.stream == "reference"]).mean(axis=0)


def test_every_instrument_answers_with_its_name(bench: Bench) -> None:
    identities = bench.identities()
    assert list(identities) == list(bench.instruments())
    assert identities["stage"].manufacturer == "Zaber"
    assert len({i.serial for i in identities.values()}) == len(identities)


def test_supplies_and_contacts_of_different_makers_share_one_emulated_pair(tmp_path: Path) -> None:
    pair, text = 'link = "emulated://pair"', EXAMPLE.read_text(encoding="utf-8")
    for number, axis in enumerate("xy", 2):
        tti = f'driver = "tti-pl"\nlink = "emulated://"\nrole = "coil-{axis}"'
        assert tti in text
        text = text.replace(
            tti, f'driver = "riden-rd60xx"\n{pair}\nrole = "coil-{axis}"\nsettings = {{ address = {number} }}'
        )
    file = tmp_path / "bench.toml"
    file.write_text(
        text.replace('driver = "waveshare-relay"\nlink = "emulated://"', f'driver = "waveshare-relay"\n{pair}')
    )
    with open_bench(file, clock=VirtualClock(datetime(2026, 1, 1, tzinfo=UTC)), seed=3) as bench:
        assert {i.model for i in bench.identities().values()} >= {"RD6006", "Modbus RTU Relay"}
        bench.cage.set_currents([-0.2, 0.3, 0.1])
        np.testing.assert_allclose(bench.cage.currents_A(), [-0.2, 0.3, 0.1], atol=0.002)


def test_the_field_that_is_set_is_the_field_that_the_reference_sees(bench: Bench) -> None:
    bench.start()
    bench.cage.ambient_nT = reference_mean(bench, 5.0)
    bench.cage.set_field([20_000.0, -10_000.0, 5_000.0])
    reference_mean(bench, 0.5)
    error = reference_mean(bench, 5.0) - [20_000.0, -10_000.0, 5_000.0]
    assert np.abs(error).max() < 75.0  # the supplies set 1 mA, which is 50 nT


def test_a_field_beyond_the_limit_is_refused_with_both_numbers_and_nothing_changes(bench: Bench) -> None:
    with pytest.raises(LimitError, match=r"110000 nT.*100000 nT"):
        bench.cage.set_field([110_000.0, 0.0, 0.0])
    np.testing.assert_array_equal(bench.cage.set_points_A(), 0.0)


def test_a_run_of_ten_minutes_loses_and_repeats_no_sample(bench: Bench) -> None:
    bench.start()
    bench.platform.move_to(360.0, 6.0)
    begun, stamps = bench.clock.now(), []
    while bench.clock.now() < begun + 600:
        stamps += [b.t_s for b in bench.stream_until(bench.clock.now() + 7.3) if b.stream == "dut"]
    np.testing.assert_allclose(np.diff(np.concatenate(stamps)), 0.1, atol=1e-9)
    assert bench.platform.angle_deg() == pytest.approx(360.0, abs=0.001)


def test_the_same_seed_gives_the_same_bytes_however_the_stream_is_cut() -> None:
    raw = []
    for step in (0.7, 5.0):
        with opened(seed=11) as bench:
            bench.start()
            blocks = []
            while bench.clock.now() < 20.0:
                blocks += bench.stream_until(min(bench.clock.now() + step, 20.0))
            rows = [b.raw.rstrip(b"\n") for b in blocks if b.stream == "dut"]
            raw.append(b"\n".join(rows))
    assert raw[0] == raw[1]
    assert raw[0].count(b"\n") > 150


def test_after_the_bench_every_coil_is_at_zero_and_open() -> None:
    with opened() as bench:
        bench.cage.set_currents([1.0, -1.0, 0.5])
        assert np.abs(bench.cage.currents_A() - [1.0, -1.0, 0.5]).max() < 0.01
        bench.make_safe()
        np.testing.assert_array_equal(bench.cage.currents_A(), 0.0)


def test_a_reference_that_is_asked_is_asked_at_its_rate_however_long_the_bench_waits(tmp_path: Path) -> None:
    file = tmp_path / "bench.toml"
    file.write_text(EXAMPLE.read_text().replace("{ rate = 20 }", '{ rate = 20, mode = "polled" }'))
    with open_bench(file, clock=VirtualClock(datetime(2026, 1, 1, tzinfo=UTC)), seed=3) as bench:
        bench.start()
        blocks = [b for _ in range(2) for b in bench.stream_until(bench.clock.now() + 5.0) if b.stream == "reference"]
        bench.stop()
    stamps = np.concatenate([block.t_s for block in blocks])
    assert 180 < len(stamps) <= 200  # a beat that is missed, while a supply is asked, is left out
    assert np.diff(stamps).max() < 0.2
