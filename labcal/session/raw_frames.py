"""Raw frames of a recorded run, parsed again by the drivers that read them, beside the samples that were kept."""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from functools import partial
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from pydantic import ValidationError

from labcal.bench.clock import RealClock
from labcal.bench.config import BenchConfig
from labcal.bench.loading import Loader
from labcal.bench.streams.reference import into_cage
from labcal.errors import InputError
from labcal.record import RunHeader
from labcal.record.stream import Block
from labcal.store import Store

Parse = Callable[[bytes], NDArray[np.float64]]
ROUNDING = 1e-9  # of the largest: another processor may round otherwise


class Differs(Exception):
    """The first block whose samples are not what its frames say, in words."""


def compare(store: Store, run_id: str) -> int:
    """Parse the raw frames of a run again; returns how many of its blocks that were. Raises Differs.

    Left out is what was imported or has no chain, an instrument whose driver is not here or cannot, a reference that
    stands elsewhere: what is kept of that one was carried to the DUT's place with the currents of the moment.
    """
    if store.status(run_id) == "imported" or store.chain_of(run_id) is None:
        return 0
    parsers, blocks = _parsers(store.header(run_id)), 0
    for block in _blocks(store, run_id):
        if (parse := parsers.get(block.source)) is not None:
            _compare(run_id, block, parse)
            blocks += 1
    return blocks


def _blocks(store: Store, run_id: str) -> Iterator[Block]:
    return (item for item in store.items(run_id) if isinstance(item, Block) and item.raw)


def _compare(run_id: str, block: Block, parse: Parse) -> None:
    what = f"run {run_id}: {len(block)} samples of {block.source} from {block.t_s[0]:g} s on"
    try:
        again = parse(block.raw)
    except Exception as error:  # the driver may be another package's, and the frames are any bytes
        raise Differs(f"{what}: their raw frames cannot be read again ({error})") from None
    if again.shape != block.values.shape:
        raise Differs(f"{what}: their raw frames give {len(again)}")
    allowed = ROUNDING * float(np.max(np.abs(again), initial=0.0))
    same = np.isclose(again, block.values, rtol=0.0, atol=allowed, equal_nan=True).all(axis=1)
    if not same.all():
        at_s = block.t_s[int(np.argmin(same))]
        raise Differs(f"{what}: that at {at_s:.6f} s is not what its raw frame says")


def _parsers(header: RunHeader) -> Mapping[str, Parse]:
    """By instrument: its driver's own parser of frames, with the settings of the run's bench file."""
    found = dict[str, Parse]()
    with suppress(tomllib.TOMLDecodeError, ValidationError):
        config = BenchConfig.model_validate(tomllib.loads(header.bench))
        loader = Loader(Path(header.run_id), config, RealClock(), 0)
        for name in config.instruments:
            with suppress(InputError):
                driver, _, settings = loader.driver(name)
                parse = getattr(driver, "parse_again", None)
                if parse is not None and not _carried(config, name):
                    found[name] = _as_kept(config, name, partial(parse, settings))
    return found


def _as_kept(config: BenchConfig, name: str, parse: Parse) -> Parse:
    """A vector reference's samples in the cage's axes, as the bench keeps them; all others as they are."""
    if config.instruments[name].role != "reference":
        return parse

    def into_its_cage(raw: bytes) -> NDArray[np.float64]:
        read = parse(raw)
        return into_cage(read, config.reference) if read.shape[1] == 3 else read

    return into_its_cage


def _carried(config: BenchConfig, name: str) -> bool:
    return config.instruments[name].role == "reference" and config.reference.place != "dut"
