"""However much is said of hands and coils, the instruments below stay in sight, and the gravest reason is whole."""

import itertools

import pytest
from PySide6.QtWidgets import QApplication, QLabel
from test_nothing_is_cut import other_language as other_language

from labcal.bench.coils import state
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.hands_now import MAY, hands_of
from labcal.gui.viewmodels.lab import LabState
from labcal.gui.viewmodels.lab_now import LabNow
from labcal.gui.viewmodels.left_unconfirmed import WORDS

SEEN = "98.9 µT beside what was expected, which is more than 2.0 µT"
COILS = (
    state.AT_ZERO,
    f"{state.BY_WORD}: {state.NOT_ASKED}",
    f"{state.NOT_BY_REFERENCE}: {SEEN}. {state.OPEN_THEM}",
    f"{state.NOT_CONFIRMED}; {state.NOT_BY_REFERENCE}: {SEEN}. {state.OPEN_THEM}",
    state.NOT_CONFIRMED,
    state.NOT_SINCE,
    f"{state.ON}: x +1.5200 A, y −0.4000 A, z +0.4000 A, read back 12 s ago",
    f"{state.WAS_ZERO} at 17:25:28 (12 s ago); not watched since",
    state.NOT_YET,
)
PLATFORM = ("platform stands at 69°", "platform turns, at 69°", state.MAY_TURN)
MORE = (None, (1e3, 4.3e4, -2e3))
LEFT = ("", "; ".join(translated(words).format("psu-x, psu-y", "17:25:28") for words in WORDS.values()))
EARLIER = ("", "a supply of an earlier session is not at zero: psu-x, psu-y, psu-z")


def every_state():
    for coils, stage, more, left, earlier, stop in itertools.product(
        COILS, PLATFORM, MORE, LEFT, EARLIER, (False, True)
    ):
        now = LabNow(
            coil_words=coils,
            platform_words=stage,
            field_more_nT=more,
            field_more_old_s=12,
            closed_with=left,
            earlier_on=earlier,
            stop_unseen=stop,
        )
        words, mark = hands_of(now)
        yield LabState(now=now, hands=(words, mark), keep_off=("", "") if mark in MAY else ("✕ HANDS OFF", "bad"))


def show(side, lab):
    """Coils, then hands."""
    for part in side.parts()[:2]:
        part.show(lab)


def drawn_lines(side):
    """Of each of the four that is in sight, as high as it was laid out."""
    four = [one for one in (side.keep_off, side.may_go_in, side.hands, side.zero_words) if one.isVisible()]
    return sum(round(one.height() / one.fontMetrics().lineSpacing()) for one in four)


LARGE, LITTLE = (1360, 860), (1024, 700)
SHORT = (("en", LARGE), ("de", LARGE), ("fr", LITTLE))  # each language and each size


@pytest.mark.parametrize(
    ("other_language", "size"),
    [*SHORT, *(pytest.param(*one, marks=pytest.mark.slow) for one in (("en", LITTLE), ("de", LITTLE), ("fr", LARGE)))],
    ids=str,
    indirect=["other_language"],
)
def test_hands_and_coils_take_seven_lines_at_most_and_the_gravest_reason_is_whole(
    other_language, same_window, rest, size
):
    side = rest(same_window).side
    same_window.resize(*size)
    QApplication.processEvents()
    same_window.app_state.age_timer.stop()
    found = []
    for lab in every_state():
        show(side, lab)
        shown, whole = QLabel.text(side.hands), lab.hands[0]
        gravest = whole.partition(":")[2].strip().partition("; ")[0] or whole
        if (taken := drawn_lines(side)) > 7:
            found.append(f"{taken} lines: {side.hands.text()} / {QLabel.text(side.zero_words)}")
        if gravest not in shown:
            found.append(f"{gravest!r} is not in {shown!r}")
        if shown not in whole and side.hands.toolTip() != whole:
            found.append(f"{whole!r} stands in no tip")
    assert not found, f"{len(found)}:\n" + "\n".join(found[:8])


@pytest.mark.parametrize("told", [f"{state.NOT_BY_REFERENCE}: {SEEN}. {state.OPEN_THEM}"])
def test_what_to_do_stays_where_how_it_was_found_goes_into_the_tip(same_window, rest, told):
    side = rest(same_window).side
    same_window.resize(1360, 860)
    QApplication.processEvents()
    now = LabNow(coil_words=told, platform_words="platform stands at 69°")
    show(side, LabState(now=now, hands=hands_of(now), keep_off=("✕ HANDS OFF", "bad")))
    assert QLabel.text(side.zero_words) == state.OPEN_THEM
    assert side.zero_words.toolTip() == side.zero_words.text() == f"✕ {told}"
