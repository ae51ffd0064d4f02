"""An analogue reference whose box is pulled while a field is held: noticed, named, the coils at zero 2 s later."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from labcal.bench import open_bench
from labcal.bench.clock import VirtualClock
from labcal.bench.streams.watch import NOTICED_S
from labcal.errors import InstrumentError
from labcal.record.stream import Item, Step
from labcal.runner import find, run_procedure, yes_to_all
from labcal.store import Store

HMR2300 = 'driver = "hmr2300"\nlink = "emulated://"\nrole = "reference"\nsettings = { rate = 20 }'
LABJACK = (
    'driver = "labjack-t7"\nlink = "emulated://"\nrole = "reference"\nsettings = { uT_per_V = [10.0, 10.0, 10.0] }'
)
ZERO_A, ZERO_S = 0.005, 2.0


def test_a_labjack_that_is_pulled_ends_with_the_coils_at_zero(
    bench_file: Callable[..., Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    clock, pulled_s = VirtualClock(datetime(2026, 11, 21, tzinfo=UTC)), list[float]()
    with (
        closing(open_bench(bench_file("", (HMR2300, LABJACK)), clock=clock, seed=2)) as bench,
        Store.open() as store,
    ):
        lab: Any = bench.simulated_operator._lab

        def lost(*_: object) -> None:
            raise InstrumentError("reference: the link is lost.", fault="link lost", remedy="Plug it in.")

        def tell(item: Item) -> None:
            if isinstance(item, Step) and item.name == "held" and not pulled_s:
                pulled_s.append(clock.now())
                for call in ("send", "receive", "reopen"):
                    if hasattr(bench._links["reference"], call):
                        monkeypatch.setattr(bench._links["reference"], call, lost)

        outcome = run_procedure(
            bench, find("field-hold"), {"duration_s": "60"}, store=store, answer=yes_to_all(True), tell=tell, run_id="R"
        )
        assert isinstance(outcome.fault, InstrumentError), outcome.status
        assert outcome.fault.fault in ("link lost", "silent")
        assert outcome.fault.remedy
        ended_s = clock.now()
        assert max(abs(coil.at(np.array(pulled_s))[0]) for coil in lab.coils.values()) > 0.1
        for coil in lab.coils.values():
            times = np.arange(pulled_s[0], ended_s, 0.05)
            flows = times[np.abs(coil.at(times)) > ZERO_A]
            assert flows.max(initial=pulled_s[0]) < pulled_s[0] + NOTICED_S + ZERO_S
            assert abs(coil.at(np.array([ended_s]))[0]) < ZERO_A
