"""A cause is named by what happens, in the window's language; its id stands small beside it, and is what files hold."""

from dataclasses import replace
from itertools import pairwise

import pytest
from geometry import faults
from test_choose import loop_page, told_by_the_loop
from test_path import calibration
from test_tenth_walk import in_language as in_language

from labcal.gui.ipc.file_commands import calibrations
from labcal.gui.ipc.messages import ListCalibrations
from labcal.gui.theming.theme import LIGHT
from labcal.gui.viewmodels.calibration_rows import cause_rows
from labcal.gui.viewmodels.cause_words import in_plain_words, with_id
from labcal.gui.viewmodels.loop_causes import CAUSE
from labcal.gui.viewmodels.loop_words import called, said_plainly
from labcal.gui.viewmodels.signing import doubts
from labcal.gui.widgets.causes_table import ID, VERDICT
from labcal.model.effects import phrases
from labcal.model.records import EffectRecord, Parameter, Rival

CURRENT = EffectRecord("offset-current", ("i_eps",), {}, "sensor", (Parameter("c_x", 1.0, 0.1, "nT/A"),))
REJECTED = tuple(replace(CURRENT, effect=name, why="too little evidence: 1 nats, 6 needed") for name in phrases())


def told():
    return replace(told_by_the_loop("reverse"), phrases=phrases())


def test_what_happens_comes_first_and_the_id_beside_it():
    assert in_plain_words(CURRENT, phrases()) == "the offset changes with a current (i_eps)"
    assert with_id(CURRENT, phrases()) == "the offset changes with a current (i_eps) – offset-current"


def test_a_cause_without_words_is_called_by_its_id_once():
    assert with_id(Rival("of-a-package", ("u",), 1.0), phrases()) == "of-a-package (u)"
    assert with_id(Rival("of-a-package", (), 1.0), {"of-a-package": "of-a-package"}) == "of-a-package"


def test_the_words_of_a_package_that_no_language_has_are_said_as_they_are(in_language):
    in_language("de")
    assert in_plain_words(Rival("hum", (), 1.0), {"hum": "the transformer hums"}) == "the transformer hums"


@pytest.mark.parametrize(
    ("code", "said"),
    [("de", "der Offset ändert sich mit einem Strom"), ("fr", "le décalage change avec un courant")],
)
def test_every_cause_of_ours_is_said_in_the_language_of_the_window(in_language, code, said):
    in_language(code)
    assert in_plain_words(CURRENT, phrases()) == f"{said} (i_eps)"
    same = {id for id, words in phrases().items() if in_plain_words(Rival(id, (), 1.0), phrases()) == words}
    assert same == {id for id in phrases() if id.startswith("example-")}


def test_the_verdict_says_it_and_what_files_call_it():
    loop = replace(told(), verdict="explained")
    assert "the offset changes with a current (i_eps)" in said_plainly(loop)
    assert "offset-current" not in said_plainly(loop)
    assert called(loop) == "in files and commands: offset-current"
    assert called(told_by_the_loop("reverse")) == ""


def test_who_signs_reads_it_and_the_result_sheet_has_it():
    one = replace(calibration(), effects=(replace(CURRENT, provisional=True, rivals=(Rival("lag", (), 1.0),)),))
    assert doubts(replace(one, phrases=phrases())) == (
        "AMBIGUOUS, the cause is not certain: the offset changes with a current (i_eps). "
        "It may be another: the readings come later than the field."
    )
    assert cause_rows(replace(one, phrases=phrases()))[0][0].text == "the offset changes with a current (i_eps) c_x"


def test_a_worker_says_them_with_its_answers(drafted, monkeypatch):
    monkeypatch.setenv("LABCAL_HOME", str(drafted))
    assert calibrations(None, ListCalibrations())[0].phrases == phrases()


@pytest.fixture
def traced(still):
    """The Loop page with every cause that there is."""
    return loop_page(still, replace(told(), rejected=REJECTED))


def test_the_table_has_the_words_and_beside_them_the_id_in_small_letters(traced, qtbot, patience):
    table = traced.page("Loop").others
    qtbot.waitUntil(lambda: table.rowCount() == len(REJECTED) + 2, timeout=patience)
    assert (table.text(0, 0), table.text(0, ID)) == ("the offset changes with a current (i_eps)", "offset-current")
    assert [table.horizontalHeader().visualIndex(column) for column in (VERDICT, CAUSE, ID)] == [0, 1, 2]
    small, usual = table.item(0, ID).font(), table.font()
    assert 0 < small.pixelSize() < (usual.pixelSize() if usual.pixelSize() > 0 else table.fontInfo().pixelSize())
    table.show_loop(told_by_the_loop("reverse"), LIGHT)
    assert table.isColumnHidden(ID)


@pytest.mark.parametrize("size", [(1024, 700), (1280, 800), (1920, 1080)], ids=str)
def test_no_card_of_the_page_lies_over_another_however_many_causes_there_are(traced, qtbot, patience, size):
    before, page = traced.size(), traced.page("Loop")
    try:
        traced.resize(*size)
        qtbot.waitUntil(lambda: page.others.rowCount() == len(REJECTED) + 2, timeout=patience)
        qtbot.wait(100)
        assert faults(traced) == []
        rows = [page.story.layout().itemAt(n).geometry() for n in range(page.story.layout().count())]
        assert [(one, after) for one, after in pairwise(rows) if one.bottom() >= after.top()] == []
    finally:
        traced.resize(before)
