"""A bench that `labcal bench serve` wrote has real links and no real instrument: what it measures is simulated."""

from pathlib import Path

import pytest
from served_lab import plain

from labcal.bench.config import read_config
from labcal.bench.serve import serve
from labcal.errors import InputError


class Ready(Exception):
    pass


def ready() -> None:
    raise Ready


def served(folder: Path, text: str) -> Path:
    """The file that is written for the bench `text`."""
    (folder / "bench.toml").write_text(text, encoding="utf-8")
    with pytest.raises(Ready):
        serve(folder / "bench.toml", folder / "served.toml", ready)
    return folder / "served.toml"


def test_a_served_bench_says_so_and_is_driven_as_a_real_one(tmp_path: Path) -> None:
    config = read_config(served(tmp_path, plain()))
    assert (config.served, config.unreal, config.simulated) == (True, True, False)


def test_a_bench_with_one_real_instrument_is_real(tmp_path: Path) -> None:
    text = plain().split("\n[twin]")[0]
    at = text.index("emulated://", text.index("[instruments.reference]"))
    text = text[:at] + "serial:///dev/ttyUSB7" + text[at + len("emulated://") :]
    path = served(tmp_path, text)
    assert not read_config(path).unreal
    path.write_text("served = true\n" + path.read_text(encoding="utf-8"), encoding="utf-8")
    with pytest.raises(InputError, match="served: serial:///dev/ttyUSB7 is no port of this computer"):
        read_config(path)
