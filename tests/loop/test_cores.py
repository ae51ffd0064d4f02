"""Work shared between two cores."""

from __future__ import annotations

import threading

import pytest

from labcal.loop import parallel as cores


def test_what_comes_out_is_in_order_and_a_worker_does_its_own_parts_itself(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cores, "CORES", 2)

    def work(part: int) -> list[tuple[int, str]]:
        return cores.parallel_map(lambda inner: (10 * part + inner, threading.current_thread().name), range(3))

    found = cores.parallel_map(work, range(4))
    assert [number for part in found for number, _ in part] == [
        10 * part + inner for part in range(4) for inner in range(3)
    ]
    assert all(len({name for _, name in part}) == 1 for part in found)
    assert not any(t.name.startswith("loop") for t in threading.enumerate())


def test_a_fault_of_one_part_is_raised(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cores, "CORES", 2)
    with pytest.raises(ZeroDivisionError):
        cores.parallel_map(lambda part: 1 / part, [1, 0, 2])
