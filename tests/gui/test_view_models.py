"""View-models without widgets, against a worker that only takes down what it is told."""

import numpy as np
import pytest
from lab_states import told

from labcal.bench.parameters import Limits, ParameterSpec
from labcal.errors import InputError, InstrumentError
from labcal.gui.ipc.answers import Change, Ended, FitFigures, Fitted, Look
from labcal.gui.ipc.messages import Abort, Answer, FilterHistory, ListMethods, LookAt, RunProcedure, Stop, TryCause
from labcal.gui.ipc.wire import Fault, fault_of, item_from_json, item_to_json, pack, unpack
from labcal.gui.viewmodels.run import RunViewModel
from labcal.gui.viewmodels.study import StudyViewModel
from labcal.gui.widgets.parameter_form import title_of
from labcal.record import Segment
from labcal.record.stream import Block, Event, Measurement, Prompt, SegmentClosed, SegmentOpened, Step


@pytest.fixture
def worker(deaf):
    return deaf()


@pytest.fixture
def run(worker):
    made = RunViewModel(worker, nominal_nT_per_unit=4.0)
    made.start(RunProcedure("preflight", "bench.toml", {"axes": "x"}, "EM-07", "J. Doe"))
    return made


def send(worker, *items):
    worker.items.emit(items)


def block(stream, columns, t, values):
    return Block(
        stream, "cage" if stream == "channel" else stream, columns, np.asarray(t, float), np.atleast_2d(values)
    )


def test_a_run_asks_its_worker_and_takes_no_second(run, worker):
    assert worker.commands() == [RunProcedure("preflight", "bench.toml", {"axes": "x"}, "EM-07", "J. Doe")]
    with pytest.raises(RuntimeError):
        run.start(RunProcedure("preflight", "bench.toml"))


def test_steps_are_marked_as_they_come(run, worker):
    send(worker, Step(0.0, 1, 3, "zero", 60.0, ("zero", "x", "closing")), Step(5.0, 2, 3, "x", 50.0))
    assert run.steps() == [("zero", "done"), ("x", "now"), ("closing", "next")]
    send(worker, Event(6.0, "skip", "x skipped", {"step": "x"}), Step(7.0, 3, 3, "closing", 10.0))
    assert run.steps() == [("zero", "done"), ("x", "skipped"), ("closing", "now")]


def test_time_left_runs_down_with_the_samples_and_never_below_zero(run, worker):
    send(worker, Step(0.0, 1, 1, "zero", 20.0, ("zero",)))
    send(worker, block("dut", ("dut_x", "dut_y", "dut_z"), [12.0], [1.0, 2.0, 3.0]))
    assert run.left_s() == pytest.approx(8.0)
    send(worker, block("dut", ("dut_x", "dut_y", "dut_z"), [99.0], [1.0, 2.0, 3.0]))
    assert run.left_s() == 0.0


def test_samples_come_in_nanotesla_and_only_a_segment_s_go_on_the_sphere(run, worker):
    axes = ("dut_x", "dut_y", "dut_z")
    send(worker, block("dut", axes, [1.0], [1.0, 2.0, 3.0]), SegmentOpened(2.0, Segment("x-20uT", "rotation")))
    send(worker, block("dut", axes, [3.0], [10.0, 20.0, 30.0]), block("angle", ("angle_deg",), [3.0], [[7.0]]))
    send(worker, SegmentClosed(4.0), block("dut", axes, [5.0], [1.0, 2.0, 3.0]))
    assert len(run.dut) == 3
    np.testing.assert_allclose(run.drawn.rows(), [[40.0, 80.0, 120.0]])
    assert run.coverage() == pytest.approx(1 / 24)


def test_an_answer_goes_to_the_prompt_it_is_for_and_only_once(run, worker):
    send(worker, Prompt(1.0, "mount-x", "Mount it.", ("done",), True))
    assert run.state == "asking"
    run.answer("done")
    run.answer("done")
    assert worker.said == [Answer("mount-x", "done")]


def test_the_light_of_an_axis_is_the_worst_of_what_was_measured_about_it(run, worker):
    send(worker, Measurement(1.0, "x+20uT-nominal: missing sectors", 0.0, 0.0, "", 0.0))
    assert run.axis_light("x") == "PASS"
    send(worker, Measurement(2.0, "closure x", 900.0, 1.0, "nT", 500.0))
    assert (run.axis_light("x"), run.axis_light("y")) == ("FAIL", "")


def test_coils_are_as_they_were_told_and_not_as_an_event_says(run, worker):
    told(worker, (0.1, 0.2, 0.3))
    send(worker, Event(1.0, "read-back", "coils at zero", {"current_A": [0.0, 0.0, 0.0]}))
    assert ([coil.current_A for coil in run.lab.coils], run.coils_at_zero) == ([0.1, 0.2, 0.3], False)
    assert "zero" not in run.message
    told(worker, (None, 0.0, 0.0))
    assert run.coils_at_zero is False
    told(worker)
    assert run.coils_at_zero is True
    told(worker, verdict="disagrees")
    assert run.coils_at_zero is False


def test_a_failure_ends_the_run_with_its_words(run, worker):
    worker.asked[0].failed(Fault("ended", "The work was killed (signal 9, SIGKILL).", "", "trace"))
    assert (run.state, run.fault.kind) == ("ended", "ended")
    assert not run.alive


@pytest.mark.parametrize(("end", "word"), [(RunViewModel.stop, Stop()), (RunViewModel.abort, Abort())])
def test_after_stop_no_answer_goes_out(run, worker, end, word):
    send(worker, Prompt(1.0, "ready", "Ready?", ("done",), True))
    end(run)
    run.answer("done")
    assert worker.said == [word]


def test_what_is_computed_of_a_run_goes_on_behind_another_and_is_there_again(worker, deaf):
    second = deaf()
    study = StudyViewModel(worker, second)
    look = Look("one", "EM-1", 0, np.zeros((0, 3)), {})
    study.open("one")
    worker.answer(LookAt, look)
    study.fit("ml")
    late, fitted = worker.asked[-1].then, Fitted(FitFigures(True))
    study.open("two")
    assert (worker.killed, second.commands(LookAt)) == (0, [LookAt("two")])  # nobody waits for another's fit
    late(fitted)
    assert (study.fits, study.of("one").fits) == ({}, {"ml": fitted})
    study.open("one")
    assert (study.fits, study.look, len(worker.commands(LookAt))) == ({"ml": fitted}, look, 0)
    study.let_go()
    assert (study.run, study.of("one").fits) == ("", {"ml": fitted})


def test_a_worker_made_ready_ahead_is_not_given_up_when_a_run_is_opened(worker):
    study = StudyViewModel(worker)
    study.prepare()
    study.open("one")
    assert (worker.killed, worker.commands()) == (0, [ListMethods(), LookAt("one"), ListMethods()])


def test_a_study_that_crashes_waits_for_nothing(worker):
    study = StudyViewModel(worker)
    study.open("one")
    study.close_loop()
    worker.asked[-1].failed(Fault("crash", "gone"))
    assert not study.busy
    assert study.fault.kind == "crash"


def test_what_goes_over_the_wire_comes_back_the_same():
    sent = block("dut", ("dut_x", "dut_y", "dut_z"), [1.0, 2.0], [[1.0, np.nan, 3.0], [4.0, 5.0, 6.0]])
    back = item_from_json(item_to_json(sent))
    np.testing.assert_array_equal(back.values, sent.values)
    prompt = Prompt(1.0, "mount-x", "Mount", ("yes", "no"), True, {"body_from_cage": [[1.0, 0.0, 0.0]] * 3})
    assert item_from_json(item_to_json(prompt)) == prompt
    array = np.arange(6.0).reshape(2, 3)
    np.testing.assert_array_equal(unpack(pack(array)), array)


def test_faults_keep_their_remedy():
    fault = fault_of(InstrumentError("The stage is stuck.", fault="stuck", remedy="Free it."))
    assert (fault.kind, fault.text, fault.remedy) == ("instrument", "The stage is stuck.", "Free it.")
    assert fault_of(InputError("no")).kind == "input"
    assert fault_of(ZeroDivisionError("x")).kind == "crash"


def test_a_parameter_is_named_without_its_unit():
    spec = ParameterSpec("rate_deg_per_s", "number", 0.0, limits=Limits(0, 60, "deg/s"))
    assert title_of(spec) == "Rate"


def test_any_cause_is_looked_at_once_and_a_filter_that_refuses_is_not_asked_again(worker):
    study = StudyViewModel(worker)
    study.open("one")
    study.look_at("offset-current", ("i_eps",))
    study.look_at("offset-current", ("i_eps",))
    assert worker.commands(TryCause) == [TryCause("one", "offset-current", ("i_eps",))]
    change = Change(np.ones((2, 3)), np.ones((2, 3)), {})
    worker.answer(TryCause, change)
    study.look_at("offset-current", ("i_eps",))
    assert worker.commands(TryCause) == []
    assert study.causes == {"offset-current (i_eps)": change}
    study.follow("ekf")
    worker.asked[-1].failed(Fault("input", "too short"))
    study.follow("ekf")
    assert len(worker.commands(FilterHistory)) == 1


def test_the_last_line_of_a_run_says_what_its_store_did(run, worker):
    why = "interrupted by its store: runs.sqlite: the disk is full; every row is kept by now"
    worker.answer(RunProcedure, Ended("r1", "interrupted", None, (), why))
    assert run.message.endswith(why.replace("interrupted", "broken off"))
