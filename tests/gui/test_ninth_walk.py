"""What a stranger stumbled over: marks of steps, a held key, a scan that was typed, a file that is verified, the pace."""

import pytest

from labcal.gui.ipc.answers import Ended
from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.ipc.wire import Fault
from labcal.record.stream import Prompt, Step

MOUNT = Prompt(2.0, "mount-z", "Mount the DUT.", ("done",), True)
NAMES = ("zero", "mount-z", "z+20uT")


@pytest.mark.parametrize(("at_a_question", "mark"), [(True, "next"), (False, "broken")])
def test_a_step_that_was_ended_at_its_question_was_never_begun(still, at_a_question, mark):
    run, worker = still.app_state.run, still.app_state.bench_worker
    run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    worker.items.emit((Step(1.0, 2, 3, "mount-z", 60.0, NAMES), *((MOUNT,) if at_a_question else ())))
    run.stop()
    worker.answer(RunProcedure, Ended("r1", "interrupted", Fault("stopped", "stopped")))
    assert dict(run.steps())["mount-z"] == mark
