"""The loop on runs that a simulator of other hands made, with their truth."""

import json
from pathlib import Path

import numpy as np
import pytest

from labcal import session


def _truth(folder: Path) -> dict[str, object]:
    content: dict[str, object] = json.loads((folder / "truth.json").read_text())
    return content


OF_EACH_VERDICT = ("p01", "p03", "p07")  # p08, ambiguous: in test_close_loop_command.py


@pytest.mark.parametrize(
    "name", [*OF_EACH_VERDICT, *(pytest.param(f"p0{n}", marks=pytest.mark.slow) for n in (2, 4, 5, 6, 8, 9))]
)
def test_a_practice_run_comes_out_as_it_is(shared: Path, tmp_path: Path, name: str) -> None:
    folder = shared / "data" / "practice" / name
    truth = _truth(folder)
    closed = session.close_loop(str(folder / "bundle"), tmp_path / "cal.json")
    named = {effect.effect for effect in closed.accepted}
    assert closed.verdict in truth["verdicts"]
    assert all(named & set(cause) for cause in truth["cause"])
    assert all(closed.after.train_rms_nT <= 1.03 * (e.holdout_rms_after_nT or np.inf) for e in closed.accepted[-1:])
    assert named <= {e for cause in truth["cause"] for e in cause} | set(truth["also_fine"])
