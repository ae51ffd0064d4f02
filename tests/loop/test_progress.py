"""What a run says while it is scored: how long it still takes, and what is known so far."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.loop import close, progress_report


def test_a_long_run_says_how_long_and_what_is_known_so_far(
    making: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(close, "LONG_s", 0.0)
    rows, segments = making.recorded(seconds=30.0)
    rows["dut"] = rows["dut"] + 200 * rows["i_load"][:, None] * np.array([1.0, -0.7, 0.5])
    said: list[str] = []
    close.close_loop(session.load_run(str(making.written(tmp_path, rows, segments))), said.append)
    warned, proving = (next(text for text in said if text.startswith(word)) for word in ("this run", "holding"))
    assert "s more and may be stopped; a cause is in sight, not proven yet" in warned
    before, after = (float(word) for word in proving.split(" falls from ")[1].split(" times")[0].split(" to "))
    assert before > 2
    assert 0.8 < after < 1.2


def test_where_nothing_is_there_it_says_so(making: ModuleType, tmp_path: Path) -> None:
    rows, segments = making.recorded(seconds=30.0)
    said: list[str] = []
    close.close_loop(session.load_run(str(making.written(tmp_path, rows, segments))), said.append)
    assert said[-1] == "holding out blocks of time; so far nothing has the evidence of a name"
    assert not any("may be stopped" in text for text in said)


def _stopped_in(place: str, making: ModuleType, folder: Path, patch: pytest.MonkeyPatch) -> str:
    """What is said last where Ctrl-C comes in a function of the loop."""
    rows, segments = making.recorded(seconds=30.0)
    rows["dut"] = rows["dut"] + 200 * rows["i_load"][:, None] * np.array([1.0, -0.7, 0.5])

    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    patch.setattr(f"labcal.loop.{place}", interrupted)
    said: list[str] = []
    with pytest.raises(KeyboardInterrupt):
        close.close_loop(session.load_run(str(making.written(folder, rows, segments))), said.append)
    return said[-1]


@pytest.mark.parametrize(
    ("place", "doing", "known"),
    [
        ("close.check_data", "fitting the base model", "nothing is known yet"),
        pytest.param(
            "selection.select.likelier_forms", "scoring", "a cause is in sight, not proven yet",
            marks=pytest.mark.slow,
        ),
        ("selection.proof.nested_selection", "scoring the selection on each part", "(offset-current"),
        ("close.final_fit", "scoring what does as well", "a cause is in sight, not proven yet"),
    ],
)  # fmt: skip
def test_stopped_it_tells_what_it_did_and_what_it_knows(
    place: str, doing: str, known: str, making: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    said = _stopped_in(place, making, tmp_path, monkeypatch)
    assert said.startswith(f"stopped while {doing}")
    assert known in said


def test_a_long_search_says_what_it_weighs(making: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(progress_report, "SILENT_s", -1.0)
    rows, segments = making.recorded(seconds=30.0)
    rows["dut"] = rows["dut"] + 200 * rows["i_load"][:, None] * np.array([1.0, -0.7, 0.5])
    said: list[str] = []
    close.close_loop(session.load_run(str(making.written(tmp_path, rows, segments))), said.append)
    assert any(
        text.startswith("scoring every effect beside offset-current (i_load); a cause is in sight") for text in said
    )
    assert any(text.startswith("scoring what does as well beside offset-current (i_load)") for text in said)
