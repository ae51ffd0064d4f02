"""The bench page without a process: readings, the cage's vectors, reconnect, an instrument that is silent."""

import numpy as np
import pytest
from lab_states import told
from PySide6.QtCore import Qt

from labcal.gui.run_vm import Order
from labcal.gui.wire import item_to_json
from labcal.record.stream import Block

T = np.array([1.0])
CURRENTS = np.array([[0.5, -0.2, 0.1]])
FIELD = np.array([[20_000.0, -3.0, 40_000.0]])


@pytest.fixture
def bench(still):
    still.open_page("Bench")
    return still.page("Bench")


def test_the_parts_of_the_field_are_those_that_were_recorded_together(still, bench):
    still.desk.run.start(Order("preflight", "bench.toml"))
    blocks = (
        Block("channel", "cage", ("i_coil_x", "i_coil_y", "i_coil_z"), T, CURRENTS),
        Block("reference", "reference", ("ref_x", "ref_y", "ref_z"), T, FIELD),
        Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), T, np.array([[1.0, 2.0, 3.0]])),
    )
    still.desk.bench_worker.items.emit([item_to_json(item) for item in blocks])
    told(still)
    bench._show_readings()
    applied = np.asarray(still.desk.facts["cage"]["matrix"]) @ CURRENTS[0]
    (_, first), (_, second), (_, third) = bench.cage._vectors
    np.testing.assert_allclose(first, applied)
    np.testing.assert_allclose(np.add(first, second), third)
    np.testing.assert_allclose(third, FIELD[0])
    last = {bench.table.text(row, 1): bench.table.text(row, 4) for row in range(bench.table.rowCount())}
    assert (last["supply_x"], last["dut"]) == ("+0.000 A", "+1.0  +2.0  +3.0 count")
    assert "applied" in bench.cage_words.text()


def test_the_cage_is_turned_by_keys(qtbot, bench):
    before = list(bench.cage._eye)
    qtbot.keyClick(bench.cage, Qt.Key.Key_Left)
    qtbot.keyClick(bench.cage, Qt.Key.Key_Up)
    assert [b - a for a, b in zip(before, bench.cage._eye, strict=True)] == [-5.0, 5.0]


def test_reconnect_lets_go_reads_the_file_again_and_asks_everybody(qtbot, still, bench):
    qtbot.mouseClick(bench.reconnect, Qt.MouseButton.LeftButton)
    assert [one[0] for one in still.desk.clerk.asked if one[0] == "bench"] == ["bench"]
    assert still.desk.switch.asked[-1][0] == "greet"
    silent = {"kind": "instrument", "text": "supply_x does not answer.", "remedy": "Switch it on.", "details": ""}
    names = list(still.desk.facts["instruments"])
    greetings = [{"name": n, "role": "", "link": "", "identity": "", "fault": silent if n == "supply_x" else None}
                 for n in names]  # fmt: skip
    still.desk.switch.answer("greet", greetings)
    said = {bench.table.text(row, 1): bench.table.text(row, 5) for row in range(bench.table.rowCount())}
    assert said["supply_x"] == "✕ supply_x does not answer. Switch it on."
    assert said["stage"] == "✓ answers"


def test_a_zero_in_doubt_is_measured_again_with_the_check_and_told(still, bench):
    answer = {"name": "supply_x", "role": "coil-x", "link": "tcp://x", "identity": "a supply", "fault": None}
    bench.check_all()
    still.desk.switch.answer("greet", [answer | {"doubt": {"words": "NOT at zero by the reference", "lifted": False}}])
    assert bench.fault.isVisible()
    assert bench.fault.text.text() == "NOT at zero by the reference"
    assert "--clear-as NAME" in bench.fault.remedy.text()
    bench.check_all()
    still.desk.switch.answer("greet", [answer | {"doubt": {"words": "they agree again", "lifted": True}}])
    assert still.desk.lab.state.message == "they agree again"
