"""One thing to do at a time: a question is answered on its own card, and Next does not ask beside it."""

import pytest
from test_hands_in_the_cage import READY, says, send, stands
from test_hands_in_the_cage import running as running
from test_one_way_on import blue
from test_twelfth_walk import real_lines

from labcal.record.stream import Prompt

MOUNT = Prompt(1.0, "mount-x", "Mount the DUT with body X up along the platform axis.", ("mounted",))


@pytest.fixture
def on_its_page(running):
    real_lines(running)
    running.app_state.run.virtual_time = False
    running.open_page("Run")
    return running


@pytest.mark.parametrize("asked", [READY, MOUNT], ids=["hands off", "mount"])
def test_next_is_not_blue_while_the_question_in_sight_takes_no_answer_yet(on_its_page, qtbot, asked):
    card = on_its_page.page("Run").live.prompt
    send(on_its_page, asked)
    says(on_its_page, platform=stands())
    assert not card.alive  # it has to be seen for a moment
    assert on_its_page.app_state.path.may_answer()
    qtbot.wait(20)
    assert blue(on_its_page) == []
    qtbot.waitUntil(lambda: card.alive, timeout=10_000)
    assert len(blue(on_its_page)) == 1
    assert on_its_page.next.text() not in blue(on_its_page)


def test_next_is_blue_where_the_question_is_on_another_page(on_its_page, qtbot):
    send(on_its_page, READY)
    says(on_its_page, platform=stands())
    on_its_page.open_page("History")
    qtbot.waitUntil(lambda: blue(on_its_page) == [on_its_page.next.text()], timeout=10_000)
