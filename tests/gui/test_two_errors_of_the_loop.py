"""The Loop page has two errors, with declared errors in it and beside them, and two noises: each has its name."""

from dataclasses import replace

import pytest
from test_choose import told_by_the_loop
from test_nothing_is_cut import traced

from labcal.gui.ipc.messages import CloseLoop
from labcal.gui.viewmodels.fit_words import DOUBT, GOOD
from labcal.gui.viewmodels.loop_words import as_a_drop


@pytest.fixture
def page(still, monkeypatch):
    traced(still)
    study, page = still.app_state.study_vm, still.page("Loop")
    found = replace(told_by_the_loop("reverse"), before_nT=157.4, after_nT=33.4, noise_floor_nT=53.7)
    first = replace(found.accepted[0], holdout_rms_before_nT=119.3, holdout_rms_after_nT=15.4)
    page.drawn = []
    monkeypatch.setattr(page.bars, "show_bars", lambda rows, noise_nT: page.drawn.append((rows, noise_nT)))
    study.close_loop()
    still.app_state.fit_worker.answer(CloseLoop, replace(found, accepted=(first, *found.accepted[1:])))
    page._idle_queue.finish()
    return page


def test_the_figures_at_the_top_say_that_declared_errors_are_in_them(page):
    assert page.before_after.text() == "157.4 → 33.4 nT"
    assert page.noise.text() == "rms of the vector, with declared errors; noise alone 53.7 nT rms"
    assert "with the errors in it that the run declares" in page.noise.toolTip()
    assert "the figure on the Fit page is of |b| alone" in page.noise.toolTip()  # why the two are not the same
    assert "noise alone, of one such row: 53.7 nT" in page.summary.text()


def test_bars_begin_where_what_a_cause_takes_off_begins(page):
    (rows, _) = page.drawn[-1]
    assert [row[1] for row in rows[:2]] == [119.3, 15.4]


def test_what_a_cause_takes_off_says_of_which_error():
    assert as_a_drop("the held-out rms falls from 119.3 to 15.4 nT") == (
        "it alone takes 103.9 nT off the held-out rms beside declared errors"
    )


def test_the_noise_of_a_fit_is_that_of_one_reading_of_the_magnitude(still):
    for words in (GOOD, DOUBT):
        assert "of |b| are left over" in str(words)
        assert "its noise" in str(words)
    assert "stated of |b| in one reading" in still.page("Fit").verdict.toolTip()
    assert "on the Loop page is of the whole vector" in still.page("Fit").verdict.toolTip()
