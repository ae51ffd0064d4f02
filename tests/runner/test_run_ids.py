"""Runs that begin at one moment have names of their own."""

from __future__ import annotations

import secrets
from datetime import UTC, datetime
from pathlib import Path

import pytest

from labcal import session
from labcal.bench.clock import VirtualClock

EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"
QUICK = '''
def quick(bench):
    """Measure nothing."""
    yield from ()
'''


def test_where_another_run_has_the_letters_that_were_drawn_there_are_more(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(secrets, "token_hex", lambda size: "c0" * size)
    (tmp_path / "quick.py").write_text(QUICK)
    begun = [
        session.run(str(tmp_path / "quick.py"), EXAMPLE, clock=VirtualClock(datetime(2026, 1, 5, tzinfo=UTC)))
        for _ in range(3)
    ]
    assert [one.run_id for one in begun] == [
        "20260105T000000-c0c0",
        "20260105T000000-c0c0c0",
        "20260105T000000-c0c0c0c0",
    ]
