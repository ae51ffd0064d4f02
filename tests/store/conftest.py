"""A small bundle whose text each test may spoil."""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

Wait = Callable[[Callable[[], bool]], None]
GOLDEN = Path(__file__).parents[1] / "golden"
Change = Callable[[dict[str, Any]], Any]


@pytest.fixture(scope="session")
def eventually() -> Wait:
    """Wait until something is true; the minute is for one that never will be, not for a busy machine."""

    def wait(true: Callable[[], bool]) -> None:
        deadline = time.monotonic() + 60
        while not true():
            assert time.monotonic() < deadline, "it never came true"
            time.sleep(0.02)

    return wait


@pytest.fixture(scope="session")
def sample_rows() -> str:
    """Three rows of samples that belong to golden/bundle-small.json."""
    return (GOLDEN / "bundle-small.csv").read_text()


@pytest.fixture
def bundle(tmp_path: Path, sample_rows: str) -> Callable[..., Path]:
    """Write the small bundle with its header changed by a function, or its rows (text or bytes) replaced."""

    def write(change: Change | None = None, rows: str | bytes = sample_rows) -> Path:
        header = json.loads((GOLDEN / "bundle-small.json").read_text())
        if change is not None:
            change(header)
        folder = tmp_path / "bundle"
        folder.mkdir(exist_ok=True)
        (folder / "run.json").write_text(json.dumps(header, indent=1))
        (folder / "samples.csv").write_bytes(rows.encode() if isinstance(rows, str) else rows)
        return folder

    return write
