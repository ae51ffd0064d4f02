"""What is said of coils after COILS OFF is whole in the line below, in every language and in a small window."""

import pytest
from test_hands_in_the_cage import lab
from test_nothing_is_cut import other_language as other_language
from test_nothing_is_cut import settle
from test_off_unanswered import ends

from labcal.bench.coils.state import PlatformReading
from labcal.gui.ipc.answers import SwitchedOff
from labcal.gui.ipc.messages import SwitchOff
from labcal.gui.viewmodels.lab_off import coils_ended


def test_coils_that_ended_alike_are_named_together():
    alike = coils_ended((axis, "zero, open") for axis in "xyz")
    assert alike == "x, y, z: zero, output open"
    apart = coils_ended(zip("xyz", ("zero, open", "no answer", "zero, open"), strict=True))
    assert apart == "x, z: zero, output open; y: no answer"


@pytest.mark.parametrize("other_language", ["en", "de", "fr"], indirect=True)
def test_the_line_after_off_is_whole_in_a_small_window(other_language, new_window, rest):
    window = rest(new_window)
    window.resize(1024, 700)
    window.app_state.take_lab(lab(platform=PlatformReading()))
    window.app_state.off.order()
    window.app_state.off_worker.answer(SwitchOff, SwitchedOff(ends()))
    settle(window)
    assert window.message.text().count("x, y, z") == 1
    assert not window.message.is_cut()
