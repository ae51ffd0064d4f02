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


def test_a_procedure_that_does_not_load_is_listed_with_its_fault_and_is_not_chosen(choose):
    choose._known([{"name": "other", "fault": "other.py, line 3: it exits"}])
    broken = choose.list.item(choose.list.count() - 1)
    assert (broken.text(), broken.toolTip()) == ("✕ other", "other.py, line 3: it exits")
    assert not broken.flags() & Qt.ItemFlag.ItemIsSelectable


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


def looked_at(run, dut="EM-07"):
    """What the worker says of a run."""
    return {"run_id": run, "dut": dut, "n_samples": 50, "against": {}, "before": pack(np.ones((50, 3)))}


@pytest.fixture
def undecided(still):
    """The Loop page on a run whose loop has two causes that do as well."""
    still.open_page("Loop")
    still.page("Loop")
    study, worker = still.desk.study_vm, still.desk.study
    study.open("r1")
    worker.answer("look", looked_at("r1"))
    study.close_loop()
    worker.answer("loop", told_by_the_loop("reverse"))
    return still


def test_every_cause_is_named_whole_with_its_reason(qtbot, undecided, patience):
    page = undecided.page("Loop")
    qtbot.waitUntil(lambda: page.others.count() == 2, timeout=patience)
    texts = [page.others.item(n).text() for n in range(2)]
    assert texts == [
        "✓ offset-current (i_eps): named\nit falls",
        "? offset-drift: a rival\ndoes about as well as offset-current (i_eps)",
    ]
    for n in range(2):
        item = page.others.visualItemRect(page.others.item(n))
        room = page.others.fontMetrics().boundingRect(
            item.adjusted(0, 0, 0, 10_000), Qt.TextFlag.TextWordWrap, texts[n]
        )
        assert item.height() >= room.height(), "a reason is cut off"
        assert page.others.item(n).toolTip() == texts[n]
    page.others.setCurrentRow(1)
    assert page.change_why.text() == "does about as well as offset-current (i_eps)"


def test_what_would_tell_causes_apart_is_not_measured_on_another_dut(qtbot, undecided):
    page = undecided.page("Loop")
    undecided.desk.who(dut="EM-08")
    qtbot.mouseClick(page.next, Qt.MouseButton.LeftButton)
    assert "This run is of EM-07; the DUT at the top is EM-08" in page.fault.text.text()
    assert undecided.desk.bench_worker.asked == []


def test_what_would_tell_them_apart_is_planned_in_words_started_by_a_click_and_decides_again(qtbot, undecided):
    still, page, study = undecided, undecided.page("Loop"), undecided.desk.study_vm
    qtbot.mouseClick(page.next, Qt.MouseButton.LeftButton)
    choose, worker = still.page("Run").choose, still.desk.bench_worker
    assert still.stack.currentWidget() is still.later["Run"]
    ((do, _, _, what),) = worker.asked
    assert (do, what["procedure"], what["given"]) == ("plan", "reverse", {})
    assert not choose.start.isEnabled()  # nothing moves before the plan is read
    worker.answer("plan", plan(None, **what))
    said = choose.plan.text()
    assert choose.plan.isVisible()
    for words in ("largest field at the DUT 50.0 µT", "turns between", "°/s", "°C", " min,", "asked:\n– Mount the DUT"):
        assert words in said
    assert "added to run r1" in said
    qtbot.mouseClick(choose.start, Qt.MouseButton.LeftButton)
    assert [(one[0], one[3]["procedure"], one[3]["after"]) for one in worker.asked] == [("run", "reverse", "r1")]
    worker.answer("run", {"run_id": "r2", "status": "finished", "fault": None, "failed": []})
    assert still.stack.currentWidget() is still.later["Loop"]
    ((_, _, _, what),) = [one for one in still.desk.study.asked if one[0] == "together"]
    assert what == {"run": "r1", "new": "r2"}
    still.desk.study.answer("together", "r1+r2")
    assert [one[3] for one in still.desk.study.asked if one[0] == "loop"] == [{"run": "r1+r2"}]
    still.desk.study.answer("look", looked_at("r1+r2"))
    still.desk.study.answer("loop", told_by_the_loop("repeat"))
    assert study.run == "r1+r2"
    assert "Added to it: reverse (r2)." in page.unknown.toPlainText()


@pytest.mark.parametrize("status", ["stopped", "failed: aborted by the operator"])
def test_a_run_that_did_not_finish_is_added_to_nothing(qtbot, undecided, status):
    undecided.desk.study_vm.want("reverse")
    undecided.desk.start("reverse", {})
    undecided.desk.bench_worker.answer("run", {"run_id": "r2", "status": status, "fault": None, "failed": []})
    undecided.desk.start("preflight", {})  # another procedure is no answer to the question either
    undecided.desk.bench_worker.answer("run", {"run_id": "r3", "status": "finished", "fault": None, "failed": []})
    assert [one for one in undecided.desk.study.asked if one[0] == "together"] == []


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
