"""A procedure that judges a calibration asks for its file: chosen, not typed, refused where it is not there."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from pytestqt.qtbot import QtBot

from labcal.demo import simulated_bench
from labcal.gui.ipc.bench_commands import procedures, rehearse
from labcal.gui.ipc.messages import ListProcedures, Rehearse
from labcal.gui.widgets import parameter_form
from labcal.gui.widgets.parameter_form import ParameterForm


@pytest.fixture
def of_verify(qtbot: QtBot) -> ParameterForm:
    """What verify asks for."""
    channel: Any = None
    listed = procedures(channel, ListProcedures()).found
    form = ParameterForm(next(one for one in listed if one.name == "verify").parameters)
    qtbot.addWidget(form)
    return form


def test_the_file_that_is_chosen_is_what_the_run_is_given(
    of_verify: ParameterForm, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made = tmp_path / "FM-207.json"
    made.write_text("{}", encoding="utf-8")
    monkeypatch.setattr(parameter_form.QFileDialog, "getOpenFileName", lambda *_: (str(made), ""))
    assert "calibration" not in of_verify.given()
    of_verify._parts["calibration"][2].click()
    assert of_verify.given() == {"calibration": str(made)}
    assert of_verify.valid()


def test_a_file_that_is_not_there_is_refused_beside_its_field(of_verify: ParameterForm, tmp_path: Path) -> None:
    of_verify.set_text("calibration", str(tmp_path / "none.json"))
    assert not of_verify.valid()
    assert of_verify.complaints["calibration"].text() == "✕ there is no such file"


def test_the_plan_is_that_of_the_run_whatever_is_judged() -> None:
    channel: Any = None
    said = [
        rehearse(channel, Rehearse("verify", str(simulated_bench()), given, 0))
        for given in ({"positions": "4"}, {"positions": "4", "calibration": "FM-207.json"})
    ]
    assert said[0] == said[1]
