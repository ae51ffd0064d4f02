"""A simulated bench for procedures: the example's, without the DUT's hidden effect."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

EXAMPLE = Path(__file__).resolve().parents[2] / "examples" / "simulated.toml"


@pytest.fixture
def bench_file(tmp_path: Path) -> Callable[..., Path]:
    """Write a bench file like the example, with `replacements` of its text and `twin` as the table [twin]."""

    def write(twin: str = "", *replacements: tuple[str, str]) -> Path:
        text = EXAMPLE.read_text(encoding="utf-8").replace("surprise = true", twin)
        for old, new in replacements:
            assert old in text, old
            text = text.replace(old, new)
        path = tmp_path / "bench.toml"
        path.write_text(text, encoding="utf-8")
        return path

    return write
