"""What to run: what it needs, how long it takes, its form, and what keeps Start waiting."""

import numpy as np
import pytest
from PySide6.QtCore import Qt

from labcal.gui.bench_verbs import plan
from labcal.gui.wire import Fault, pack


@pytest.fixture
def choose(still):
    return still.page("Run").choose


def test_every_procedure_says_what_it_needs_and_how_long_it_takes(choose):
    for row in range(choose.list.count()):
        choose.list.setCurrentRow(row)
        assert "Needs: " in choose.needs.text(), choose.list.item(row).text()
        assert "min of measuring" in choose.needs.text()


def test_a_setting_out_of_range_is_named_and_start_waits(choose):
    choose.choose("preflight")
    assert choose.start.isEnabled()
    choose.form.set_text("inclination_deg", "80")
    assert not choose.start.isEnabled()
    assert "35 to 65" in choose.form._complaints["inclination_deg"].text()


def test_no_operator_no_run(still, choose):
    still.desk.who(operator="")
    assert not choose.start.isEnabled()
    assert "operator" in choose.objection.text()


def told_by_the_loop(procedure):
    """A loop's answer that is not sure, as the worker gives it."""
    t = np.linspace(0.0, 100.0, 50)
    effect = {"effect": "offset-current", "channels": ["i_eps"], "why": "it falls", "improvement_ci95_nT": [5.0, 9.0],
              "holdout_rms_before_nT": 50.0, "holdout_rms_after_nT": 30.0,
              "rivals": [{"effect": "offset-drift", "channels": [], "holdout_rms_after_nT": 31.0}]}  # fmt: skip
    rms = {"train_rms_nT": 50.0, "holdout_rms_nT": 50.0}
    proposed = {"why": "drift goes on", "do": "turn back", "procedure": procedure}
    loop = {"verdict": "ambiguous", "summary": "Two causes do as well.", "before": rms, "after": rms,
            "noise_floor_nT": 27.0, "noise_floor_source": "declared", "set_aside": {}, "accepted": [effect],
            "rejected": [], "next_experiment": proposed}  # fmt: skip
    against = {"time  s": pack(t), "i_eps  A": pack(t)}
    residual = pack(np.ones((50, 3)))
    return {"loop": loop, "remarks": [], "draft": "d.json", "before": residual, "after": residual, "against": against}


def test_what_would_tell_them_apart_is_planned_in_words_and_started_by_a_click(qtbot, still):
    still.open_page("Loop")
    page, study = still.page("Loop"), still.desk.study_vm
    study.open("r1")
    study.close_loop()
    still.desk.study.answer("loop", told_by_the_loop("reverse"))
    qtbot.mouseClick(page.next, Qt.MouseButton.LeftButton)
    choose, worker = still.page("Run").choose, still.desk.bench_worker
    assert still.stack.currentWidget() is still.later["Run"]
    ((do, _, _, what),) = worker.asked
    assert (do, what["procedure"], what["given"]) == ("plan", "reverse", {})
    assert not choose.start.isEnabled()  # nothing moves before the plan is read
    worker.answer("plan", plan(None, **what))
    said = choose.plan.text()
    assert choose.plan.isVisible()
    for words in ("largest field at the DUT 50.0 µT", "turns between", "°/s", "°C", " min,", "a person: Mount the DUT"):
        assert words in said
    qtbot.mouseClick(choose.start, Qt.MouseButton.LeftButton)
    assert [(one[0], one[3]["procedure"]) for one in worker.asked] == [("run", "reverse")]


def test_a_plan_is_that_of_its_settings_and_one_beyond_a_limit_is_refused_in_words(qtbot, still, choose):
    choose.choose("reverse")
    qtbot.mouseClick(choose.show_plan, Qt.MouseButton.LeftButton)
    _, late, _, _ = still.desk.bench_worker.asked[-1]
    choose.form.set_text("rate_deg_per_s", "25")
    late(["the plan of other settings"])
    assert not choose.plan.text()
    qtbot.mouseClick(choose.show_plan, Qt.MouseButton.LeftButton)
    _, _, failed, what = still.desk.bench_worker.asked[-1]
    assert what["given"] == {"rate_deg_per_s": "25"}
    failed(Fault("input", "25 deg/s is beyond the DUT's limit.", "Nothing was moved."))
    assert choose.plan.text() == "✕ 25 deg/s is beyond the DUT's limit. Nothing was moved."
