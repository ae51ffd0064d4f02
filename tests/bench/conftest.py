"""A lab on real lines, and sessions on it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from other_users import common_folder, group_folder
from served_lab import Served, Sessions, end_guardians, example


@pytest.fixture
def bench_text() -> str:
    """The bench file of `lab`."""
    return example()


@pytest.fixture
def lab(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, bench_text: str) -> Iterator[Served]:
    """A bench on real lines."""
    served = Served(tmp_path, monkeypatch, bench_text)
    yield served
    end_guardians(served)
    served.close()


@pytest.fixture
def session(lab: Served) -> Iterator[Sessions]:
    """Starts sessions that energise the coils; at the end they and their guardians are gone."""
    sessions = Sessions(lab)
    yield sessions
    sessions.end()


@pytest.fixture
def common() -> Iterator[Path]:
    """A place like /tmp, of its own."""
    with common_folder() as folder:
        yield folder


@pytest.fixture
def of_group(common: Path) -> Path:
    """The folder of a group in it."""
    return group_folder(common)
