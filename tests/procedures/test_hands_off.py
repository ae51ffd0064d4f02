"""Nothing is energised and nothing turns before somebody has said "hands off", after whatever was asked last."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import closing
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest

from labcal.bench.clock import VirtualClock
from labcal.bench.opening import open_bench
from labcal.bench.steps import mount
from labcal.demo import simulated_bench
from labcal.record.stream import ModeChanged, Prompt
from labcal.runner import find
from labcal.runner.prompts import first_choice
from labcal.testing.procedures import ProcedureTrial, check_normal_end

FIRST = ["ready", "mount-z", "mode-nominal", "ready"]
SHORT = {
    "axes": "x,z",
    "magnitudes_nT": "20000",
    "reverse": "no",
    "rate_deg_per_s": "20",
    "zero_s": "2",
    "dwell_s": "1",
}
AN_AXIS = ["mode-full", "ready", "mode-nominal", "ready"]


@pytest.mark.parametrize(
    ("name", "given", "asked"),
    [
        ("preflight", SHORT, [
            "ready", "mount-x", "mode-nominal", "ready", *AN_AXIS, "mount-z", "mode-nominal", "ready", *AN_AXIS,
            "mount-x-again", "ready",
        ]),
        ("rotate-axis", {"zero_s": "2", "rate_deg_per_s": "20"}, FIRST),
        ("rate-sweep", {"zero_s": "2"}, FIRST),
        ("repeat", {"times": "2", "pause_s": "0"}, FIRST),
        ("linearity", {}, FIRST),
        pytest.param(
            "temperature-drift", {}, ["ready", "mount-z", "mode-nominal", "warm", "ready"], marks=pytest.mark.slow
        ),
        ("axes-check", {}, ["ready", "mount-z", "ready"]),
        ("sync-check", {}, ["ready", "mount-z", "ready"]),
        ("degauss", {}, ["ready"]),
        ("field-hold", {}, ["ready"]),
        ("reference-check", {}, [*["turn-reference"] * 5, "ready"]),
        ("platform-signature", {}, ["ready", "reference-at-DUT", "ready", "motor-off", "motor-on"]),
        pytest.param(
            "cage-calibration", {}, ["reference-at-DUT", "ready", "reference-at-reference", "ready"],
            marks=pytest.mark.slow,
        ),
        pytest.param("cage-map", {}, ["probe", "ready"] * 7, marks=pytest.mark.slow),
        pytest.param("dut-moment", {}, [
            "reference", "dut-away", "ready", "mount-z", "mode-nominal", "ready", "mount-x", "mode-nominal", "ready",
        ] * 2, marks=pytest.mark.slow),
    ],
)  # fmt: skip
def test_each_procedure_hears_hands_off_last(name: str, given: Mapping[str, str], asked: list[str]) -> None:
    trial = ProcedureTrial(find(name), given, simulated_bench(), first_choice)
    assert [item.key for item in check_normal_end(trial) if isinstance(item, Prompt)] == asked


@pytest.mark.parametrize(("modes", "asked"), [('["nominal"]', []), ('["nominal", "full", "safe"]', ["mode-nominal"])])
def test_a_power_mode_is_asked_for_once_where_a_run_has_one_and_never_where_the_dut_has(
    bench_file: Callable[..., Path], modes: str, asked: list[str]
) -> None:
    bench = bench_file("", ('["nominal", "full", "safe"]', modes))
    trial = ProcedureTrial(find("preflight"), SHORT | {"modes": "nominal"}, bench, first_choice)
    items = check_normal_end(trial)
    assert [one.key for one in items if isinstance(one, Prompt) and one.key.startswith("mode")] == asked
    assert {one.mode for one in items if isinstance(one, ModeChanged)} == {"nominal"}


def test_who_is_asked_to_mount_is_told_where_the_platform_stands() -> None:
    clock = VirtualClock(datetime(2026, 1, 5, tzinfo=UTC))
    with closing(open_bench(simulated_bench(), clock=clock, seed=3)) as bench:
        assert bench.state().platform is None
        for item in mount(bench, "mount-x", np.eye(3), "Mount it."):
            if isinstance(item, Prompt) and item.key == "mount-x":
                state = bench.state()
                assert state.platform_sentence(clock.now()) == "platform stands at 0°"
                role = {one.role: name for name, one in bench.config.instruments.items()}
                assert next(one for one in state.instruments if one.name == role["platform"]).heard_s is not None
                return
    raise AssertionError("nobody was asked")
