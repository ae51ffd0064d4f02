"""What a run's record tells beside its rows: interruptions and notes, on the run's last page and in the History."""

from dataclasses import replace
from types import SimpleNamespace

from test_path import RUN

from labcal.gui.ipc.answers import Ended
from labcal.gui.ipc.messages import ListRuns, RunProcedure
from labcal.gui.ipc.record_messages import TellRecord
from labcal.gui.pages.run_live import Live
from labcal.gui.translations.sentences import form_of
from labcal.gui.viewmodels.told_words import SO_FAR, interrupted_words, remarked_words
from labcal.record.stream import RESUMED, Event, Step
from labcal.record.told import Interruption, Told
from labcal.session.told import interruptions
from procedures.running_estimate import ASTRAY, RunningEstimate

BROKEN = Interruption("x+20uT-nominal", 240.0, ("zero", "x+20uT-nominal"))
TOLD = Told((BROKEN, Interruption("closure-x", None, ("zero",))), ("lift moved",))


def test_the_last_page_says_what_was_interrupted_how_long_what_again_and_where_notes_are(still):
    still.open_page("Run")
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    worker, told = still.app_state.quick_worker, still.page("Run").live.verdict.told
    still.app_state.bench_worker.answer(RunProcedure, Ended("r1", "finished"))
    worker.answer(TellRecord, TOLD)
    words = told.interrupted.text()
    assert told.interrupted.isVisible()
    assert words.startswith("▲ 2 interruptions: at x +20 µT nominal, for 4 min; at closure x, for nobody knows")
    assert words.endswith("Measured again: offset and first position, x +20 µT nominal.")
    assert told.noted.text() == "Noted, in the run's record (History shows it): lift moved"


def test_no_length_is_said_where_the_clock_of_a_simulated_bench_stood(still):
    still.open_page("Run")
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    worker, told = still.app_state.quick_worker, still.page("Run").live.verdict.told
    still.app_state.bench_worker.answer(RunProcedure, Ended("r1", "finished"))
    worker.answer(TellRecord, Told((Interruption("x+50uT-nominal", None, ("zero",), timed=False),)))
    said = "▲ One interruption: at x +50 µT nominal. Measured again: offset and first position."
    assert told.interrupted.text() == said


SURPRISED = (
    "offsets so far: the filter has diverged, or the sensor has changed: readings lie 28.8 times farther from what it "
    "expects than the noise of the first ones allows"
)


def test_what_the_procedure_noted_is_one_line_with_a_count_the_whole_behind_details(still):
    still.open_page("History")
    worker, page = still.app_state.quick_worker, still.page("History")
    worker.answer(ListRuns, (replace(RUN, run_id="r1"),))
    page.faces.setCurrentIndex(0)  # another test may have left the comparison
    page.table.selectRow(0)
    worker.answer(TellRecord, replace(TOLD, remarks=(SURPRISED,) * 7))
    told = page.told
    assert told.noted.text() == "Noted: lift moved"  # one's own first
    assert told.layout().indexOf(told.noted) < told.layout().indexOf(told.line)
    said = "Estimates on the way: 7 notes; no verdict rests on them."
    assert told.remarked.text() == said  # nothing of a filter stands beside a verdict it has no part in
    once = remarked_words(replace(TOLD, remarks=(SURPRISED,)))
    assert once == "Estimates on the way: 1 note; no verdict rests on it."
    assert not told.all.isVisible()
    told.fold.click()
    assert told.all.isVisible()
    assert told.all.toPlainText() == f"{SURPRISED} (7×)"  # once, with how many
    assert page.trend.plot.height() >= 160
    worker.answer(ListRuns, (replace(RUN, run_id="r1"),))
    worker.answer(TellRecord, replace(TOLD, remarks=(SURPRISED,) * 7))
    assert told.all.isVisible()  # read again, and no fold closes
    page.table.clearSelection()
    assert not told.line.isVisible()


def test_a_window_in_another_language_tells_of_the_run_that_has_ended(new_window):
    run = new_window.app_state.run
    run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    new_window.app_state.bench_worker.answer(RunProcedure, Ended("r1", "finished"))
    here = new_window.page("Run").live
    made = Live(new_window.app_state, new_window.theme, here.loci, here.traces)
    new_window.app_state.quick_worker.answer(TellRecord, TOLD)
    assert made.verdict.told.noted.text().endswith("lift moved")


def test_nothing_is_said_of_a_run_without_either(still):
    still.open_page("Run")
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    still.app_state.bench_worker.answer(RunProcedure, Ended("r2", "finished"))
    still.app_state.quick_worker.answer(TellRecord, Told())
    told = still.page("Run").live.verdict.told
    assert not told.interrupted.isVisible()
    assert not told.noted.isVisible()


def test_the_history_shows_both_of_the_run_that_is_chosen(still):
    still.open_page("History")
    worker, page = still.app_state.quick_worker, still.page("History")
    worker.answer(ListRuns, (replace(RUN, run_id="r1"),))
    page.table.selectRow(0)
    worker.answer(TellRecord, TOLD)
    assert page.told.noted.text().endswith("lift moved")
    page.table.clearSelection()
    assert page.told.noted.text() == ""


def test_a_note_is_said_to_be_kept_and_where(still, qtbot):
    still.open_page("Run")
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    live = still.page("Run").live
    live.note.setText("lift moved")
    live.note.returnPressed.emit()
    assert still.app_state.lab.state.message == "Kept in the run's record, which History shows: lift moved"
    assert live.note.text() == ""


def test_interruptions_are_counted_from_the_record_with_their_length_and_what_was_measured_again():
    def steps(*names):
        return [Step(float(n), n + 1, 9, name, 0.0) for n, name in enumerate(names)]

    again = Event(10.0, RESUMED, "")
    items = [*steps("zero", "x", "y"), again, *steps("zero", "y", "z"), again, *steps("zero", "z")]
    at = "2026-11-29T0{}:00:00Z".format
    statuses = [("running", at(1)), ("interrupted", at(2)), ("running", at(4)), ("running", at(5)), ("finished", at(6))]
    first, second = interruptions(items, statuses)
    assert (first.at, first.gone_s, first.again) == ("y", 7200.0, ("zero", "y"))  # z broke off: not measured again
    assert (second.at, second.gone_s, second.again) == ("z", None, ("zero", "z"))  # it was killed: nobody wrote when


def test_a_step_that_broke_off_again_was_not_measured_again_and_its_place_is_said_once():
    def steps(*names):
        return [Step(float(n), n + 1, 9, name, 0.0) for n, name in enumerate(names)]

    again, at = Event(10.0, RESUMED, ""), "2026-11-29T0{}:00:00Z".format
    items = [*steps("zero", "x+50uT-nominal"), again, *steps("zero", "x+50uT-nominal")]
    for end in ("interrupted", "running", "failed: aborted by the operator"):
        found = interruptions(items, [("running", at(1)), ("interrupted", at(2)), ("running", at(4)), (end, at(5))])
        assert found[0].again == ("zero",)
    found = interruptions(items, [("running", at(1)), ("interrupted", at(2)), ("running", at(4)), ("finished", at(5))])
    assert found[0].again == ("zero", "x+50uT-nominal")
    twice = Interruption("x+50uT-nominal", None, ("zero",), timed=False)
    said = "▲ 2 interruptions: at x +50 µT nominal (2×). Measured again: offset and first position."
    assert interrupted_words(Told((twice, twice))) == said


def test_one_that_was_interrupted_again_and_not_gone_on_with_counts_that_as_well():
    items = [Step(0.0, 1, 9, "zero", 0.0), Event(1.0, RESUMED, ""), Step(2.0, 2, 9, "x", 0.0)]
    at = "2026-11-29T0{}:00:00Z".format
    statuses = [("running", at(1)), ("interrupted", at(2)), ("running", at(4)), ("interrupted", at(5))]
    assert [one.at for one in interruptions(items, statuses)] == ["zero", "x"]
    assert [one.at for one in interruptions(items, statuses[:-1])] == ["zero"]  # it goes on
    assert interruptions(items[:1], statuses[:2]) == []
    words = interrupted_words(Told(tuple(interruptions(items, statuses))))
    assert words.startswith("▲ 2 interruptions: at offset and first position, for 2 h; at ")


def test_an_estimate_that_does_not_follow_says_whose_it_is_and_what_rests_on_it():
    bench = SimpleNamespace(config=SimpleNamespace(dut=SimpleNamespace(noise_nT=None)))
    estimate = RunningEstimate(bench)
    estimate._filter = SimpleNamespace(diverged=lambda: "the filter has diverged, or the sensor has changed")
    said = estimate.sentence()
    assert said == ASTRAY
    assert said.startswith(SO_FAR)
    assert form_of(said) is not None


def test_where_nothing_is_measured_again_yet_that_is_no_result():
    first, again = Interruption("x+50uT-nominal", None, (), timed=False), Interruption("zero", None, (), timed=False)
    assert interrupted_words(Told((first,))) == "▲ One interruption: at x +50 µT nominal."
    said = "▲ 2 interruptions: at x +50 µT nominal; at offset and first position."
    assert interrupted_words(Told((first, again))) == said
