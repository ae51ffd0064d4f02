"""What a bench file states of a supply is wrong: it is refused, and hears zero and off first."""

from __future__ import annotations

import subprocess
import sys

import pytest
from served_lab import (
    LABCAL,
    LONG_S,
    Served,
    Sessions,
    at_zero,
    kill_all,
    of_bench,
    three_genesys,
    until,
)

pytestmark = [
    pytest.mark.skipif(sys.platform != "linux", reason="needs SIGKILL and ptys"),
    pytest.mark.parametrize("bench_text", [three_genesys()], ids=["genesys"]),
]


def test_off_reaches_supplies_that_deliver_less_than_is_stated(lab: Served, session: Sessions) -> None:
    child = session("idle")
    kill_all(child)
    until(lambda: not of_bench(lab.file))
    assert not at_zero(lab)
    lab.file.write_text(lab.file.read_text().replace('"max_current_A" = 3.0', '"max_current_A" = 50.0'))
    said = subprocess.run([*LABCAL, "bench", "off", str(lab.file)], capture_output=True, text=True, timeout=LONG_S)
    assert at_zero(lab), said
    assert said.stdout.count("delivers 38 A, and 50 A are stated") == 3, said
    assert said.returncode == 3
