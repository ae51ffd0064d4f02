"""A DUT that was recorded before: a table of samples, played again on an emulated line at its own times."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from drivers.csv_line import CsvLine, Parser
from drivers.csv_line import Settings as CsvSettings
from drivers.framing.columns import channels
from drivers.framing.listener import Listener
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.links import Link
from labcal.errors import InputError

LARGEST_BYTES = 1 << 28  # all its rows are kept at once


def recording(file: Path) -> bytes:
    """The bytes of a recorded file. Raises InputError for a device, a pipe, and more than a recording has."""
    if not file.is_file():
        raise InputError("no table of samples is there: it is no file", file=file)
    with file.open("rb") as opened:
        content = opened.read(LARGEST_BYTES + 1)
    if len(content) > LARGEST_BYTES:
        raise InputError(f"is larger than {LARGEST_BYTES >> 20} MiB: replay a part of it", file=file)
    return content


@dataclass(frozen=True, slots=True)
class Settings(CsvSettings):
    """`file`: comma-separated with a header row, such as the samples.csv of an exported run.

    Column t is found there as t or t_s, x y z as such or as dut_x dut_y dut_z, all else by its name.
    """

    file: str = ""
    stamp: Literal["host", "device"] = "device"

    def __post_init__(self) -> None:
        CsvSettings.__post_init__(self)
        if not self.file or "t" not in self.columns:
            raise ValueError("file must name a table of samples, and columns have t")


class Replay(Listener):
    """Only on emulated:// (the file is the instrument); it falls silent where the file ends."""

    roles = ("dut",)

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        if not link.emulated:
            raise InputError(f"{name}: a file is replayed on emulated://, not on {link.url}")
        self.settings, self.channels = settings, channels(settings)
        file = Path(settings.file)
        digest = hashlib.sha256(recording(file)).hexdigest()
        who = Identity("", f"replay of {file.name}", settings.serial, f"sha256 {digest[:16]}")
        super().__init__(name, link, clock, who, lambda mishaps: Parser(name, settings, mishaps))

    parse_again = staticmethod(CsvLine.parse_again)
