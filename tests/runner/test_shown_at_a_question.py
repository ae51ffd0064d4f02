"""While a person thinks on a bench whose time is simulated, it is read on; nothing is shown as of now that is not."""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import closing
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest

from labcal.bench import open_bench
from labcal.bench.clock import VirtualClock
from labcal.bench.coils.state import LabState, Witness
from labcal.record.stream import Item, Prompt
from labcal.runner import awaited, drive, find, run_procedure
from labcal.runner.control import Control
from labcal.runner.prompts import first_choice
from labcal.store import Store

TURN = {"zero_s": "8", "rate_deg_per_s": "20"}
THINKS_S, AGAIN_S = 1.6, 0.2


def test_whoever_thinks_for_long_sees_the_lab_as_it_is_read_meanwhile(
    bench_file: Callable[..., Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Reference and DUT grew old at each question, and what lets hands in went from green to amber with them."""
    monkeypatch.setattr(awaited, "AGAIN_S", AGAIN_S)
    monkeypatch.setattr(drive, "LISTEN_S", 0.05)
    asked, old_s, coil_A = list[Prompt](), list[tuple[float, ...]](), set[float | None]()
    clock = VirtualClock(datetime(2026, 11, 21, tzinfo=UTC))
    with closing(open_bench(bench_file(), clock=clock, seed=2)) as lab, Store.open() as store:

        def answer(prompt: Prompt) -> str:
            asked.append(prompt)
            if len(asked) == 2:
                monkeypatch.setattr(lab.cage.supplies["x"], "measure_current", lambda: 0.00042)
                time.sleep(THINKS_S)
                monkeypatch.undo()
            return first_choice(prompt)

        def shown(state: LabState) -> None:
            if len(asked) == 2:
                heard_s = {one.name: one.heard_s for one in state.instruments}
                read_s = (state.field.read_s, heard_s["reference"], heard_s["dut"])
                old_s.append(tuple(time.monotonic() - at_s for at_s in read_s if at_s is not None))
            coil_A.add(state.coils[0].current_A)

        run_procedure(lab, find("rotate-axis"), TURN, store=store, answer=answer, show=shown)
    assert 0.00042 in coil_A
    assert len(old_s[-1]) == 3, old_s[-1]
    for what in zip(*[one for one in old_s if len(one) == 3], strict=True):
        assert max(what) > AGAIN_S / 2, "between two looks it grows old"
        assert sorted(what)[len(what) // 2] < THINKS_S / 2, "it is looked at again"
        assert what[-1] < THINKS_S / 2


def test_a_field_of_the_ramp_is_not_shown_beside_coils_at_zero(
    bench_file: Callable[..., Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Paused just after the turn: what the reference sees then is the ambient field, or is not shown."""
    monkeypatch.setattr(awaited, "AGAIN_S", 0.1)
    monkeypatch.setattr(drive, "LISTEN_S", 0.05)
    control, paused = Control(), list[LabState]()
    clock = VirtualClock(datetime(2026, 11, 21, tzinfo=UTC))

    def shown(state: LabState) -> None:
        if control.paused() and all(coil.zero for coil in state.coils):
            paused.append(state)
            if len(paused) > 20:
                control.resume()

    def pause(item: Item) -> None:
        if type(item).__name__ == "SegmentClosed":
            control.pause()

    with closing(open_bench(bench_file(), clock=clock, seed=2)) as lab, Store.open() as store:
        run_procedure(
            lab, find("preflight"), {"axes": "x,y", "magnitudes_nT": "20000"}, store=store, answer=first_choice,
            control=control, on_item=pause, show=shown,
        )  # fmt: skip
        ambient = float(np.linalg.norm(lab.cage.ambient_nT))
    seen = [float(np.linalg.norm(one.field.seen_nT)) for one in paused if one.field.seen_nT is not None]
    assert paused
    assert seen, "a little of the bench's time passes for it"
    assert max(abs(one - ambient) for one in seen) < 40.0


def test_a_zero_that_the_reference_saw_before_the_question_grows_old_as_its_field_does(
    bench_file: Callable[..., Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Else it is green for as long as a person thinks, beside a field that is grey."""
    with closing(open_bench(bench_file(), clock=VirtualClock(datetime(2026, 11, 21, tzinfo=UTC)), seed=2)) as lab:
        lab.cage.check.witness = Witness("agrees", "", read_s=lab.clock.now())
        waits = awaited.Awaited(lab)
        now = time.monotonic()
        monkeypatch.setattr(awaited.time, "monotonic", lambda: now + 60.0)
        seen = waits.state()
    assert seen.reference.read_s is not None
    assert 59.0 < now + 60.0 - seen.reference.read_s < 61.0
    assert "the reference agreed when it was last looked at" in seen.sentence(now + 60.0)
