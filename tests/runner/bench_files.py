"""Bench files of a simulated lab, in pieces: the example's, without the DUT's hidden effect."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

EXAMPLE = Path(__file__).resolve().parents[2] / "examples" / "simulated.toml"


def bench_files_in(folder: Path) -> Callable[..., Path]:
    """Writes bench.toml there, with `twin` as its table [twin] and `replacements` of the example's text."""

    def write(twin: str = "", *replacements: tuple[str, str]) -> Path:
        text = EXAMPLE.read_text(encoding="utf-8").replace("surprise = true", twin)
        for old, new in replacements:
            assert old in text, old
            text = text.replace(old, new)
        path = folder / "bench.toml"
        path.write_text(text, encoding="utf-8")
        return path

    return write
