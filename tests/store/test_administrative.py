"""What a certificate states beside the measurement: from bench.toml into the record; a reference that is overdue."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from labcal import session
from labcal.errors import InputError
from labcal.record.administrative import Address, Administrative, Certified, Equipment, Item, Laboratory
from labcal.store import bundle_of, read_bundle

EXAMPLE = (Path(__file__).resolve().parents[2] / "examples" / "simulated.toml").read_text(encoding="utf-8")
TABLES = """
[dut.item]
manufacturer = "Fluxworks"
received = 2026-01-02
[laboratory]
name = "Field Laboratory"
city = "Bern"
country = "CH"
code = "FL"
[customer]
name = "Satellite Works"
city = "Bremen"
country = "DE"
[environment]
pressure_hPa = 1013.0
Kp = 3
[[equipment]]
name = "thermometer"
certificate = { number = "T-1", issuer = "PTB", date = 2025-02-01 }
"""
STATED = Administrative(
    Laboratory("Field Laboratory", "Bern", "CH", code="FL"),
    Address("Satellite Works", "Bremen", "DE"),
    Item("Fluxworks", received="2026-01-02"),
    (Equipment("thermometer", certificate=Certified("T-1", "PTB", "2025-02-01")),),
)
IN_RUN_JSON = {
    "laboratory": {"name": "Field Laboratory", "city": "Bern", "country": "CH", "code": "FL"},
    "customer": {"name": "Satellite Works", "city": "Bremen", "country": "DE"},
    "item": {"manufacturer": "Fluxworks", "received": "2026-01-02"},
    "equipment": [{"name": "thermometer", "certificate": {"number": "T-1", "issuer": "PTB", "date": "2025-02-01"}}],
}


def with_certificate(text: str) -> str:
    return EXAMPLE.replace("[reference]", f"[reference]\ncertificate = {{ {text} }}") + TABLES


def test_a_run_keeps_what_the_bench_states_for_its_certificate(tmp_path: Path, home_of_its_own: Path):
    path = tmp_path / "bench.toml"
    path.write_text(with_certificate('number = "M-1", issuer = "PTB", date = 2025-01-05, due = 9999-01-05, U = "3 nT"'))
    assert session.run("rotate-axis", path, {"rate_deg_per_s": "20"}, run_id="R").status == "finished"
    kept = json.loads(session.run_bundle("R").run_json)
    assert kept["administrative"] == IN_RUN_JSON
    assert kept["environment"] == {"pressure_hPa": 1013.0, "Kp": 3.0}
    assert kept["reference"]["certificate"]["U"] == "3 nT"
    assert session.load_run("R").administrative == STATED


def test_what_nobody_states_is_not_in_the_record(bundle):
    run = read_bundle(bundle(lambda header: header.update(administrative=IN_RUN_JSON)))
    assert run.administrative == STATED
    assert json.loads(bundle_of(run).run_json)["administrative"] == IN_RUN_JSON
    assert b"administrative" not in bundle_of(replace(run, administrative=None)).run_json


@pytest.mark.parametrize(
    ("laboratory", "says"),
    [
        ({"name": "L", "city": "B", "country": "Swiss"}, "country"),
        ({"name": "L", "city": "B"}, "country"),
        ({"name": "a\nb", "city": "B", "country": "CH"}, "printable"),
        ({"name": "L", "city": "B", "country": "CH", "code": "a-b"}, "code"),
        ({"name": "L", "city": "B", "country": "CH", "town": "B"}, "town"),
    ],
)
def test_what_no_certificate_could_print_is_refused_with_its_line(bundle, laboratory: object, says: str):
    with pytest.raises(InputError, match=r"run.json, line \d+") as caught:
        read_bundle(bundle(lambda header: header.update(administrative={"laboratory": laboratory})))
    assert says in str(caught.value)


@pytest.mark.parametrize("procedure", ["degauss", "reference-check"])
def test_an_overdue_reference_stops_every_procedure(tmp_path: Path, home_of_its_own: Path, procedure: str):
    path = tmp_path / "bench.toml"
    path.write_text(with_certificate('number = "M-1", due = 2020-01-05'))
    with pytest.raises(InputError, match=r"overdue: its calibration M-1 was due 2020-01-05.*No procedure begins"):
        session.run(procedure, path, {})
    assert not session.runs()
