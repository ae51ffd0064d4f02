"""Settings have the decimal mark that readings beside them have; what is typed may have a point all the same."""

import pytest
from test_nothing_is_cut import other_language as other_language

from labcal.bench.parameters import Limits, ParameterSpec
from labcal.gui.widgets.parameter_form import ParameterForm, range_of

LIMITS = Limits(0.001, 0.5, unit="s")


def spec(name, default, **more):
    made = {"kind": "number", "limits": LIMITS, "help": "", **more}
    return ParameterSpec(name=name, default=default, **made)


@pytest.fixture
def form(qtbot):
    made = ParameterForm([spec("u_time_s", 0.005), spec("several_s", (0.1, 0.25), many=True)])
    qtbot.addWidget(made)
    return made


@pytest.mark.parametrize(
    ("other_language", "mark"), [("en", "."), ("de", ","), ("fr", ",")], indirect=["other_language"]
)
def test_a_number_is_written_as_readings_are(other_language, mark, form):
    assert form.fields["u_time_s"].text() == f"0{mark}005"
    assert range_of(spec("u_time_s", 0.005)).split(" … ") == [f"0{mark}001", f"0{mark}5 s"]
    assert form.fields["several_s"].text() == "0.1, 0.25"  # a comma stands between two
    assert (form.is_usual(), form.given(), form.valid()) == (True, {}, True)


@pytest.mark.parametrize("other_language", ["de", "fr"], indirect=True)
@pytest.mark.parametrize("typed", ["0,02", "0.02"])
def test_either_mark_is_taken(other_language, form, typed):
    form.fields["u_time_s"].setText(typed)
    assert form.valid()
    assert form.given() == {"u_time_s": "0.02"}
    form.make_usual()
    assert (form.fields["u_time_s"].text(), form.given()) == ("0,005", {})
    form.propose({"u_time_s": "0.03"})
    assert (form.fields["u_time_s"].text(), form.given()) == ("0,03", {"u_time_s": "0.03"})
