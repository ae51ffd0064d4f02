"""What is handed out with a doubt about its cause says so wherever it is named, in amber."""

from dataclasses import replace

import pytest
from test_certificate_steps import page as page
from test_certificate_steps import told
from test_path import RUN, calibration
from test_seventh_walk import DOUBTED, standing

from labcal.gui.ipc.messages import ListCalibrations, ListRuns
from labcal.gui.viewmodels.signing import handed_out_as, handed_out_word, steps

RELEASED = replace(standing(calibration(), "released"), approvers=("jdoe@lab",))
DOUBTFUL = replace(RELEASED, effects=(DOUBTED,))
LEFT = replace(RELEASED, unexplained="Unexplained by the closed loop: 9.0 nT are left.")
HELD = replace(standing(calibration(signed=False), "unsigned"), not_measured=("K_xy", "K_yx"))
PROVISIONAL = standing(calibration(provisional=True), "provisional")


@pytest.mark.parametrize(
    ("one", "word", "as_what"),
    [
        (RELEASED, "✓ handed out", ""),
        (DOUBTFUL, "▲ handed out · released · AMBIGUOUS", "AMBIGUOUS"),
        (PROVISIONAL, "▲ handed out · provisional", "PROVISIONAL"),
        (LEFT, "▲ handed out · released · UNEXPLAINED", "UNEXPLAINED"),
        (
            replace(PROVISIONAL, effects=(DOUBTED,)),
            "▲ handed out · provisional · AMBIGUOUS",
            "PROVISIONAL, AMBIGUOUS",
        ),
    ],
)
def test_as_what_it_left_the_lab_is_in_its_word(one, word, as_what):
    assert (handed_out_word(one), handed_out_as(one)) == (word, as_what)


def test_the_certificate_page_says_it_in_amber_before_it_goes_and_after(page):
    window = page.window()
    page._app_state.path.take_runs((replace(RUN, verdict="explained"),))
    page.refresh()
    told(page, DOUBTFUL, "a.smith")
    assert window.next.text() == "Next: Hand it out, as AMBIGUOUS"
    assert (page.paper.words.text(), page.paper.words.property("state")) == (
        "As AMBIGUOUS: why is said above.",
        "warning",
    )
    page.paper.handed_out.emit(DOUBTFUL, "copy.json")
    assert page.paper.words.text() == "Handed out as AMBIGUOUS. Next: another DUT."
    assert page.paper.words.property("state") == "warning"
    page.refresh()
    told(page, RELEASED, "a.smith")
    assert page.paper.words.property("state") == ""


def test_what_its_run_did_not_measure_nobody_approves_and_next_leads_to_the_loop(page):
    window = page.window()
    page._app_state.path.take_runs((replace(RUN, verdict="unexplained"),))
    page.refresh()
    told(page, HELD, "a.smith")
    key, approve, *_ = steps(HELD, ("a.smith",), "J. Doe")
    assert (key.mark, approve.mark) == ("done", "never")
    assert not page.steps.approve.isEnabled()
    assert page.doubt.text() == "Its run did not measure K_xy, K_yx: they were held as they stand."
    assert window.next.text() == "Next: See what is not known"


def test_the_history_says_it_in_amber(new_window):
    new_window.open_page("History")
    history, worker, path = new_window.page("History"), new_window.app_state.quick_worker, new_window.app_state.path
    path.take_handed_out(DOUBTFUL)
    worker.answer(ListRuns, (replace(RUN, verdict="explained"),))
    worker.answer(ListCalibrations, (DOUBTFUL,))
    assert history.table.text(0, 5).endswith("▲ handed out · released · AMBIGUOUS")

    def ink(column):
        return history.table.item(0, column).foreground().color().name()

    assert (ink(5), ink(0)) == (new_window.theme.warning, new_window.theme.text)
    new_window.theme_switch.click()
    new_window.style_queue.finish()
    history._idle_queue.finish()
    assert (ink(5), ink(0)) == (new_window.theme.warning, new_window.theme.text)
