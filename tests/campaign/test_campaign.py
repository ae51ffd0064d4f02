"""The short form of the campaign: the most important kinds once each, on several benches at once.

Two seconds are judged where the machine let anybody be in time, and a fault of time is tried again: it counts where it
comes back. All else counts at once.
"""

from __future__ import annotations

import shutil
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

if sys.platform == "win32":
    pytest.skip("needs ptys and signals, which Windows lacks", allow_module_level=True)

from campaign import Campaign, results
from kinds import kinds
from verdict import OF_TIME, faults, in_time_can_be_told

AT_ONCE, SEED = 3, 20261122
AGAIN_UNTIL_S = 100.0  # later nothing is tried again
SHORT_FORM = {
    "session killed": "riden-pair",
    "session stopped": "tti",
    "guardian killed": "tti",
    "session and guardian killed": "kepco",
    "terminal closed": "kepco",
    "Ctrl-C": "tti",
    "supply answers corrupt bytes": "tti",
    "supply dropped": "tti",
    "store full": "kepco",
    "two labcals on one bench": "tti",
}
ALWAYS = ("session killed", "session and guardian killed", "supply answers corrupt bytes")  # one on each bench


def seed_on(name: str, bench: str, attempt: int) -> int:
    """A seed that puts this kind on this bench."""
    benches = kinds()[name].benches
    return len(benches) * (SEED + attempt) + benches.index(bench)


@pytest.fixture(scope="module")
def records(
    tmp_path_factory: pytest.TempPathFactory, request: pytest.FixtureRequest
) -> Iterator[dict[str, dict[str, Any]]]:
    """What came of each kind that is asked for; where it was only late, of the last attempt."""
    folder = tmp_path_factory.mktemp("campaign")
    stated = {item.callspec.params.get("name") for item in request.session.items if hasattr(item, "callspec")}
    found, left = dict[str, dict[str, Any]](), {k: bench for k, bench in SHORT_FORM.items() if k in stated}
    begun = time.monotonic()
    for attempt in range(3):
        path = folder / f"{attempt}.jsonl"
        tasks = [(kinds()[name], seed_on(name, bench, attempt)) for name, bench in left.items()]
        Campaign(path, tasks, 600.0).run(AT_ONCE)
        found |= {record["kind"]: record for record in results(path)}
        left = {name: bench for name, bench in left.items() if only_late(found[name])}
        if not left or time.monotonic() - begun > AGAIN_UNTIL_S:
            break
    yield found
    shutil.rmtree(folder, ignore_errors=True)


def only_late(record: dict[str, Any]) -> bool:
    """Whether nothing but the time is wrong, or the machine was too busy for it to be told, or to begin at all."""
    if "not_tried" in record:
        return True
    found = set(faults(record))
    return (bool(found) or not in_time_can_be_told(record)) and found <= OF_TIME


@pytest.mark.parametrize(
    "name", [name if name in ALWAYS else pytest.param(name, marks=pytest.mark.slow) for name in SHORT_FORM]
)
def test_the_coils_come_to_zero_in_time_and_what_is_said_is_true(records: dict[str, Any], name: str) -> None:
    record = records[name]
    assert "not_tried" not in record, record["not_tried"]
    found = set(faults(record))
    if not in_time_can_be_told(record):
        found -= OF_TIME
    said = "\n".join(f"{t_s:8.2f}  {words}" for t_s, words in record["words"])
    assert not found, f"{found} with seed {record['seed']} on {record['bench']}\n{said}\n{ {**record, 'words': ''} }"


def test_every_kind_of_the_short_form_can_be_done_on_its_bench() -> None:
    for name, bench in SHORT_FORM.items():
        assert bench in kinds()[name].benches


def test_the_bench_is_clean_again_after_each(records: dict[str, Any]) -> None:
    assert [record["kind"] for record in records.values() if record.get("left")] == []


def test_results_that_were_cut_are_left_out(tmp_path: Path) -> None:
    path = tmp_path / "results.jsonl"
    path.write_text('{"kind": "Ctrl-C", "seed": 1}\n{"kind": "Ctr')
    assert results(path) == [{"kind": "Ctrl-C", "seed": 1}]
