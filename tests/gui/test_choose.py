"""What to run: what it needs, how long it takes, its form, and what keeps Start waiting."""

import pytest


@pytest.fixture
def choose(still):
    return still.page("Run").choose


def test_every_procedure_says_what_it_needs_and_how_long_it_takes(choose):
    for row in range(choose.list.count()):
        choose.list.setCurrentRow(row)
        assert "Needs: " in choose.needs.text(), choose.list.item(row).text()
        assert "min of measuring" in choose.needs.text()


def test_a_setting_out_of_range_is_named_and_start_waits(choose):
    choose.choose("preflight")
    assert choose.start.isEnabled()
    choose.form.set_text("inclination_deg", "80")
    assert not choose.start.isEnabled()
    assert "35 to 65" in choose.form._complaints["inclination_deg"].text()


def test_no_operator_no_run(still, choose):
    still.desk.who(operator="")
    assert not choose.start.isEnabled()
    assert "operator" in choose.objection.text()
