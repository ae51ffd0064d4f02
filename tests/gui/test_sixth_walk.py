"""What a stranger saw who walked through the window once more."""

from __future__ import annotations

import numpy as np

from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.widgets.hold_button import HoldButton
from labcal.record.stream import Prompt

UP = {"body_from_cage": np.eye(3).tolist(), "axis_cage": [0.0, 0.0, 1.0]}
STANDS = Prompt(1.0, "mounting-stands", "Is the DUT still mounted?", ("yes", "no"), True, UP)


def asked(window, prompt=STANDS):
    """The card of `prompt` in a run that goes on."""
    window.open_page("Run")
    window.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    window.app_state.bench_worker.items.emit((prompt,))
    return window.page("Run").live.prompt


def test_beside_still_mounted_it_is_said_what_no_means_and_each_answer_has_a_key(still):
    card = asked(still)
    assert "No: mount it again first." in card.hint.text()
    assert "turns that were finished stay" in card.hint.text()
    assert [made.text() for made in card.choices.values()] == ["Yes   F8", "No   F7"]
    assert all(isinstance(made, HoldButton) for made in card.choices.values())
