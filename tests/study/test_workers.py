"""What the processes of a study are started with."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from labcal.files.home import SECRETS
from labcal.study.engine import environment_of_workers

CANARY = "c4nary"


def test_no_secret_and_one_thread_of_linear_algebra(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("MKL_NUM_THREADS", raising=False)
    for name in (*SECRETS, "OMP_NUM_THREADS"):
        monkeypatch.setenv(name, CANARY)
    before = dict(os.environ)
    looked = [sys.executable, "-c", "import os; print(dict(os.environ))"]
    with environment_of_workers():
        told = subprocess.run(looked, check=True, capture_output=True, text=True).stdout
    assert CANARY not in told
    assert told.count("_THREADS': '1'") == 4
    assert dict(os.environ) == before
