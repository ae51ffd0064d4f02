"""While the coils are on their way what the reference sees is no settled value: it is grey, and says so."""

import time
from contextlib import closing
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest
from test_hands_in_the_cage import lab
from test_hands_in_the_cage import running as running

from labcal.bench import open_bench
from labcal.bench.clock import VirtualClock
from labcal.bench.coils.state import FieldReading

EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"


@pytest.mark.parametrize("changing", [True, False])
def test_it_is_grey_in_the_panel_and_on_the_bench_page(running, changing):
    seen = FieldReading(None, (20_400.0, 1_150.0, -43_700.0), time.monotonic(), changing)
    running.app_state.bench_worker.states.emit(replace(lab((0.0, 0.0, 0.4)), field=seen))
    side, bench = running.side, running.page("Bench")
    bench.show_readings()
    assert side.field_age.text() == ("changing" if changing else "")
    assert side.field_age.isVisible()
    assert {cell.property("state") for cell in side.field.values[1:]} == {"old" if changing else ""}
    row = next(r for r in range(bench.table.rowCount()) if bench.table.text(r, 0) == "reference")
    assert bench.table.text(row, 4).endswith("changing") is changing
    assert (bench.cage.dashed is None) is changing


def test_a_ramp_up_and_down_is_known_to_be_one():
    clock = VirtualClock(datetime(2026, 11, 21, tzinfo=UTC))
    with closing(open_bench(EXAMPLE, clock=clock, seed=2)) as bench:
        bench.start()
        bench.stream_until(clock.now() + 1.0)
        told = list[bool]()
        bench.look = lambda: told.append(bench.state().field.changing)
        bench.cage.set_currents(np.array([0.3, 0.0, 0.0]))
        assert told
        assert all(told)
        told.clear()
        bench.stream_until(clock.now() + 1.0)
        assert told
        assert not any(told)
        told.clear()
        bench.cage.zero()
        assert any(told)
        assert not bench.state().field.changing
        bench.stop()
