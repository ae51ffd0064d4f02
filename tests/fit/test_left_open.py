"""A map that the run does not determine whole is said to be open, however little it leaves over."""

from datetime import UTC, datetime
from pathlib import Path

import pytest

from labcal import session
from labcal.bench.clock import VirtualClock
from labcal.fit import fit

BENCH = Path(__file__).parents[2] / "examples" / "simulated.toml"
QUICK = {"modes": "nominal", "zero_s": "3", "dwell_s": "1"}


def run_of(axes, rate, seed):
    given = QUICK | {"axes": axes, "rate_deg_per_s": rate}
    begun = VirtualClock(datetime(2026, 1, 5, tzinfo=UTC))
    return session.load_run(session.run("preflight", BENCH, given, dut="EM-1", clock=begun, seed=seed).run_id)


@pytest.mark.parametrize(
    ("axes", "rate", "seed", "says"),
    [
        pytest.param(
            "z",
            "2",
            1,
            "the run determines only 11 combinations of the 12 parameters; open are K_xy, K_yx: ",
            marks=pytest.mark.slow,
        ),  # the magnitudes alone determine a map, 15 nT are left
        (
            "x",
            "20",
            3,
            "the field would be uncertain by",
        ),  # all twelve, and by noise alone each by a tenth of the field
        ("x,z", "20", 1, ""),
        pytest.param("x,y,z", "20", 1, "", marks=pytest.mark.slow),
    ],
)
def test_one_axis_leaves_a_map_open_and_two_do_not(tmp_path, monkeypatch, axes, rate, seed, says):
    monkeypatch.setenv("LABCAL_HOME", str(tmp_path))
    run = run_of(axes, rate, seed)
    found = fit(run)
    assert found.ok
    said = session.left_open(run, found)
    assert said.startswith(says)
    assert bool(said) == bool(says)
