"""Whatever an exception of a procedure of one's own does, the run ends with its kind and line, the coils at zero."""

from __future__ import annotations

from pathlib import Path

import pytest

from labcal import session
from labcal.demo import simulated_bench
from labcal.errors import InputError

BODY = """
from labcal.bench.steps import energise


class Mute(Exception):
    def __str__(self):
        {does}


def mute(bench):
    \"\"\"Raise what cannot be said.\"\"\"
    yield from energise(bench, (0.0, 0.0, 20_000.0))
    raise Mute
"""


@pytest.mark.parametrize("does", ["raise ValueError", "return 3", "raise SystemExit(0)", "raise Mute"])
def test_an_exception_that_cannot_be_said_is_named_by_its_kind_and_line(tmp_path: Path, does: str) -> None:
    (tmp_path / "mute.py").write_text(BODY.format(does=does))
    outcome = session.run(str(tmp_path / "mute.py"), simulated_bench(), {}, seed=1)
    assert isinstance(outcome.fault, InputError)
    assert outcome.fault.what == "Mute"
    assert outcome.status.startswith("failed: ")
    assert outcome.status.endswith("mute.py, line 13: Mute")
    assert session.runs()[-1].status == outcome.status
    assert outcome.lab is not None
    assert outcome.at_rest.startswith("coils at zero")
