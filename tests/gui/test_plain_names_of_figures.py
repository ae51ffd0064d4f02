"""K and k are named so that who has not met them knows what they are; exactly they stand in a tip."""

from labcal.gui.ipc.messages import LastClosingCheck
from labcal.gui.viewmodels.gain_words import GAINS, gain_means, gain_name


def test_gains_are_named_by_their_axes_row_by_row_as_the_map_has_them():
    assert [gain_name(*gain) for gain in GAINS][:2] == ["gain K x by x", "gain K x by y"]
    assert gain_means("x", "y") == "What a reading along y adds to the field along x."


def test_fit_says_what_it_finds_and_exactly_in_its_tip(still):
    page = still.page("Fit")
    still.open_page("Fit")
    still.app_state.study_vm.open("r1")
    still.app_state.study_vm.cancel()
    page.idle_queue.finish()
    assert "the gains K and the offset k of the sensor" in page.empty.text()
    assert page.empty.toolTip().startswith("b = K m − k")


def test_start_says_what_a_closing_check_is(still):
    still.open_page("Start")
    still.page("Start").refresh()
    still.app_state.quick_worker.answer(LastClosingCheck, None)
    assert "has to read the same there" in still.page("Start").facts["closing"][1].text()
