"""While nobody has seen the platform stand Next begins nothing; who is silent alike is asked about once."""

from dataclasses import replace

import pytest
from test_hands_in_the_cage import lab, stands
from test_hands_in_the_cage import real as real

from labcal.bench.coils.state import PlatformReading
from labcal.bench.links.heard_before import PLUG
from labcal.gui.ipc.answers import InstrumentAnswer
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.bench_to_do import to_do
from labcal.gui.viewmodels.lab_now import lab_now

MODBUS = "address 1 on modbus-rtu:///dev/pts/4?baud=9600: no valid Modbus reply."


@pytest.mark.parametrize("platform", [PlatformReading(fault="silent"), stands(moving=True, age_s=30.0)])
def test_next_stops_a_platform_that_nobody_has_seen_to_stand(real, platform):
    app_state = real.app_state
    app_state.set_identity(dut="EM-07", operator="J. Doe")
    app_state.take_lab(lab(platform=stands()))
    assert "COILS OFF" not in real.next.text()
    app_state.take_lab(lab(platform=platform))
    assert real.next.text() == "Next: Stop the platform (COILS OFF)"
    app_state.facts = replace(app_state.facts, virtual_time=True)  # emulated, it is gone with the run
    app_state.take_lab(lab(platform=PlatformReading(fault="silent")))
    assert "COILS OFF" not in real.next.text()


def test_beside_it_next_asks_nobody_again_who_is_silent(real):
    real.open_page("Bench")
    real.app_state.take_lab(lab((None, 0.0, 0.0), PlatformReading(fault="silent"), ("supply_x", "stage")))
    assert real.next.text() == "Next: See to the coils"
    assert not real.app_state.path.next().presses


def test_one_question_for_all_who_are_silent_alike(real):
    names = ("supply_x", "supply_y", "stage")
    fault = Fault("instrument", "no reply", PLUG)
    real.app_state.answered |= {name: InstrumentAnswer(name, "", "", "", fault) for name in names}
    real.app_state.take_lab(lab(platform=stands(), faulty=names))
    assert to_do(real.app_state).count("plug") == 1
    assert to_do(real.app_state).startswith("supply_x, supply_y, stage: they have answered at these links before")
    real.app_state.take_lab(lab(platform=stands(), faulty=names[:1]))
    assert to_do(real.app_state).startswith(f"supply_x: {PLUG}")


def test_no_technician_is_told_of_a_modbus_address():
    known = replace(lab(), instruments=())
    heard = replace(lab(faulty=("reversers",)).instruments[0], fault=MODBUS)
    lights = lab_now(replace(known, instruments=(heard,)), 0.0, {"reversers": "polarity"}, 0.0).lights
    assert lights[0][2].startswith("no answer (plug? power?)")
