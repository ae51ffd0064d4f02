"""A person reads the bench file's own name and the field's words, no keys of a file."""

import re
from shutil import copyfile

import pytest
from test_hands_in_the_cage import running as running
from test_hands_in_the_cage import send

from labcal.gui.ipc.bench_commands import read_bench
from labcal.gui.ipc.messages import ReadBench
from labcal.gui.ipc.wire import Fault
from labcal.gui.translations.sentences import in_words
from labcal.gui.viewmodels.role_words import ROLES
from labcal.record.stream import Prompt
from labcal.runner.catalogue import procedures

WRONG = "Is this the instrument that bench.toml names? Look at its cable, then try again."
UNTRANSLATED = "Do the settings in bench.toml fit what it sends?"


@pytest.fixture
def served(running, tmp_path):
    """The window on a bench file of another name."""
    path = tmp_path / "served.toml"
    copyfile(running.app_state.bench, path)
    running.app_state.bench_worker.asked[-1].failed(Fault("stopped", "stopped by the operator"))
    running.app_state.open_bench(str(path))
    running.app_state.quick_worker.answer(ReadBench, read_bench(None, ReadBench(path)))
    return running


@pytest.mark.parametrize("remedy", [WRONG, UNTRANSLATED])
def test_advice_names_the_bench_file_that_is_in_use(served, remedy):
    wanted = remedy.replace("bench.toml", "served.toml")
    served.fault.show_fault(Fault("instrument", "dut: wrong reply.", remedy))
    assert served.fault.remedy.text() == wanted
    drawing = {"no_answer": "dut", "what": "dut: wrong reply.", "remedy": remedy}
    send(served, Prompt(3.0, "failed-z", "z: lost", ("stop", "retry"), drawing=drawing))
    assert wanted in served.page("Run").live.prompt.details.text()


def test_a_path_that_somebody_named_stays_as_it_is(served):
    assert in_words("Opening bench.toml …") == "Opening bench.toml …"
    served.fault.show_fault(Fault("input", "unreadable", "Look at /lab/bench.toml and at old-bench.toml."))
    assert served.fault.remedy.text() == "Look at /lab/bench.toml and at old-bench.toml."


def test_the_roles_of_the_bench_page_are_words(served):
    served.open_page("Bench")
    page = served.page("Bench")
    words = [page.table.text(row, 0) for row in range(page.table.rowCount())]
    assert len(words) > 5
    assert not set(words) & (set(ROLES) - {"interlock", "platform", "reference"})


def test_no_setting_of_a_procedure_is_explained_by_the_key_of_another():
    keys = {spec.name for one in procedures().values() for spec in one.parameters if "_" in spec.name}
    helps = {spec.help for one in procedures().values() for spec in one.parameters}
    assert not [text for text in helps if keys & set(re.findall(r"\w+", text))]
