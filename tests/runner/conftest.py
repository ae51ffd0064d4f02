"""A simulated bench for procedures."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from bench_files import bench_files_in


@pytest.fixture
def bench_file(tmp_path: Path) -> Callable[..., Path]:
    """Write a bench file like the example: `bench_files`."""
    return bench_files_in(tmp_path)
