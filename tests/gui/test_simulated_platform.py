"""Each session of a simulated bench begins anew: where its platform has another angle for that, the panel says why."""

import time
from dataclasses import replace

import pytest

from labcal.bench.coils.state import LabState, PlatformReading, unread
from labcal.gui.ipc.lab_messages import InstrumentRead, ReadLab


def stood(window, angle_deg, *, moving=False):
    """As it was left."""
    read_s = time.monotonic()
    window.app_state.take_lab(LabState(unread(), platform=PlatformReading(angle_deg, moving, read_s)))


def is_read(window, angle_deg):
    said = InstrumentRead(
        "stage", "platform", "", "a stage", None, False, time.monotonic(), angle_deg=angle_deg, moving=False
    )
    window.app_state.watch.read_all()
    window.app_state.watch_worker.answer(ReadLab, (said,))


@pytest.mark.parametrize(("was", "now", "said"), [(92.0, 0.0, True), (0.2, 0.0, False)])
def test_that_its_angle_is_another_one_because_it_began_anew_stands_beside_it(still, was, now, said):
    still.app_state.lab.update(platform_anew=False)
    assert still.app_state.facts.simulated
    stood(still, was)
    assert "anew" not in still.side.platform_group.age.text()
    is_read(still, now)
    assert ("simulated: began anew at its zero" in still.side.platform_group.age.text()) is said


def test_of_a_real_platform_nothing_of_that_is_said(still):
    still.app_state.lab.update(platform_anew=False)
    still.app_state.facts = replace(still.app_state.facts, simulated=False, virtual_time=False)
    stood(still, 92.0)
    is_read(still, 0.0)
    assert "anew" not in still.side.platform_group.age.text()
