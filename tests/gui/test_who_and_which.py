"""The DUT and the operator at the top: what is refused says why at once, and no slip of a key switches coils off."""

import pytest
from geometry import faults
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication
from test_a_question_keeps_its_places import asking

from labcal.certificate.allowed_signers import check_principal
from labcal.gui.ipc.messages import SwitchOff
from labcal.gui.viewmodels.operator_name import name_objection
from labcal.record.stream import Prompt
from labcal.runner.another_dut import KEY, NO, YES

TRUSTED = ("jdoe", "ada@lab.example", "a.smith", "a_b-c+d", "007")
NAMES = ("J. Doe", "Doe, J.", "Sean O'Brien", "Seán O’Brien", "'t Hooft, G.", "Anne-Marie Müller", "山田太郎", "Ольга",
         "हिन्दी", "Jane (night shift)", "J. Doe & A. Smith")  # fmt: skip


@pytest.mark.parametrize("name", [*TRUSTED, *NAMES, ""])
def test_what_a_person_or_a_key_is_called_is_a_name(name):
    assert name_objection(name) == ""


@pytest.mark.parametrize("letter", [chr(code) for code in range(33, 127)])
def test_every_letter_that_a_signature_accepts_is_accepted(letter):
    try:
        check_principal(f"a{letter}")
    except ValueError:
        return
    assert name_objection(f"a{letter}") == ""


@pytest.mark.parametrize(
    "typed",
    [
        "12|;",
        pytest.param("J. Doe;", marks=pytest.mark.slow),
        pytest.param("-", marks=pytest.mark.slow),
        pytest.param("...", marks=pytest.mark.slow),
        "<b>",
        pytest.param("a=b", marks=pytest.mark.slow),
        pytest.param("x" * 1000, marks=pytest.mark.slow),
    ],
)
def test_a_slip_of_the_keys_is_no_name_and_the_reason_stands_beside_the_field(still, typed):
    top, choose = still.top, still.page("Run").choose
    still.app_state.set_identity(operator=typed)
    assert (top.operator.property("state"), top.reason.isVisible(), choose.start.isEnabled()) == ("bad", True, False)
    assert top.reason.text() == f"✕ {name_objection(typed)}"
    assert choose.objection.text() == "Correct what is red at the top."  # where it is said why, once
    assert still.next.text() == "Next: Say who works here"
    still.next.click()
    assert top.operator.hasFocus()
    still.app_state.set_identity(operator="J. Doe")
    assert (top.operator.property("state"), top.reason.isVisible(), choose.start.isEnabled()) == ("", False, True)


def test_a_refused_dut_says_why_before_any_bench_is_open(new_window):
    new_window.app_state.facts = None
    new_window.app_state.lab.update(bench="")
    new_window.app_state.set_identity(dut="EM?07")
    assert new_window.top.dut.property("state") == "bad"
    assert new_window.top.reason.isVisible()
    assert new_window.top.reason.text().startswith("✕ 'EM?07' is no serial number")
    new_window.app_state.set_identity(dut="EM-07")
    assert not new_window.top.reason.isVisible()


def test_a_name_tab_space_switches_no_coils_off_and_f12_does(qtbot, still, patience):
    operator, worker = still.top.operator, still.app_state.off_worker
    operator.setFocus()
    qtbot.waitUntil(operator.hasFocus, timeout=patience)
    for key in (Qt.Key.Key_Tab, Qt.Key.Key_Space):
        qtbot.keyClick(QApplication.focusWidget(), key)
        still.scanner.flush()
    assert not operator.hasFocus()
    assert worker.commands(SwitchOff) == []
    qtbot.keyClick(QApplication.focusWidget() or still, Qt.Key.Key_F12)
    assert len(worker.commands(SwitchOff)) == 1


def test_the_question_of_another_serial_says_what_no_does(new_window):
    text = "dut names itself EM-21, and this run is of EM-07. Measure it as EM-07 all the same?"
    card = asking(new_window, Prompt(1.0, KEY, text, (NO, YES)), (1024, 700))
    assert card.hint.text().startswith("No: nothing is measured")
    assert [made.objectName() for made in card.choices.values()] == ["primary", ""]
    assert faults(new_window) == []
