"""What is said of the coils in few words keeps its time whole, and says that who said so is silent now."""

import time

import pytest
from PySide6.QtWidgets import QApplication, QLabel
from test_few_lines import show
from test_hands_in_the_cage import lab

from labcal.bench.coils import state
from labcal.gui.viewmodels.hands_now import hands_of
from labcal.gui.viewmodels.in_brief import in_brief
from labcal.gui.viewmodels.lab import LabState
from labcal.gui.viewmodels.lab_now import LabNow, lab_now
from labcal.gui.widgets.few_lines import said_shorter

WAS = f"{state.WAS_ZERO_BY_WORD} at 18:02:20 (2 s ago)"
ROLES = {f"supply_{axis}": f"coil-{axis}" for axis in "xyz"}


@pytest.mark.parametrize(
    ("whole", "brief"),
    [
        (f"{WAS}; not watched since", WAS),
        ("NOT at zero by the reference: it sees 3 nT", "NOT at zero by the reference"),
        ("bobines NON confirmées à zéro : x", "bobines NON confirmées à zéro"),
        ("bobines NON confirmées à zéro\u00a0: x", "bobines NON confirmées à zéro"),
        ("coils at zero", "coils at zero"),
    ],
)
def test_in_brief_no_time_is_cut(whole, brief):
    assert in_brief(whole) == brief


def test_no_form_of_what_is_said_ends_within_a_time():
    for _, coils in said_shorter("the platform turns; and so on", f"◌ {WAS}; not watched since"):
        assert not coils.endswith("18")


@pytest.mark.parametrize("age_s", [0.0, 5.0])
def test_a_zero_of_supplies_that_are_silent_says_when_and_that_they_are(age_s):
    now = time.monotonic()
    known = lab(faulty=tuple(ROLES))
    words = lab_now(known, now, ROLES, now + age_s).coil_words
    assert words.startswith(f"{state.WAS_ZERO_BY_WORD} at ")
    assert in_brief(words).endswith("s ago), silent since")
    assert hands_of(lab_now(known, now, ROLES, now + age_s))[1] == "bad"


@pytest.mark.parametrize("size", [(1360, 860), (1024, 700)], ids="{0[0]}".format)
def test_what_a_yes_rests_on_is_never_counted(new_window, rest, size):
    side = rest(new_window).side
    new_window.resize(*size)
    QApplication.processEvents()
    new_window.app_state.age_timer.stop()
    now = LabNow(
        coil_words=f"{state.BY_WORD}: the reference agreed when it was last looked at, 12 s ago",
        platform_words="platform stands at 69°",
    )
    show(side, LabState(now=now, hands=hands_of(now)))
    assert "the reference agreed when it was last looked at, 12 s ago" in QLabel.text(side.hands)
