"""What cannot come of the settings, or cannot be set on this bench, is said in the form and not after Begin."""

from dataclasses import replace
from pathlib import Path

import pytest

from labcal.gui.ipc.answers import Ended
from labcal.gui.ipc.bench_commands import read_bench
from labcal.gui.ipc.messages import ReadBench, RunProcedure
from labcal.gui.viewmodels.not_at_rest import not_at_rest, why_not_at_rest

BENCH = Path(__file__).parents[2] / "examples" / "simulated.toml"
ONE_AXIS = "▲ No whole calibration can come of one body axis"


@pytest.fixture
def choose(still):
    still.open_page("Run")
    found = still.page("Run").choose
    found.choose("preflight")
    yield found
    found.form.set_text("axes", "x, y, z")


def test_one_body_axis_is_said_to_give_no_whole_calibration_before_begin(choose):
    assert ONE_AXIS not in choose.objection.text()
    choose.form.set_text("axes", "z")
    assert choose.objection.text().startswith(ONE_AXIS)
    assert choose.objection.property("state") == "warning"
    assert choose.form.valid()  # allowed all the same
    choose.form.set_text("axes", "x, z")
    assert ONE_AXIS not in choose.objection.text()


@pytest.fixture
def with_modes(still, choose):
    """The bench's DUT has these power modes."""
    before = still.app_state.facts

    def have(*modes):
        still.app_state.facts = replace(before, modes=modes)
        still.app_state.bench_changed.emit()
        return choose

    yield have
    still.app_state.facts = before
    still.app_state.bench_changed.emit()
    choose.choose("preflight")


def test_a_power_mode_that_the_dut_does_not_have_is_refused_in_its_field_with_those_there_are(with_modes):
    choose = with_modes("nominal", "full", "safe")
    choose.form.set_text("magnitudes_nT", "30000")
    choose.form.set_text("modes", "nominal, fast")
    assert choose.form.complaints["modes"].text().startswith("✕ expected one of nominal, full, safe")
    assert choose.form.fields["modes"].property("state") == "bad"
    assert not choose.start.isEnabled()
    choose = with_modes("fast", "nominal")  # another DUT, which has it; what was typed stays
    assert choose.form.valid()
    assert choose.form.text("magnitudes_nT") == "30000"
    choose = with_modes()  # none stated: any may be meant
    choose.form.set_text("modes", "whatever")
    assert choose.form.valid()


def test_one_power_mode_is_chosen_among_those_there_are(with_modes):
    choose = with_modes("low", "high")
    choose.choose("rotate-axis")
    field = choose.form.fields["mode"]
    assert [field.itemData(n) for n in range(field.count())] == ["low", "high"]
    assert (
        choose.form.given()["mode"] == "low"
    )  # what is seen is what is sent, though the procedure has another default
    choose.form.set_text("mode", "high")
    assert choose.form.given()["mode"] == "high"
    with_modes("high", "low", "off")
    assert choose.form.text("mode") == "high"  # what was chosen stays, in the form of the other bench too


def test_the_bench_file_says_which_power_modes_there_are():
    assert read_bench(None, ReadBench(str(BENCH))).modes == ("nominal", "full", "safe")


def test_a_rate_beyond_what_dut_and_platform_allow_is_refused_in_its_field(still):
    assert read_bench(None, ReadBench(str(BENCH))).fastest_deg_per_s == 20.0  # the DUT's; the stage may 24
    still.open_page("Run")
    choose = still.page("Run").choose
    choose.choose("preflight")
    assert "0 … 20 deg/s" in choose.form.complaints["rate_deg_per_s"].text()
    choose.form.set_text("rate_deg_per_s", "45")
    assert choose.form.complaints["rate_deg_per_s"].text().startswith("✕ expected")
    assert not choose.start.isEnabled()
    choose.form.set_text("rate_deg_per_s", "20")
    assert choose.form.valid()


def test_the_bench_is_not_asked_anything_in_a_run_and_says_why(still):
    still.open_page("Bench")
    page = still.page("Bench")
    asks = (page.check, page.reconnect, page.make, page.choose, page.simulated)
    assert all(button.isEnabled() for button in asks)
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    assert not any(button.isEnabled() for button in asks)
    assert all(button.toolTip().startswith("A run goes on") for button in asks)
    still.app_state.bench_worker.answer(RunProcedure, Ended("r1", "finished"))
    assert all(button.isEnabled() and not button.toolTip().startswith("A run") for button in asks)


def test_that_a_run_holds_the_instruments_stands_beside_what_cannot_be_pressed(still):
    still.open_page("Bench")
    page = still.page("Bench")
    assert not page.after_it.isVisible()
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    assert page.after_it.isVisible()
    assert page.after_it.text() == page.check.toolTip()
    still.app_state.bench_worker.answer(RunProcedure, Ended("r1", "finished"))
    assert not page.after_it.isVisible()


@pytest.mark.parametrize(("driven", "said"), [(True, "read again in the next step"), (False, "not looked at at rest")])
def test_why_the_dut_is_not_read_stands_in_its_row(driven, said):
    assert not_at_rest("dut", "old", driven=driven) == said
    assert ("opens its port" in why_not_at_rest(f"◌ 35 s ago, {said}")) is not driven
    assert not_at_rest("dut", "ok", driven=driven) == not_at_rest("reference", "old", driven=driven) == ""
