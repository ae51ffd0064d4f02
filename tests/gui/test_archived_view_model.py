"""What is asked of the archive, and when: one question at a time, none twice, and an end where nothing comes."""

import pytest

from labcal.gui.ipc.answers import RunLine
from labcal.gui.ipc.messages import ListArchivedCalibrations, ListArchivedRuns
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.archived import ArchivedViewModel
from labcal.testing.pages import DeafWorker

URL = "postgresql://ada:c4nary@db.example/lab"
RUN = RunLine("r1", "2026-11-22T23:30:00Z", "finished", "EM-07", "J. Doe", "preflight", site="aalto", sha256="ab")


@pytest.fixture
def worker(qapp):
    return DeafWorker()


@pytest.fixture
def archived(worker, monkeypatch):
    monkeypatch.setenv("LABCAL_ARCHIVE", URL)
    return ArchivedViewModel(worker)


def test_runs_are_asked_for_once_and_calibrations_of_a_dut_after_them(archived, worker):
    archived.ask()
    archived.ask()
    archived.ask_for("EM-07")
    assert worker.commands() == [ListArchivedRuns(URL)]
    worker.answer(ListArchivedRuns, (RUN,))
    assert (archived.runs, archived.asked) == ((RUN,), False)
    archived.ask_for("EM-07")
    archived.ask_for("EM-07")
    assert worker.commands() == [ListArchivedCalibrations(URL, "EM-07")]
    worker.answer(ListArchivedCalibrations, ())
    archived.ask_for("EM-07")
    archived.ask_for("")
    assert worker.commands() == []
    archived.ask()  # the page is opened anew: so is what is known
    worker.answer(ListArchivedRuns, (RUN,))
    archived.ask_for("EM-07")
    assert worker.commands(ListArchivedCalibrations)


def test_what_is_asked_says_nothing_of_the_password(archived, worker):
    archived.ask()
    archived.fetch(RUN, "out.zip", print, print)
    assert "c4nary" not in repr(worker.asked)


def test_a_worker_that_says_nothing_is_ended_and_that_is_said(archived, worker, qtbot):
    archived._patience.setInterval(10)
    archived.ask()
    worker.answer(ListArchivedRuns, (RUN,))
    archived.ask()
    qtbot.waitUntil(lambda: worker.killed == 1)
    worker.asked.pop().failed(Fault("ended", "The work was ended by this window."))
    assert archived.fault is not None
    assert archived.fault.text == "The archive has not answered."
    assert "ended by this window" in archived.fault.details
    assert (archived.runs, archived.asked) == ((), False)
    archived.ask_for("EM-07")
    assert worker.commands() == []  # it does not answer
    archived.ask()
    assert (archived.fault, worker.commands()) == (None, [ListArchivedRuns(URL)])


def test_after_it_was_closed_nothing_is_begun(archived, worker):
    archived.close(1)
    archived.ask()
    archived.ask_for("EM-07")
    assert worker.commands() == []
