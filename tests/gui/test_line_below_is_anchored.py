"""What happens begins at one place in the line below, whatever is said at its left and whatever Next says."""

import pytest
from PySide6.QtWidgets import QApplication


def waits_at(window, message, waiting, following):
    window.app_state.lab.update(message=message, said_at="12:00:01", waiting=waiting)
    window.say_next(following)
    QApplication.processEvents()
    assert window.waiting.width() >= window.waiting.sizeHint().width()
    return window.waiting.mapTo(window, window.waiting.rect().topLeft()).x()


@pytest.mark.parametrize("size", [(1024, 700), (1280, 800), (1920, 1080)], ids=str)
def test_it_does_not_move_with_the_words_around_it(same_window, size):
    same_window.resize(*size)
    same_window.show()
    messages, happens, following = ("", "short", "long " * 60), ("paused", "your turn"), ("Go", "Answer the question")
    places = {
        waits_at(same_window, *said) for said in ((m, w, n) for m in messages for w in happens for n in following)
    }
    assert len(places) == 1
    waits_at(same_window, "long " * 60, "", "Go")
    assert same_window.message.width() > same_window.width() / 2  # of what does not happen there is no place
