"""Nothing is energised and nothing turns before somebody has said "hands off", after whatever was asked last."""

from __future__ import annotations

from collections.abc import Mapping

import pytest

from labcal.demo import simulated_bench
from labcal.record.stream import Prompt
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
