"""What cannot come of the settings, or cannot be set on this bench, is said in the form and not after Begin."""

import pytest

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
