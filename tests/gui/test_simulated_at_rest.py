"""After a run in the simulated lab its reference is read no more: one sentence says so, everywhere and at once."""

import time
from dataclasses import replace

import pytest
from test_hands_in_the_cage import lab, stands

from labcal.bench.coils.state import NOT_READ_ON, Witness
from labcal.gui.viewmodels.hands_now import hands_of
from labcal.gui.viewmodels.known_lab import KnownLab
from labcal.gui.viewmodels.lab_now import WATCHED_S
from labcal.gui.viewmodels.off_headline import off_headline


def at(window, age_s):
    """The simulated lab so long after its reference agreed; the supplies are read on."""
    now, kept = time.monotonic(), KnownLab()
    agreed = Witness("agrees", "", (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0, 2000.0, now - age_s)
    kept.take(replace(lab(platform=stands()), reference=agreed), now)
    return kept.now(replace(window.app_state.facts, virtual_time=True), now, driven=False)


def test_hands_read_two_sentences_at_most(still):
    said = [hands_of(at(still, 0.25 * n)) for n in range(80)]
    assert len(dict.fromkeys(said)) == 2
    assert NOT_READ_ON in said[-1][0]


@pytest.mark.parametrize("age_s", [3.5, WATCHED_S + 1.5, 21.0])
def test_the_headline_gives_no_age_to_what_is_not_read(still, age_s):
    assert "agreed" not in off_headline(at(still, age_s))[0]
