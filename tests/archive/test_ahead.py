"""While a run is put on the disk the next is read, and no more than that: a lab's years do not fit into memory."""

from __future__ import annotations

import threading

import pytest

from labcal.errors import InputError
from labcal.session.pushing import ahead

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
