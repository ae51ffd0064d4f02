"""Where a procedure leans on people: the checklist with its photographs, and turns that stop on the way."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from labcal import session
from labcal.record.stream import Event, Item, Prompt

Run = Callable[..., Any]
BenchFile = Callable[..., Path]


def gone_through(bench: Path, said: dict[str, list[str]]) -> tuple[session.Outcome, list[Item]]:
    """The checklist, each key answered by what is `said` of it in turn, else by its first choice or nothing."""
    items, left = list[Item](), {key: list(answers) for key, answers in said.items()}

    def answer(prompt: Prompt) -> str:
        return left[prompt.key].pop(0) if left.get(prompt.key) else (*prompt.choices, "")[0]

    return session.run("configuration", bench, answer=answer, on_item=items.append), items


def test_the_checklist_names_what_is_not_as_stated_at_its_end(bench_file: BenchFile) -> None:
    good, items = gone_through(bench_file(), {})
    assert good.status == "finished"
    assert [i.key for i in items if isinstance(i, Prompt)][::2] == ["covers", "batteries", "tools", "phones", "chairs"]
    bad, items = gone_through(bench_file(), {"tools": ["no"], "chairs": ["no"]})
    assert bad.status == "failed: configuration: tools, chairs not as stated"
    assert len([i for i in items if isinstance(i, Prompt)]) == 10


def test_a_photograph_is_in_the_record_with_its_digest_and_one_that_is_not_there_is_asked_for_again(
    bench_file: BenchFile, tmp_path: Path
) -> None:
    picture = tmp_path / "covers.jpg"
    picture.write_bytes(b"\xff\xd8 covers")
    _, items = gone_through(bench_file(), {"photo-covers": ["cover.jpg", str(picture)]})
    asked = [i.text for i in items if isinstance(i, Prompt) and i.key == "photo-covers"]
    assert len(asked) == 2
    assert asked[1].startswith("There is no file cover.jpg")
    taken = {
        i.data["item"]: (i.text, i.data.get("sha256")) for i in items if isinstance(i, Event) and i.kind == "photograph"
    }
    assert taken["covers"] == (str(picture), hashlib.sha256(b"\xff\xd8 covers").hexdigest())
    assert taken["tools"] == ("none", None)


@pytest.mark.parametrize(
    ("procedure", "more"),
    [
        ("rotate-axis", {}),
        pytest.param(
            "preflight",
            {"axes": "z", "modes": "nominal", "magnitudes_nT": 20000, "reverse": "no"},
            marks=pytest.mark.slow,
        ),
    ],
)
def test_a_stepped_turn_rests_at_every_stop_and_covers_the_circle(
    ran: Run, procedure: str, more: dict[str, object]
) -> None:
    found = ran(procedure, step_deg=45, dwell_s=1, rate_deg_per_s=20, zero_s=2, **more)
    run = session.load_run(found.outcome.run_id)
    still = np.abs(np.gradient(run.angle_deg, run.t_s)) < 0.5
    rests = np.unique(np.round(run.angle_deg[still]).astype(int))
    assert set(rests) >= set(range(45, 361, 45))
    assert all(still[np.abs(run.angle_deg - stop) < 0.5].sum() >= 8 for stop in range(45, 360, 45))
    missing = [m for name, m in found.measured.items() if name.endswith("missing sectors")]
    assert [m.value for m in missing] == [0.0]
