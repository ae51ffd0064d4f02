"""Wherever the window says "guardian" it says in one sentence what that is."""

import time

import pytest
from PySide6.QtCore import QLocale

from labcal.bench.coils.state import CoilReading, LabState
from labcal.gui.ipc.wire import Fault
from labcal.gui.translations import translate
from labcal.gui.viewmodels.lab_now import LabNow
from labcal.gui.widgets.fault_card import FaultCard

SAYS = "takes every coil to zero when a session ends, breaks off or no longer answers"


def tell(window, guardian):
    now = time.monotonic()
    coils = tuple(CoilReading(a, None, 0.0, True, None, now) for a in "xyz")
    window.app_state.take_lab(LabState(coils, guardian=guardian))
    window.page("Bench").show_readings()


def test_in_the_panel_it_has_its_tip_and_nobody_else_has(still):
    tell(still, guardian=True)
    rows = [row for row in still.side.instrument_rows if not row.isHidden()]
    assert rows[-1].text().startswith("✓ guardian")
    assert SAYS in rows[-1].toolTip()
    assert not any(row.toolTip() for row in rows[:-1])


def test_a_guardian_that_is_lost_has_no_plug_and_no_cable(still):
    still.open_page("Bench")
    tell(still, guardian=False)
    words = still.page("Bench").to_do.text()
    assert words.startswith("The guardian is lost. COILS OFF (F12) works without it.")
    assert SAYS in words
    assert "cable" not in words
    tell(still, guardian=True)
    assert "guardian" not in still.page("Bench").to_do.text()


def test_a_card_that_speaks_of_it_explains_it_and_others_do_not(qtbot):
    card = FaultCard(closable=False)
    qtbot.addWidget(card)
    for fault in (
        Fault("guardian", "the guardian did not start.", "See guardian.log in labcal's data folder."),
        Fault("instrument", "cage: the interlock is open.", "It closes at zero; `guardian.log` says which is not."),
    ):
        card.show_fault(fault)
        assert SAYS in card.meaning.text()
        assert not card.meaning.isHidden()
    card.show_fault(Fault("instrument", "dut: no samples.", "Look at its cable."))
    assert card.meaning.isHidden()


@pytest.fixture
def german(qapp):
    translate.install_translator(qapp, QLocale("de"))
    yield
    translate.install_translator(qapp, QLocale("en"))


def test_its_name_is_said_in_the_language_of_the_window(german):
    assert LabNow(lights=(("guardian", "fault", ""), ("dut", "ok", ""))).failed == ["Wächter"]
