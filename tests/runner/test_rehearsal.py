"""What a rehearsal makes of a bench file, however its links are written."""

from pathlib import Path

import pytest

from labcal.runner.catalogue import find
from labcal.runner.rehearsal import rehearsed

EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"
DUT = '[instruments.dut]\ndriver = "csv-line"\nlink = "emulated://"\nrole = "dut"\nsettings = '


@pytest.mark.parametrize("link", ['link = "{}"', '"link" = "{}"', "link = '{}'", "'link'=\"{}\" # where it is"])
def test_every_way_to_write_a_link_is_rehearsed(tmp_path, link):
    bench = tmp_path / "bench.toml"
    text = EXAMPLE.read_text(encoding="utf-8").replace("[twin]\nsurprise = true\n", "")
    bench.write_text(text.replace('link = "emulated://"', link.format("serial:///dev/ttyUSB0")), encoding="utf-8")
    assert rehearsed(bench, find("ambient"), {}).seconds > 0


def test_a_link_within_an_inline_table_is_rehearsed(tmp_path):
    bench = tmp_path / "bench.toml"
    text = EXAMPLE.read_text(encoding="utf-8").replace("[twin]\nsurprise = true\n", "")
    before, after = text.split(DUT)
    of_dut = 'dut = { driver = "csv-line", "link" = "tcp://10.0.0.7:4000", role = "dut", settings = '
    settings, rest = after.split("\n", 1)
    tables = before.split("[instruments.supply_x]")
    bench.write_text(f"{tables[0]}[instruments]\n{of_dut}{settings} }}\n\n[instruments.supply_x]{tables[1]}{rest}")
    assert rehearsed(bench, find("ambient"), {}).seconds > 0


SHORT = {"zero_s": "2", "dwell_s": "0.5", "rate_deg_per_s": "20"}
ONE_AXIS = "No whole calibration can come of one body axis"


@pytest.mark.parametrize(("axes", "whole"), [("z", False), ("x,z", True), (None, True)])
def test_a_plan_of_one_body_axis_promises_no_whole_calibration(axes, whole):
    given = {"modes": "nominal", "magnitudes_nT": "20000"} | SHORT
    plan = rehearsed(EXAMPLE, find("preflight"), given | ({} if axes is None else {"axes": axes}))
    assert plan.lines()[1].startswith(ONE_AXIS) != whole
    assert any(ONE_AXIS in line for line in plan.lines()) != whole


def test_a_plan_names_each_time_that_hands_are_needed_and_every_mounting_by_its_step():
    given = {"axes": "x,z", "magnitudes_nT": "20000", "reverse": "no", "modes": "nominal"} | SHORT
    lines = rehearsed(EXAMPLE, find("preflight"), given).lines()
    asked = lines[lines.index("what a person is asked, 8× in all:") + 1 :]
    ups = [(line.partition(" up ")[0], line.rpartition(".")[2]) for line in asked if line.startswith("– Mount")]
    assert ups == [("– Mount the DUT with body X", " (2×: zero, closing)"), ("– Mount the DUT with body Z", "")]
    assert "– The coils go up to 20 µT and the platform turns. Hands off? (3×)" in asked
    assert "– Switch the DUT to power mode nominal." in asked


def test_a_plan_says_the_largest_field_of_what_drives_coils_by_their_currents_too():
    plan = rehearsed(EXAMPLE, find("cage-map"), {"probes": "1", "field_nT": "40000"})
    assert 35e3 < plan.field_nT < 100e3
