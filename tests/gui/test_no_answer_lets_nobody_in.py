"""Who gives no answer when it is looked at lets no hands in, however short ago it said that all was well."""

import pytest

from labcal.bench.coils.state import CoilReading, Heard, LabState, PlatformReading, Witness
from labcal.gui.viewmodels.hands_now import hands_of
from labcal.gui.viewmodels.lab_now import lab_now
from labcal.gui.viewmodels.watched import as_watched

NOW_S = 1000.0
ROLES = {"supply_x": "coil-x", "supply_y": "coil-y", "supply_z": "coil-z", "stage": "platform", "dut": "dut"}


def seen(lost, *, ago_s=3.0):
    """A lab that was at zero and stood still some seconds ago, and who gives no answer now."""
    read_s = NOW_S - ago_s
    coils = tuple(CoilReading(axis, None, 0.0, True, None, read_s) for axis in "xyz")
    heard = tuple(Heard(name, read_s, "no reply" if name == lost else "") for name in ROLES)
    witness = Witness("agrees", "", (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0, 2000.0, read_s)
    platform = PlatformReading(71.0, moving=False, read_s=read_s)
    return lab_now(LabState(coils, witness, None, heard, platform=platform), read_s, ROLES, NOW_S)


@pytest.mark.parametrize("ago_s", [1.0, 3.0, 4.0])
@pytest.mark.parametrize(
    ("lost", "said"),
    [
        ("stage", "▲ Hands off: platform NOT confirmed at a standstill"),
        ("supply_y", "▲ Hands off: the coils are not being read"),
    ],
)
def test_a_line_that_gives_no_answer_takes_the_green_away_at_once(lost, said, ago_s):
    assert hands_of(seen("", ago_s=ago_s))[0].startswith(("✓ Hands may go in", "● Hands may go in"))
    assert hands_of(seen(lost, ago_s=ago_s)) == (said, "bad")


def test_that_of_the_dut_says_nothing_of_hands():
    assert hands_of(seen("dut", ago_s=1.0))[1] == "good"


def test_the_headline_after_coils_off_keeps_no_sentence_that_nobody_reads_on():
    assert as_watched(seen("")).platform_words == "platform stands at 71°"
    assert "NOT confirmed" in as_watched(seen("stage")).platform_words
