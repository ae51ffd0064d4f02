"""The bench page without a process: readings, the cage's vectors, reconnect, an instrument that is silent."""

import re
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from lab_states import told
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QLabel, QPushButton

from labcal.bench.coils.state import CoilReading, FieldReading, Heard, LabState, PlatformReading, unread
from labcal.gui.ipc.answers import CoilEnd, Doubt, Ended, Identified, InstrumentAnswer, SwitchedOff
from labcal.gui.ipc.bench_commands import read_bench
from labcal.gui.ipc.messages import Identify, ReadBench, RunProcedure, SwitchOff
from labcal.gui.ipc.wire import Fault
from labcal.gui.pages.bench import HEADINGS
from labcal.gui.viewmodels.role_words import reading_text
from labcal.gui.widgets.cage_view import REACH, half_px
from labcal.record.stream import Block

BENCH = Path(__file__).parents[2] / "examples" / "simulated.toml"
T = np.array([1.0])
CURRENTS = np.array([[0.5, -0.2, 0.1]])
FIELD = np.array([[20_000.0, -3.0, 40_000.0]])


@pytest.fixture
def bench(still):
    still.open_page("Bench")
    return still.page("Bench")


def test_the_parts_of_the_field_are_those_that_the_panel_shows(still, bench):
    now = time.monotonic()
    coils = tuple(CoilReading(a, None, i, False, None, now) for a, i in zip("xyz", CURRENTS[0], strict=True))
    field = FieldReading(None, tuple(FIELD[0]), now)
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    block = Block("channel", "cage", ("i_coil_x", "i_coil_y", "i_coil_z"), T, CURRENTS * 2)  # as recorded before
    dut = Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), T, np.array([[1.0, 2.0, 3.0]]))
    still.app_state.bench_worker.items.emit((block, dut))
    still.app_state.bench_worker.states.emit(LabState(coils, field=field))
    bench.show_readings()
    applied = np.asarray(still.app_state.facts.cage.matrix) @ CURRENTS[0]
    (_, first), (_, second), (_, third) = bench.cage.vectors
    np.testing.assert_allclose(first, applied)
    np.testing.assert_allclose(np.add(first, second), third)
    np.testing.assert_allclose(third, FIELD[0])
    assert bench.when.text() == "all arrows to one scale"
    last = {bench.table.text(row, 1): bench.table.text(row, 4) for row in range(bench.table.rowCount())}
    assert (last["supply_x"], last["dut"]) == ("+0.500 A", "+1.0  +2.0  +3.0 count")
    assert "applied" in bench.cage_words.text()


def test_no_ambient_field_is_made_of_readings_of_two_moments(still, bench):
    now = time.monotonic()
    coils = tuple(CoilReading(a, None, 0.0, True, None, now) for a in "xyz")
    still.app_state.take_lab(LabState(coils, field=FieldReading(None, tuple(FIELD[0]), now - 30.0)))
    bench.show_readings()
    assert len(bench.cage.vectors) == 2  # applied and reference
    assert bench.when.text() == "as read last, not now; all arrows to one scale"


def test_who_is_led_here_reads_why(still, bench):
    heard = (Heard("dut", None, "silent"),)
    zero = tuple(CoilReading(a, None, 0.0, True, None, time.monotonic()) for a in "xyz")
    still.app_state.take_lab(LabState(zero, instruments=heard))
    bench.show_readings()
    assert bench.to_do.text() == "dut: see to plug, power and cable. Read all asks again."
    still.app_state.take_lab(LabState((*zero[:2], CoilReading("z", fault="silent"))))
    bench.show_readings()
    assert bench.to_do.text() == "✕ coils NOT confirmed at zero. COILS OFF (F12), then switch off by hand: supply_z."
    still.app_state.take_lab(LabState(zero))
    bench.show_readings()
    assert bench.to_do.isHidden()


def test_what_the_reference_read_last_is_what_the_panel_at_the_right_says(still, bench):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    block = Block("reference", "reference", ("ref_x", "ref_y", "ref_z"), T, FIELD)
    still.app_state.bench_worker.items.emit((block,))
    told(still)
    lab = still.app_state.run.lab
    seen = FieldReading(None, (20_400.0, 1_150.0, -43_700.0), time.monotonic() - 30.0)  # at zero, after the last block
    agreed = replace(lab.reference, read_s=seen.read_s)
    still.app_state.bench_worker.states.emit(replace(lab, field=seen, reference=agreed))
    bench.show_readings()
    last = {bench.table.text(row, 1): bench.table.text(row, 4) for row in range(bench.table.rowCount())}
    values, _, age = last["reference"].partition("   ")
    assert values == reading_text("reference", seen.seen_nT)
    assert age.endswith("s ago")
    in_panel = [one.text() for one in still.side.findChildren(QLabel)]
    assert set(values.removesuffix(" nT").split("  ")) <= set(in_panel)


def test_a_reading_has_the_time_it_was_read_and_not_that_of_an_answer_since(still, bench):
    """After Stop the ramp has put the field away, and the supplies' answers are newer than the last sample."""
    run, now = still.app_state.run, time.monotonic()
    run.start(RunProcedure("preflight", "bench.toml"))
    still.app_state.bench_worker.items.emit((Block("reference", "reference", ("x", "y", "z"), T, FIELD),))
    zero = tuple(CoilReading(a, None, 0.0, True, None, now) for a in "xyz")
    heard = (Heard("reference", now - 12.0), Heard("stage", now - 12.0))
    stood = PlatformReading(90.0, False, now - 50.0)
    still.app_state.bench_worker.states.emit(LabState(zero, instruments=heard, platform=stood))

    def last(name):
        row = next(row for row in range(bench.table.rowCount()) if bench.table.text(row, 1) == name)
        return bench.table.text(row, 4), bench.table.item(row, 4).foreground().color().name()

    bench.show_readings()
    text, ink = last("reference")  # just received, whoever answered when
    assert "ago" not in text
    newer = Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), T + 40.5, FIELD)  # and then what had waited
    late = Block("reference", "reference", ("x", "y", "z"), T, FIELD)
    still.app_state.bench_worker.items.emit((newer, late))
    bench.show_readings()
    text, ink = last("reference")
    assert text == f"{reading_text('reference', FIELD[0])}   40 s ago"
    assert ink == still.theme.muted.lower()
    assert last("stage")[0].endswith("50 s ago")


def test_the_cage_is_turned_by_keys(qtbot, bench):
    before = list(bench.cage.eye)
    qtbot.keyClick(bench.cage, Qt.Key.Key_Left)
    qtbot.keyClick(bench.cage, Qt.Key.Key_Up)
    assert [b - a for a, b in zip(before, bench.cage.eye, strict=True)] == [-5.0, 5.0]


def test_reconnect_lets_go_reads_the_file_again_and_asks_everybody(qtbot, still, bench):
    qtbot.mouseClick(bench.reconnect, Qt.MouseButton.LeftButton)
    assert len(still.app_state.quick_worker.commands(ReadBench)) == 1
    assert isinstance(still.app_state.off_worker.asked[-1].command, Identify)
    silent = Fault("instrument", "supply_x does not answer.", "Switch it on.")
    names = still.app_state.facts.instruments
    answers = tuple(InstrumentAnswer(n, "", "", "", silent if n == "supply_x" else None) for n in names)
    still.app_state.off_worker.answer(Identify, Identified(answers))
    said = {bench.table.text(row, 1): bench.table.text(row, 5) for row in range(bench.table.rowCount())}
    assert said["supply_x"] == "✕ supply_x does not answer."
    bench.show_readings()
    assert bench.to_do.text() == "supply_x: Switch it on. Read all asks again."
    assert said["stage"] == "✓ answers"
    assert still.message.text() == "6 of 7 instruments answered: ✕ supply_x"


def test_who_has_checked_is_told_and_one_button_is_blue(qtbot, still, bench):
    still.open_page("Bench")
    bench.check.setFocus()
    bench.check.click()
    assert QApplication.focusWidget() is bench.table
    names = still.app_state.facts.instruments
    still.app_state.off_worker.answer(Identify, Identified(tuple(InstrumentAnswer(n, "", "", "") for n in names)))
    bench.show_readings()
    assert still.message.text() == "All 7 instruments answered"
    assert not [one for one in bench.findChildren(QPushButton, "primary") if one.isVisible()]  # Next says what is next


@pytest.mark.parametrize(
    ("ago_s", "shown"),
    [
        (0.0, "✓ coils at zero"),
        (3.2, "■ coils read back at zero by their supplies; the reference agreed when it was last looked at, 0 s ago"),
    ],
)
def test_a_zero_in_doubt_is_measured_again_with_the_check_and_told(still, bench, ago_s, shown):
    answers = (InstrumentAnswer("supply_x", "coil-x", "tcp://x", "a supply"),)
    bench.check_all()
    doubt = Doubt("NOT at zero by the reference", lifted=False)
    still.app_state.off_worker.answer(Identify, Identified(answers, doubt))
    assert bench.fault.isVisible()
    assert bench.fault.text.text() == "NOT at zero by the reference"
    assert "--clear-as NAME" in bench.fault.remedy.text()
    bench.check_all()
    zero = tuple(CoilEnd(axis, 0.001, "zero, open", True, time.monotonic()) for axis in "xyz")
    said = SwitchedOff(zero, "it sees 20567 1260 12860 nT, 20366 1132 -43695 nT expected")
    still.app_state.off.order()
    still.app_state.off_worker.answer(SwitchOff, said)
    assert (still.fault.isVisible(), still.next.text()) == (True, "Next: See to the coils")
    assert len(still.app_state.off_worker.commands(Identify)) == 2  # by itself: the doubt is older than this zero
    seen = tuple(CoilEnd(axis, 0.001, "zero, open", True, time.monotonic() - ago_s) for axis in "xyz")
    still.app_state.off_worker.answer(Identify, Identified(answers, Doubt("they agree again", True, seen)))
    assert "A run may begin again" in still.app_state.lab.state.message
    assert re.sub(r"\d\d:\d\d:\d\d", "TIME", still.side.zero_words.text()) == shown
    assert not still.fault.isVisible()
    assert still.next.text() != "Next: See to the coils"


def test_a_supply_that_was_read_back_after_coils_off_has_not_failed_any_more(still, bench):
    names = {one.role: name for name, one in still.app_state.facts.instruments.items()}
    heard = (Heard(names["coil-z"], None, "the link was lost"), Heard(names["dut"], None, "silent"))
    still.app_state.take_lab(LabState(unread(), instruments=heard))
    assert still.next.text() == f"Next: See to {names['coil-z']}"
    still.app_state.off.order()
    zero = tuple(CoilEnd(axis, 0.0, "zero, open", True, time.monotonic()) for axis in "xyz")
    still.app_state.off_worker.answer(SwitchOff, SwitchedOff(zero, ""))
    lights = {name: light for name, light, _ in still.app_state.lab.state.now.lights}
    assert (lights[names["coil-z"]], lights[names["dut"]]) == ("ok", "fault")
    assert still.next.text() == f"Next: See to {names['dut']}"


def test_what_the_earth_s_field_is_at_the_bench_s_place_stands_beside_the_ambient_field(still, bench, tmp_path):
    file = tmp_path / "bench.toml"
    file.write_text(f"{BENCH.read_text()}\n[site]\nlatitude_deg = 47.0\nlongitude_deg = 8.0\nheight_m = 500\n")
    assert "outdoors" not in bench.cage_words.text()
    still.app_state.quick_worker.asked.clear()
    still.app_state.open_bench(str(file))
    still.app_state.quick_worker.answer(ReadBench, facts := read_bench(None, ReadBench(str(file))))
    assert facts.earth.magnitude_nT == pytest.approx(48_100, abs=600)  # of middle Europe in these years
    assert 200 < facts.earth.U_nT < 500
    assert f"{facts.earth.model} here, outdoors: 48 " in bench.cage_words.text().replace("\u202f", " ")


def test_how_an_instrument_stands_is_in_sight_beside_its_name_however_long_its_link(still):
    still.resize(1360, 860)
    still.open_page("Bench")
    bench = still.page("Bench")
    bench.table.set_cell(5, 2, "serial:///dev/serial/by-id/usb-FTDI_FT232R_USB_UART_A10XYZ12-if00-port0?baud=115200")
    QApplication.processEvents()
    header, seen = bench.table.horizontalHeader(), bench.table.viewport().width()
    assert [HEADINGS[header.logicalIndex(n)] for n in range(4)] == ["role", "instrument", "state", "last reading"]
    state = HEADINGS.index("state")
    assert header.sectionViewportPosition(state) + header.sectionSize(state) <= seen


def test_no_heading_of_the_table_is_cut_where_room_is_least(still, bench, qtbot):
    before = still.size()
    header = bench.table.horizontalHeader()
    for width in (1024, 1400, 1024):
        still.resize(width, 700)
        qtbot.waitUntil(lambda wide=width: still.width() == wide, timeout=60_000)
        QApplication.processEvents()
        assert [n for n in range(header.count()) if header.sectionSize(n) < header.sectionSizeHint(n)] == []
        assert (
            sum(map(header.sectionSize, range(header.count()))) >= bench.table.viewport().width()
        )  # none is left over
    still.resize(before)


def test_no_name_of_an_axis_of_the_cage_reaches_out_of_its_place_in_letters_of_any_size():
    for width, height in ((170.0, 240.0), (300.0, 200.0), (500.0, 180.0)):
        for name_px in (16.0, 26.0, 40.0):
            for share in (0.30, 0.34):
                half = half_px(width, height, share, name_px)
                assert REACH * half + name_px / 2 <= min(width, height) / 2 + 1e-9
    assert half_px(400.0, 400.0, 0.34, 16.0) == pytest.approx(136.0)  # with room enough it is as large as ever


def test_who_answered_is_whole_where_the_table_is_rolled_anyway(still, bench, qtbot):
    """It was cut behind the bar, and nobody there sees a tip."""
    before, facts = still.size(), still.app_state.facts
    still.resize(984, 660)
    named = "Thurlby Thandar Instruments PL303-P, 123450, 1.02-3.07"
    said = (InstrumentAnswer(name, one.role, one.link, named) for name, one in facts.instruments.items())
    still.app_state.take_identified(Identified(tuple(said)))
    bench.show_readings()
    table, column = bench.table, HEADINGS.index("who answered")
    qtbot.waitUntil(lambda: table.columnWidth(column) >= table.sizeHintForColumn(column))
    assert table.horizontalScrollBar().maximum() > 0
    assert table.text(1, column).endswith(named)
    still.resize(before)


@pytest.mark.parametrize("change", ["file", "link", "none"])
def test_another_bench_begins_with_no_reading_of_the_one_before(still, bench, change):
    app_state = still.app_state
    app_state.run.start(RunProcedure("preflight", "bench.toml"))
    read = [Block(kind, name, ("x", "y", "z"), T, FIELD) for kind, name in (("dut", "dut"), ("reference", "reference"))]
    app_state.bench_worker.items.emit(tuple(read))
    told(still)
    app_state.bench_worker.answer(RunProcedure, Ended("r1", "finished"))
    facts, path = app_state.facts, app_state.bench
    if change == "link":
        moved = {"dut": replace(facts.instruments["dut"], link="serial:///dev/pts/7")}
        facts = replace(facts, instruments=facts.instruments | moved)
    app_state.bench_known("/another/bench.toml" if change == "file" else path, facts)
    app_state.run.changed.emit()  # as at a change of the language: the ended run's lab stays with its bench
    bench.show_readings()
    last = {bench.table.text(row, 1): bench.table.text(row, 4) for row in range(bench.table.rowCount())}
    if change == "none":
        assert last["dut"].startswith(reading_text("dut", FIELD[0]))
        assert last["supply_x"] != "–"
    else:
        assert set(last.values()) == {"–"}
