"""The check standard of a bench: who may begin while it is out of control, and what is kept of that."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path

import numpy as np
import pytest

from labcal.bench.config import read_config
from labcal.certificate import sshsig
from labcal.cli import execute as labcal
from labcal.record import Dut, Reference, RunHeader
from labcal.record.stream import Event
from labcal.session import new_key, read_audit
from labcal.session.check_standard import NAMESPACE
from labcal.session.figures import SensorFigure, place_of
from labcal.store import Store

SIMULATED = Path(__file__).parents[2] / "examples" / "simulated.toml"
STATED = """
[check_standard]
serial = "CS-1"
quantities = ["offset x", "scale x"]
baseline = 10
"""
QUICK = '''
from labcal.record.stream import Measurement

def quick(bench):
    """Measure nothing."""
    yield Measurement(bench.clock.now(), "nothing", 0.0, 0.1, "nT")
'''


@pytest.fixture
def bench(tmp_path: Path) -> Path:
    path = tmp_path / "bench.toml"
    path.write_text(SIMULATED.read_text().replace("[dut]\n", STATED.strip() + "\n\n[dut]\n", 1))
    (tmp_path / "quick.py").write_text(QUICK)
    return path


def measured(bench: Path, offsets: list[float], *, of: str = "CS-1", first: int = 0) -> None:
    """Runs of the check standard whose figures are known already."""
    for i, offset in enumerate(offsets, first):
        header = RunHeader(
            f"{of}-{i}", f"2026-01-{i + 1:02}T08:00:00Z", True, "ada", Dut(of), Reference("none"),
            procedure="preflight", bench=bench.read_text(),
        )  # fmt: skip
        with Store.open() as store:
            store.begin(header).finish("finished")
        place = place_of(header.run_id)
        place.parent.mkdir(exist_ok=True)
        others = [SensorFigure(f"{kind} {axis}", i % 3, 1.0, "ppm") for kind in ("offset", "scale") for axis in "xyz"]
        figures = [*others[1:], SensorFigure("offset x", offset, 1.0, "nT")]
        place.write_text(json.dumps([asdict(one) for one in figures]))


def steady(n: int = 12) -> list[float]:
    return list(np.random.default_rng(2).normal(5, 2, n))


def start(bench: Path, *more: str) -> int:
    return labcal(
        ["run", str(bench.with_name("quick.py")), "--bench", str(bench), "--yes", "--progress", "none", *more]
    )


def test_a_bench_whose_standard_is_in_control_or_has_no_baseline_yet_begins(bench: Path) -> None:
    assert start(bench) == 0
    measured(bench, steady())
    assert start(bench) == 0
    assert labcal(["charts", "--bench", str(bench)]) == 0


def test_out_of_control_nothing_begins_but_the_standard_itself(bench: Path, capsys: pytest.CaptureFixture[str]) -> None:
    measured(bench, [*steady(), 40.0])
    with Store.open() as store:
        before = len(store.runs())
    assert start(bench) == 2
    told = capsys.readouterr().err
    assert "CS-1 is out of control (offset x: a point beyond 3 sigma" in told
    assert "--override NAME --because TEXT" in told
    with Store.open() as store:
        assert len(store.runs()) == before
    assert start(bench, "--dut", "CS-1") == 0
    assert labcal(["charts", "--bench", str(bench)]) == 1
    measured(bench, [5.0], first=20)  # it was measured again
    assert start(bench) == 0


def test_the_runs_of_another_bench_do_not_count(bench: Path, tmp_path: Path) -> None:
    other = tmp_path / "other.toml"
    other.write_text(bench.read_text().replace('name = "simulated cage"', 'name = "another cage"'))
    measured(other, [*steady(), 40.0])
    assert start(bench) == 0
    assert start(bench, "--override", "Dr. Roe", "--because", "to be safe") == 2  # there is nothing to answer for
    assert start(other) == 2


def test_a_person_who_lets_it_begin_stands_in_the_record_and_the_audit_log(
    bench: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    measured(bench, [*steady(), 40.0])
    assert start(bench, "--override", "Dr. Roe") == 2
    assert start(bench, "--because", "no name") == 2
    capsys.readouterr()
    assert start(bench, "--override", "Dr. Roe", "--because", "the standard was dropped") == 0
    run_id = capsys.readouterr().out.split()[-1]
    event = override_of(run_id)
    stated = json.loads(event.data["statement"])
    assert (stated["who"], stated["because"], stated["run_id"]) == ("Dr. Roe", "the standard was dropped", run_id)
    assert "signature" not in event.data
    entry = next(e for e in read_audit().entries if e.deed == "override")
    assert (entry.who, entry.about["run"]) == ("Dr. Roe", run_id)


def test_with_a_key_the_statement_is_signed(
    bench: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    measured(bench, [*steady(), 40.0])
    signer = new_key("roe", "a passphrase that is long enough")
    monkeypatch.setenv("LABCAL_PASSPHRASE", "a passphrase that is long enough")
    assert start(bench, "--override", "Dr. Roe", "--because", "dropped", "--key", "nobody") == 2
    capsys.readouterr()
    assert start(bench, "--override", "Dr. Roe", "--because", "dropped", "--key", "roe") == 0
    data = override_of(capsys.readouterr().out.split()[-1]).data
    signature = sshsig.parse(data["signature"].encode())
    signature.check(data["statement"].encode(), NAMESPACE)
    assert signature.public_key == signer.key
    with pytest.raises(sshsig.BadSignature):
        signature.check(data["statement"].replace("dropped", "fine").encode(), NAMESPACE)


def test_what_a_bench_file_states_wrongly_is_told_with_its_line(
    bench: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bench.write_text(bench.read_text().replace('"scale x"', '"scale q"'))
    assert labcal(["charts", "--bench", str(bench)]) == 2
    assert "check_standard.quantities" in capsys.readouterr().err
    assert labcal(["charts", "--bench", str(SIMULATED)]) == 2
    assert "[check_standard]" in capsys.readouterr().err
    assert read_config(SIMULATED).check_standard is None


def test_charts_are_written_and_drawn(bench: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    measured(bench, [*steady(), 40.0])
    out, told = tmp_path / "charts.png", tmp_path / "charts.json"
    assert labcal(["charts", "--bench", str(bench), "--out", str(out), "--json", str(told)]) == 1
    assert out.read_bytes().startswith(b"\x89PNG")
    found = json.loads(told.read_text())
    assert found["in_control"] is False
    assert found["charts"][0]["points"][-1]["rules_broken"] == [1]
    assert found["charts"][1]["out_of_control"] is False
    assert found["false_alarms"]["average_run_length"]["any"] == pytest.approx(91.75, abs=0.01)
    page = tmp_path / "charts.html"
    assert labcal(["charts", "CS-1", "--baseline", "10"]) == 1
    assert labcal(["charts", "--bench", str(bench), "--out", str(page)]) == 1
    assert "OUT OF CONTROL" in page.read_text()
    capsys.readouterr()
    assert labcal(["charts", "--bench", str(bench), "--json", "-"]) == 1
    assert json.loads(capsys.readouterr().out)["serial"] == "CS-1"


@pytest.mark.parametrize("words", [[], ["CS-1", "--bench", "x"], ["CS-9"], ["CS-1", "--out", "x.txt"], [""]])
def test_what_cannot_be_charted_is_refused(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert labcal(["charts", *words]) == 2
    assert len(capsys.readouterr().err.strip().splitlines()) == 1


def override_of(run_id: str) -> Event:
    with Store.open() as store:
        return next(i for i in store.items(run_id) if isinstance(i, Event) and i.kind == "override")
