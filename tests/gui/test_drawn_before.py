"""What a run drew before it was gone on with is drawn again, pale, also where another window had begun it."""

from pathlib import Path

import numpy as np

from labcal.gui.ipc.messages import ResumeRun
from labcal.gui.ipc.record_messages import TellTurned
from labcal.gui.viewmodels.drawn import Drawn
from labcal.record.turned import TurnBefore
from labcal.session import run
from labcal.session.turned import MOST, turned

BENCH = Path(__file__).parents[2] / "examples" / "simulated.toml"
BEFORE = (TurnBefore("x+20uT-nominal", np.array([[1.0, 2.0, 3.0]])), TurnBefore("x-20uT-nominal", np.ones((2, 3))))


def test_the_turns_of_a_run_are_read_from_its_record_thinned(monkeypatch, tmp_path):
    monkeypatch.setenv("LABCAL_HOME", str(tmp_path))
    ended = run("rate-sweep", BENCH, {"rates_deg_per_s": "12", "zero_s": "2"}, dut="EM-07", seed=3)
    there = turned(ended.run_id)
    assert [one.segment for one in there] == ["z-12dps-forth", "z-12dps-back"]
    for one in there:
        assert 100 < len(one.field_nT) <= MOST
        assert 30e3 < np.linalg.norm(one.field_nT, axis=1).mean() < 70e3  # nominal nT, not counts


def test_who_goes_on_with_a_run_of_another_window_sees_its_turns_pale(still, monkeypatch):
    still.app_state.resume("r1", "preflight", "EM-07")
    assert still.app_state.bench_worker.commands(ResumeRun)
    still.app_state.quick_worker.answer(TellTurned, BEFORE)
    drawn, live = still.app_state.run.drawn, still.page("Run").live
    assert (len(drawn.rows()), len(drawn.rows(earlier=True))) == (0, 3)
    seen = []
    monkeypatch.setattr(live.loci, "show_field", lambda rows, cloud=0: seen.append((len(rows), cloud)))
    live.pictures.draw_loci()
    assert seen == [(0, 0), (3, 1)]


def test_what_was_begun_again_meanwhile_is_not_drawn_as_it_was_before():
    drawn = Drawn()
    drawn.begin("x+20uT-nominal")
    drawn.take_earlier(BEFORE)
    assert list(drawn.earlier) == ["x-20uT-nominal"]
    assert len(drawn.gone_on_with().earlier) == 2
