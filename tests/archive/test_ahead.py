"""While a run is put on the disk the next is read, and no more than that: a lab's years do not fit into memory."""

from __future__ import annotations

import multiprocessing
import os
import threading
from pathlib import Path

import pytest
from made_ready import about_it, deadly, noted, upper

from labcal.archive.ahead import FEW, MOST, ahead, worth_it
from labcal.errors import InputError
from labcal.files.home import SECRETS

NAMES = [f"run-{number}" for number in range(6)]


def test_one_is_worked_on_while_another_is_in_use() -> None:
    begun, go_on = list[str](), threading.Semaphore(0)

    def work(name: str) -> str:
        begun.append(name)
        go_on.release()
        return name.upper()

    for place, (name, found) in enumerate(ahead(work, NAMES)):
        assert (name, found.result(timeout=10)) == (NAMES[place], NAMES[place].upper())
        for _ in range(2 if place == 0 else 1):  # without asking for the next
            assert place == len(NAMES) - 1 or go_on.acquire(timeout=10)
        assert begun == NAMES[: place + 2]


def test_a_fault_is_that_of_its_own_name() -> None:
    def work(name: str) -> str:
        if name == "run-2":
            raise InputError("does not fit its chain")
        return name

    faults = {name: found.exception(timeout=10) for name, found in ahead(work, NAMES)}
    assert [name for name, fault in faults.items() if fault] == ["run-2"]
    with pytest.raises(InputError, match="does not fit its chain"):
        raise faults["run-2"] or AssertionError


def test_by_processes_each_comes_in_its_order_with_its_fault() -> None:
    names = [*NAMES, "bad", "last"]
    found = list(ahead(upper, names, 2))
    assert [name for name, _ in found] == names
    assert [one.result() for name, one in found if name != "bad"] == [name.upper() for name in names if name != "bad"]
    [fault] = [one.exception() for name, one in found if name == "bad"]
    assert isinstance(fault, InputError)
    assert str(fault) == "store, line 3: bad does not fit its chain"
    assert multiprocessing.active_children() == []


@pytest.mark.skipif(os.name != "posix", reason="a process ends itself by a signal here")
def test_what_a_killed_process_leaves_is_done_here(tmp_path: Path) -> None:
    names = [f"{tmp_path}/{name}" for name in ("a", "b", "deadly", "c", "d")]
    found = [(name, one.result()) for name, one in ahead(deadly, names, 2)]
    assert (tmp_path / "died").exists()
    assert [name for name, _ in found] == names
    assert {process for _, process in found[2:]} == {os.getpid()}


def test_a_large_one_is_worked_on_alone() -> None:
    names = ["a", "b", "large-1", "c", "d", "large-2", "large-3"]
    begun = {name: one.result() for name, one in ahead(noted, names, 2, lambda name: "large" in name)}
    assert list(begun) == names
    for large, after in (("large-1", "c"), ("large-2", "large-3")):
        assert begun[after] >= begun[large] + 0.5
    assert begun["large-1"] >= max(begun["a"], begun["b"]) + 0.05


def test_a_process_stands_back_has_one_thread_of_linear_algebra_and_no_secret(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in SECRETS:
        monkeypatch.setenv(name, "c4nary")
    [(_, found)] = ahead(about_it, ["one"], 1)
    niceness, environment = found.result()
    assert niceness == 19 or os.name != "posix"
    assert "c4nary" not in environment.values()
    assert environment["OPENBLAS_NUM_THREADS"] == "1"
    assert all(os.environ[name] == "c4nary" for name in SECRETS)


def test_few_runs_and_one_core_have_no_process(monkeypatch: pytest.MonkeyPatch) -> None:
    for number, there, wanted in ((FEW, 4, 0), (FEW + 1, 1, 0), (FEW + 1, 4, 4), (5000, 64, MOST)):
        monkeypatch.setattr("labcal.archive.ahead.cores", lambda there=there: there)
        assert worth_it(number) == wanted
