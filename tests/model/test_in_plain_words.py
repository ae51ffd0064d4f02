"""What an effect is called by who looks for a cause: words of its own file, and its id where it has none."""

from dataclasses import replace

import pytest

from labcal.certificate.report.calibration import named
from labcal.gui.translations.causes import PHRASES
from labcal.model.effects import families, phrases, plainly
from labcal.model.records import EffectRecord, Rival

OURS = [family for family in families() if family.kernel.__module__.startswith("labcal.")]


@pytest.mark.parametrize("family", OURS, ids=lambda family: family.id)
def test_each_of_ours_says_in_words_what_happens(family):
    assert family.phrase == family.phrase.strip(" .")
    assert " " in family.phrase
    assert family.phrase != family.id


def test_no_two_say_the_same():
    said = [family.phrase for family in OURS]
    assert len(set(said)) == len(said)


def test_the_window_knows_each_of_these_words_and_no_other():
    assert {str(one) for one in PHRASES} == {family.phrase for family in OURS}


def test_who_gives_no_words_is_called_by_its_id():
    assert replace(OURS[0], phrase="").plainly() == OURS[0].id
    assert plainly("of-a-package-that-is-not-there") == "of-a-package-that-is-not-there"


def test_a_report_says_it_in_words_and_names_the_id_beside_them():
    one = EffectRecord("gain-temperature", ("T_box",), {}, "sensor", ())
    assert named(one) == f"{phrases()['gain-temperature']} · gain-temperature · T_box"
    assert named(Rival("of-a-package", ("u",), 1.0)) == "of-a-package · u"
