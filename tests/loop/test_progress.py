"""What a run says while it is weighed: how long it still takes, and what is known so far."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.loop import close


def test_a_long_run_says_how_long_and_what_is_known_so_far(
    making: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(close, "LONG_s", 0.0)
    rows, segments = making.recorded(seconds=30.0)
    rows["dut"] = rows["dut"] + 200 * rows["i_load"][:, None] * np.array([1.0, -0.7, 0.5])
    said: list[str] = []
    close.close_loop(session.load_run(str(making.written(tmp_path, rows, segments))), said.append)
    warned, proving = (next(text for text in said if text.startswith(word)) for word in ("this run", "holding"))
    assert "s more and may be stopped; so far offset-current (i_load), not proven yet" in warned
    before, after = (float(word) for word in proving.split(": ")[1].split(" times")[0].split(" to "))
    assert before > 2
    assert 0.8 < after < 1.2


def test_where_nothing_is_there_it_says_so(making: ModuleType, tmp_path: Path) -> None:
    rows, segments = making.recorded(seconds=30.0)
    said: list[str] = []
    close.close_loop(session.load_run(str(making.written(tmp_path, rows, segments))), said.append)
    assert said[-1] == "holding out blocks of time; so far nothing has the evidence of a name"
    assert not any("may be stopped" in text for text in said)
