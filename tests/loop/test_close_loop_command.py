"""`labcal close-loop`: exit codes and JSON by the contract."""

import csv
import json
from pathlib import Path
from types import ModuleType

import pytest

from labcal import cli

EFFECT_KEYS = {
    "effect", "channels", "reference_value", "belongs_to", "provisional", "parameters", "holdout_rms_before_nT",
    "holdout_rms_after_nT", "improvement_ci95_nT", "p_value", "rivals", "why",
}  # fmt: skip


def test_the_result_has_the_contract_s_keys_and_an_explained_run_exits_0(
    shared: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.execute(["close-loop", str(shared / "data/px4-battery-current"), "--json", "-"]) == 0
    result = json.loads(capsys.readouterr().out)
    assert set(result) >= {
        "format", "run_id", "residual_kind", "base", "noise_floor_nT", "noise_floor_source", "before", "after",
        "set_aside", "accepted", "rejected", "verdict", "summary", "next_experiment",
    }  # fmt: skip
    assert result["format"] == "labcal-closed-loop/1"
    assert all(set(e) == EFFECT_KEYS for e in (*result["accepted"], *result["rejected"]))


def test_a_run_that_does_not_exist_exits_2(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.execute(["close-loop", "nowhere/at/all"]) == 2
    assert "nowhere/at/all" in capsys.readouterr().err


def test_an_ambiguous_run_exits_1_and_says_what_to_measure(shared: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.execute(["close-loop", str(shared / "data/practice/p08/bundle"), "--json", "-"]) == 1
    result = json.loads(capsys.readouterr().out)
    assert result["verdict"] == "ambiguous"
    assert result["next_experiment"]["do"]
    assert result["accepted"][0]["rivals"]


def test_the_flight_log_names_its_battery_current_with_base_offset(shared: Path, tmp_path: Path) -> None:
    out = tmp_path / "r.json"
    cli.execute(["close-loop", str(shared / "data/px4-battery-current"), "--json", str(out)])
    result = json.loads(out.read_text())
    assert result["base"] == "offset"
    assert 850 < result["before"]["holdout_rms_nT"] < 950
    assert [e["effect"] for e in result["accepted"]] == ["offset-current"]


@pytest.mark.slow
def test_a_run_whose_rig_adds_a_field_is_valid_in_the_fields_that_the_device_met(
    making: ModuleType, tmp_path: Path
) -> None:
    rows, segments = making.recorded()
    rows["ref"] = rows["ref"] - [400.0, 500.0, 450.0]  # a field of the cage that the reference does not see
    bundle, made, out = making.written(tmp_path / "run", rows, segments), tmp_path / "cal.json", tmp_path / "out.csv"
    assert cli.execute(["close-loop", str(bundle), "--out", str(made)]) == 0
    assert [effect["effect"] for effect in json.loads(made.read_text())["findings"]] == ["cage-field"]
    assert cli.execute(["apply", str(made), str(bundle / "samples.csv"), "--out", str(out)]) == 0
    with out.open(newline="") as source:
        flags = [row["flag"] for row in csv.DictReader(source)]
    assert sum(flag != "" for flag in flags) < 0.01 * len(flags)
