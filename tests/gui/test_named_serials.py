"""An instrument that names another serial than is stated: amber in the panel, on Bench and where it is mounted."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtWidgets import QApplication

from labcal.bench.driver_kit.roles import Identity
from labcal.bench.named_serials import other_serials
from labcal.bench.serials import is_another
from labcal.gui.ipc.answers import Identified, InstrumentAnswer
from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.viewmodels.told_words import open_words, serials_words
from labcal.record.stream import OTHER_SERIAL, Event, Prompt
from labcal.record.told import Told
from labcal.session.told import others

MOUNT = Prompt(1.0, "mount-y", "Mount the DUT.", ("done",), True, {"body_from_cage": np.eye(3).tolist()})
SAYS = {"instrument": "dut", "named": "EM-21", "stated": "EM-07"}


@pytest.fixture
def real(still):
    """A lab that is not simulated, with EM-07 at the top."""
    app_state, before = still.app_state, still.app_state.facts
    app_state.facts = replace(before, simulated=False)
    app_state.set_identity(dut="EM-07")
    yield still
    app_state.facts = before
    app_state.named_serials.forget()


def answers(window, serial):
    said = InstrumentAnswer("dut", "dut", "serial:///dev/x", f"maker {serial}", None, serial)
    window.app_state.take_identified(Identified((said,), None))


def row_of(window):
    return next(row for row in window.side.instrument_rows if "dut" in row.text())


def test_it_is_amber_in_the_panel_and_on_bench_until_the_serial_at_the_top_is_that_one(real):
    real.open_page("Bench")
    answers(real, "EM-21")
    assert row_of(real).text() == "▲ dut  names itself EM-21, not EM-07"
    assert row_of(real).property("state") == "warning"
    page = real.page("Bench")
    page.show_readings()
    row = next(n for n in range(page.table.rowCount()) if page.table.text(n, 1) == "dut")
    assert page.table.text(row, 3).startswith("▲ names itself EM-21, not EM-07")
    real.app_state.set_identity(dut="EM-21")
    QApplication.processEvents()
    assert "names itself" not in row_of(real).text()
    page.show_readings()
    assert page.table.text(row, 3) == "maker EM-21"


def test_a_question_to_mount_says_it_too_and_a_run_tells_of_it_by_itself(real):
    real.open_page("Run")
    real.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    emit = real.app_state.bench_worker.items.emit
    emit((Event(0.0, OTHER_SERIAL, "dut names itself EM-21, and this run is of EM-07", SAYS), MOUNT))
    card = real.page("Run").live.prompt
    assert card.serials.isVisible()
    assert card.serials.text() == "▲ dut names itself EM-21, not EM-07"
    assert card.serials.property("state") == "warning"
    emit((Prompt(2.0, "ready", "Hands off?", ("done",), True),))
    assert not card.serials.isVisible()


def test_whoever_begins_is_asked_whether_it_is_the_right_sensor(real):
    objection = real.page("Run").choose.objection
    answers(real, "EM-21")
    QApplication.processEvents()
    assert objection.text().startswith("▲ dut names itself EM-21, not EM-07: is this the right sensor?")
    assert objection.property("state") == "warning"
    assert real.page("Run").choose.start.isEnabled()  # a person decides
    real.app_state.set_identity(dut="EM-21")
    QApplication.processEvents()
    assert "right sensor" not in objection.text()


def test_history_and_the_certificate_tell_of_it_after_the_run():
    said = Event(0.0, OTHER_SERIAL, "dut names itself EM-21, and this run is of EM-07", SAYS)
    told = Told(other_serials=others([said, said]))
    assert serials_words(told) == "▲ dut names itself EM-21, and this run is of EM-07."
    assert open_words(told).startswith("▲ Open in the run itself: dut names itself EM-21, and this run is of EM-07.")
    assert serials_words(Told()) == open_words(Told()) == ""


def test_a_simulated_dut_is_whichever_is_asked_for(still):
    still.app_state.set_identity(dut="EM-07")
    answers(still, "SIM-0001")
    assert still.app_state.lab.state.other_serials == ()


def test_what_is_not_said_is_no_other_and_what_a_driver_adds_stands_beside_it():
    assert is_another("EM-21", "EM-07")
    assert not any((is_another("", "EM-07"), is_another("EM-07", ""), is_another("4711 em-07", "EM-07")))


def test_the_record_of_a_run_has_it_as_an_event():
    named = {
        "dut": Identity("", "line", "EM-21"),
        "meter": Identity("Fluke", "8846A", "12"),
        "stage": Identity("", "", "9"),
    }
    roles = {
        name: SimpleNamespace(role=role) for name, role in (("dut", "dut"), ("meter", "channel"), ("stage", "platform"))
    }
    stated = (SimpleNamespace(name="meter", serial="11"),)
    config = SimpleNamespace(instruments=roles, equipment=stated, unreal=False)
    bench = SimpleNamespace(config=config, known=named, dut_serial="EM-07", clock=SimpleNamespace(now=lambda: 3.0))
    said = [event.text for event in other_serials(bench)]
    assert said == [
        "dut names itself EM-21, and this run is of EM-07",
        "meter names itself 12, and bench.toml states 11",
    ]
    config.unreal = True
    assert [event.data["instrument"] for event in other_serials(bench)] == ["meter"]
