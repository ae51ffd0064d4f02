"""The JSON schema of bench.toml: it is the one of today, takes what labcal takes, and refuses what labcal refuses."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path
from runpy import run_path
from typing import Any

import jsonschema
import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "bench.schema.json"
BENCHES = [ROOT / "examples" / "simulated.toml", *sorted((ROOT / "examples").rglob("bench*.toml"))]
CHECKER = jsonschema.Draft202012Validator(json.loads(PAGE.read_text(encoding="utf-8")))


def bench(**edits: Any) -> dict[str, Any]:
    """The example's bench as an editor sees it, with other keys of supply_x."""
    table = tomllib.loads(BENCHES[0].read_text(encoding="utf-8"))
    table["instruments"]["supply_x"] |= edits
    return table


def test_it_is_the_one_of_today() -> None:
    tool = run_path(str(ROOT / "tools" / "bench_schema.py"))
    assert PAGE.read_text(encoding="utf-8") == tool["text"](), "python tools/bench_schema.py"


@pytest.mark.parametrize("path", BENCHES, ids=lambda path: path.name)
def test_it_takes_the_benches_of_the_examples(path: Path) -> None:
    CHECKER.validate(tomllib.loads(path.read_text(encoding="utf-8")))


@pytest.mark.parametrize(
    "edits",
    [
        {"driver": "ea-ps2000b", "settings": {"channel": 3}},
        {"driver": "ea-ps2000b", "settings": {"chanel": 1}},
        {"driver": "tti-pl", "settings": {"max_current_A": -1.0}},
        {"role": "coil-w"},
        {"link": "no link"},
        {"colour": "red"},
    ],
)
def test_it_refuses_what_labcal_refuses(edits: dict[str, Any]) -> None:
    CHECKER.validate(bench(driver="ea-ps2000b", settings={"channel": 2}))
    with pytest.raises(jsonschema.ValidationError):
        CHECKER.validate(bench(**edits))


def test_a_driver_of_another_package_has_settings_of_its_own() -> None:
    CHECKER.validate(bench(driver="my-supply", settings={"anything": 1}))


def test_one_number_stands_for_three_axes_and_units_are_told() -> None:
    table = bench()
    table["cage"]["limits"] |= {"current_A": 2.5, "ramp_A_per_s": [1.0, 1.0, 2.0]}
    CHECKER.validate(table)
    table["cage"]["limits"]["current_A"] = -2.5
    with pytest.raises(jsonschema.ValidationError):
        CHECKER.validate(table)
    told = json.loads(PAGE.read_text(encoding="utf-8"))["$defs"]["CageLimits"]["properties"]["ramp_A_per_s"]
    assert told["description"] == "Unit: A/s"
