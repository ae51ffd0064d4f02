"""A page that shows one run says what is being computed of another one, and leads there."""

from dataclasses import replace

import numpy as np
import pytest
from test_path import RUN

from labcal.gui.ipc.answers import Look
from labcal.gui.ipc.messages import ListMethods, LookAt
from labcal.gui.ipc.wire import Fault

OTHER = replace(RUN, run_id="r8", dut_serial="EM-08")


def looked_at(window, run, dut):
    window.app_state.one_dut.open(run)
    window.app_state.fit_worker.answer(LookAt, Look(run, dut, 1, np.zeros((1, 3)), {}))
    if window.app_state.fit_worker.commands(ListMethods):
        window.app_state.fit_worker.answer(ListMethods, ("ml",))


@pytest.fixture
def computing(still):
    """The run of EM-07 is being worked at, and that of EM-08 is opened."""
    still.app_state.path.take_runs((OTHER, RUN))
    looked_at(still, "r1", "EM-07")
    return still


@pytest.mark.parametrize(("page", "said"), [("Loop", "Being traced: EM-07"), ("Fit", "Being fitted: EM-07")])
def test_of_whose_run_something_is_computed_stands_on_the_page_of_another(computing, page, said):
    study, lines = computing.app_state.study_vm, [computing.page(name).elsewhere for name in ("Fit", "Loop")]
    computing.open_page(page)
    study.begin(page)
    assert all(line.isHidden() for line in lines)  # the page itself says it of the run that it shows
    computing.app_state.one_dut.open("r8")
    assert all(line.words.text().startswith(said) and not line.isHidden() for line in lines)
    computing.open_page("Fit" if page == "Loop" else "Loop")
    lines[0].show_it.click()
    assert (study.run, computing.page_shown()) == ("r1", page)
    assert all(line.isHidden() for line in lines)


def test_once_it_has_ended_nothing_is_said_of_it(computing):
    study, line = computing.app_state.study_vm, computing.page("Loop").elsewhere
    study.begin("Loop")
    computing.app_state.one_dut.open("r8")
    assert not line.isHidden()
    computing.app_state.fit_worker.asked[0].failed(Fault("ended", "killed"))
    for worker in (computing.app_state.fit_worker, computing.app_state.second_fit_worker):
        for asked in list(worker.asked):
            asked.failed(Fault("ended", "killed"))
    assert line.isHidden()
