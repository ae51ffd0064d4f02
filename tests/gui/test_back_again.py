"""Who is back after a silence is said where it stands, with its times, until the next run begins."""

import re
import time
from dataclasses import replace
from datetime import datetime, timedelta

import pytest
from PySide6.QtWidgets import QApplication
from test_hands_in_the_cage import lab
from test_hands_in_the_cage import real as real

from labcal.bench.coils.state import Heard
from labcal.gui.ipc.messages import RunProcedure

BACK = re.compile(r"back (\d\d:\d\d:\d\d), out since (\d\d:\d\d:\d\d)")
HEARD_AGO_S = 60.0
NAMES = ("supply_x", "supply_y", "supply_z", "dut")


def told(window, *silent, unknown=()):
    """Everybody is heard now but who is `silent`, since `HEARD_AGO_S`; of the `unknown` nothing is said."""
    now = time.monotonic()
    heard = tuple(
        Heard(name, now - HEARD_AGO_S if name in silent else now, "silent" if name in silent else "")
        for name in NAMES
        if name not in unknown
    )
    window.app_state.take_lab(replace(lab(), instruments=heard))
    QApplication.processEvents()


def beside(window, name):
    """In the panel, and in the table of Bench, without the mark."""
    row = next(row for row in window.side.rows if row.name.text().split()[1] == name)
    bench = window.page("Bench")
    bench.show_readings()
    at = next(at for at in range(bench.table.rowCount()) if bench.table.text(at, 1) == name)
    return (
        "" if row.back.isHidden() else row.back.text(),
        f"{bench.table.text(at, 5)} {bench.table.item(at, 5).toolTip()}",
    )


@pytest.fixture
def back(real):
    told(real, "supply_z")
    assert "back" not in "".join(beside(real, "supply_z"))
    told(real)
    return real


def test_it_is_said_in_the_panel_and_on_bench_with_both_times(back):
    panel, table = (BACK.search(words) for words in beside(back, "supply_z"))
    assert panel is not None
    assert panel.group() == table.group()
    assert beside(back, "supply_z")[1].startswith(f"✓ answers, back {panel[1]}")  # in sight; the whole in its tip
    now = datetime.now()
    near = {(now + timedelta(seconds=one)).strftime("%H:%M:%S") for one in range(-2, 3)}
    long_ago = {(now + timedelta(seconds=one - HEARD_AGO_S)).strftime("%H:%M:%S") for one in range(-2, 3)}
    assert panel[1] in near
    assert panel[2] in long_ago
    assert "back" not in "".join(beside(back, "supply_x"))


def test_the_next_message_of_the_line_does_not_take_it_away(back):
    said = beside(back, "supply_z")
    back.app_state.lab.update(message="Something else.")
    told(back)
    assert beside(back, "supply_z") == said
    assert BACK.search(said[0])


def test_it_goes_with_the_next_silence_and_with_the_next_run(back):
    told(back, "supply_z")
    assert "back" not in "".join(beside(back, "supply_z"))
    told(back)
    assert BACK.search(beside(back, "supply_z")[0])
    back.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    assert "back" not in "".join(beside(back, "supply_z"))


def test_who_is_not_heard_is_not_back(real):
    told(real, "supply_z")
    told(real, unknown=("supply_z",))
    assert real.app_state.lab.state.back == ()
    told(real)
    assert [name for name, _ in real.app_state.lab.state.back] == ["supply_z"]
