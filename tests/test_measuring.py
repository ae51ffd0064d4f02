"""The loop closes on the instruments: the plan first, one question, three rounds at most."""

from __future__ import annotations

import json
from datetime import datetime
from pathlib import Path

import pytest

from labcal import cli, session
from labcal.demo import simulated_bench
from labcal.errors import InputError
from labcal.runner import find
from labcal.runner.rehearsal import Rehearsal, rehearsed
from labcal.session import measuring
from labcal.session.measuring import Talk, close_by_measuring

SEED = 3


@pytest.fixture
def one_axis() -> str:
    """A run that turns about one axis in one field alone: it does not determine the map."""
    outcome = session.run("reverse", simulated_bench(), seed=SEED)
    assert outcome.fault is None
    return outcome.run_id


def test_a_rehearsal_says_what_a_procedure_will_do() -> None:
    plan = rehearsed(simulated_bench(), find("reverse"), {"magnitude_nT": "30000", "rate_deg_per_s": "12"}, SEED)
    assert plan.field_nT == pytest.approx(30000, abs=1)
    assert plan.rate_deg_per_s == 12  # as it was asked to turn: angles are read with some noise
    assert plan.limit == (20, "DUT's limit in bench.toml")
    assert plan.angles_deg == pytest.approx((0, 360), abs=1)
    assert (plan.segments, plan.simulated) == (2, True)
    assert any("Mount the DUT" in text for text in plan.person)
    said = "\n".join(plan.lines())
    assert all(word in said for word in ("30.0 µT", "360°", "−20 to 60 °C", "min"))


def test_a_rehearsal_beyond_a_limit_fails_before_anything_moves() -> None:
    with pytest.raises(InputError, match="limit"):
        rehearsed(simulated_bench(), find("reverse"), {"rate_deg_per_s": "25"}, SEED)


def test_without_consent_nothing_is_measured(one_axis: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        measuring,
        "proposed_procedures",
        lambda closed: [
            ("platform-signature", {}),
            ("linearity", {"magnitude_nT": "1e9"}),
            ("reverse", {"magnitude_nT": "30000"}),
            ("repeat", {}),
        ],
    )
    plans: list[Rehearsal] = []
    before = len(session.runs())

    def refuse(plan: Rehearsal) -> bool:
        plans.append(plan)
        return False

    closed = close_by_measuring(one_axis, simulated_bench(), Talk(refuse), seed=SEED)
    assert [plan.procedure for plan in plans] == ["reverse"]  # the first records no segment, the second is refused
    assert plans[0].field_nT == pytest.approx(30000, abs=1)
    assert (closed.rounds, len(session.runs())) == ((), before)


def test_a_bench_that_holds_another_dut_is_refused(one_axis: str, tmp_path: Path) -> None:
    other = tmp_path / "other.toml"
    other.write_text(simulated_bench().read_text().replace("SIM-0001", "SIM-0002"))
    with pytest.raises(InputError, match="SIM-0002"):
        close_by_measuring(one_axis, other, Talk(lambda plan: True), seed=SEED)


def test_what_is_measured_is_added_and_kept_three_rounds_at_most(
    one_axis: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(measuring, "proposed_procedures", lambda closed: [("reverse", {})])
    closed = close_by_measuring(one_axis, simulated_bench(), Talk(lambda plan: True), seed=SEED)
    assert [(r.procedure, r.verdict) for r in closed.rounds] == [("reverse", closed.verdict)]
    both = session.load_run(closed.run_id)
    assert closed.run_id == f"{one_axis}+{closed.rounds[0].run_id}"
    assert len(both) == sum(len(session.load_run(run)) for run in (one_axis, closed.rounds[0].run_id))
    assert [s.id[-2:] == "#2" for s in both.segments] == [False, False, True, True]


def test_after_a_run_that_recorded_nothing_time_goes_on_from_its_start() -> None:
    outcome = session.run("degauss", simulated_bench(), seed=SEED)
    empty = session.load_run(outcome.run_id)
    assert (len(empty), outcome.fault) == (0, None)
    start, now_s = measuring.goes_on(outcome.run_id)
    assert (start, now_s) == (datetime.fromisoformat(empty.started_utc), measuring.GAP_S)
    with pytest.raises(InputError, match="recorded no samples"):
        session.close_loop(outcome.run_id)


def test_measure_without_a_bench_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.execute(["close-loop", "nothing", "--measure"]) == 2
    assert "--bench" in capsys.readouterr().err


@pytest.mark.slow
def test_an_open_run_is_closed_by_what_the_bench_measures(
    one_axis: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "cal.json"
    given = ["close-loop", one_axis, "--measure", "--bench", str(simulated_bench()), "--seed", str(SEED), "--yes"]
    assert cli.execute([*given, "--out", str(out)]) == 0
    said = capsys.readouterr()
    assert said.err.count("The plan:") == said.out.count("Measured: ") >= 1
    calibration = session.load_calibration(out)
    assert one_axis in calibration.run_id
    assert calibration.run_sha256 == session.run_bundle(calibration.run_id).sha256


@pytest.mark.slow
def test_an_ambiguous_run_ends_explained_by_what_really_is_at_work(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Turned in one field, a field of the cage is a tilt, a gradient or a dipole as well; field steps at rest tell."""
    bench = tmp_path / "bench.toml"
    bench.write_text(simulated_bench().read_text().replace("surprise = true", "[twin.effects.cage-field]"))
    given = {"magnitudes_nT": "50000", "reverse": "false", "modes": "nominal"}
    outcome = session.run("preflight", bench, given, seed=SEED)
    assert outcome.fault is None
    open_yet = session.close_loop(outcome.run_id)
    assert open_yet.verdict == "ambiguous"
    (first,) = open_yet.accepted
    assert first.provisional
    assert "cage-field" in {first.effect, *(rival.effect for rival in first.rivals)}
    assert open_yet.next_experiment is not None
    asked = ["close-loop", outcome.run_id, "--measure", "--bench", str(bench), "--seed", str(SEED), "--yes"]
    assert cli.execute([*asked, "--json", str(tmp_path / "result.json")]) == 0
    capsys.readouterr()
    result = json.loads((tmp_path / "result.json").read_text())
    named = [open_yet.next_experiment.procedure, *(r.procedure for r in open_yet.next_experiment.ranking)]
    recording = (name for name in named if name not in (None, "platform-signature"))  # no readings
    assert [r["procedure"] for r in result["rounds"]] == [next(recording)]
    (found,) = result["accepted"]
    assert (result["verdict"], found["effect"], found["rivals"]) == ("explained", "cage-field", [])
    truth = (250.0, -180.0, 120.0)  # nT, of the twin's cage
    assert all(abs(p["value"] - true) < 3.0 for p, true in zip(found["parameters"], truth, strict=True))
