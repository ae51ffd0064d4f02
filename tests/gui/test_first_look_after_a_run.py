"""The lab is looked at as soon as a run has ended, by a worker that had everything loaded while the run went on."""

import subprocess
import sys
from pathlib import Path

import pytest
from lab_states import told

from labcal.bench import loading, reading
from labcal.gui.ipc.answers import Ended
from labcal.gui.ipc.bench_commands import prepare_to_read
from labcal.gui.ipc.lab_messages import PrepareToRead, ReadLab
from labcal.gui.ipc.lines import read_request, write_line
from labcal.gui.ipc.messages import Request, RunProcedure
from labcal.gui.ipc.worker import HANDLERS

BENCH = Path(__file__).parents[2] / "examples" / "simulated.toml"


def begun(still):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    told(still, (0.0, 0.0, 0.0))
    return still.app_state


def test_the_worker_that_looks_is_prepared_once_in_each_run(still):
    worker = begun(still).watch_worker
    assert worker.commands(PrepareToRead) == [PrepareToRead(still.app_state.bench)]
    worker.answer(PrepareToRead, True)
    told(still, (0.0, 0.0, 0.0))
    assert worker.commands(PrepareToRead) == []
    still.app_state.bench_worker.answer(RunProcedure, Ended("r1", "finished"))
    begun(still)
    assert worker.commands(PrepareToRead) == [PrepareToRead(still.app_state.bench)]


def test_it_looks_as_the_run_ends(still):
    app_state = begun(still)
    assert app_state.watch_worker.commands(ReadLab) == []
    app_state.bench_worker.answer(RunProcedure, Ended("r1", "finished"))
    (asked,) = app_state.watch_worker.commands(ReadLab)
    assert asked.names == ("supply_x", "supply_y", "supply_z")


@pytest.fixture
def no_line(monkeypatch):
    def opened(*_):
        raise AssertionError("a run has this line")

    for place, name in ((loading, "open_link"), (reading.ports, "hold"), (loading.Loader, "link")):
        monkeypatch.setattr(place, name, opened)


def test_no_line_is_opened_by_it(no_line):
    assert prepare_to_read(None, PrepareToRead(str(BENCH))) is True
    with pytest.raises(AssertionError, match="a run has this line"):
        reading.read_lab(BENCH)


def test_what_reads_has_nothing_to_load_after_it():
    code = """
import subprocess
import sys
from pathlib import Path
from pathlib import Path
from labcal.bench.reading import prepare_to_read, read_lab
bench = Path(sys.argv[1])
prepare_to_read(bench)
before = set(sys.modules)
read_lab(bench)
print(sorted(name for name in set(sys.modules) - before if name.startswith(("labcal", "drivers", "numpy", "scipy"))))
"""
    ran = subprocess.run((sys.executable, "-c", code, str(BENCH)), capture_output=True, text=True, check=True)
    assert ran.stdout.strip() == "[]"


def test_a_worker_is_told_so_by_the_channel():
    asked = Request(7, PrepareToRead(str(BENCH)))
    assert read_request(write_line(asked)) == asked
    assert PrepareToRead in HANDLERS
