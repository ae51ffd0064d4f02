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
from labcal.errors import InputError
from labcal.record import RunHeader
from labcal.record.stream import Block
from labcal.store import Store

Parse = Callable[[bytes], NDArray[np.float64]]
ROUNDING = 1e-9  # relative: another processor may round otherwise


class Differs(Exception):
    """The first block whose samples are not what its frames say, in words."""


def compare(store: Store, run_id: str) -> int:
    """Parse the raw frames of a run again; returns how many of its blocks that were. Raises Differs.

    Left out is what came with another store or without a chain, and an instrument whose driver is not here or cannot.
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
    same = np.isclose(again, block.values, rtol=ROUNDING, atol=0.0, equal_nan=True).all(axis=1)
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
                if parse := getattr(driver, "parse_again", None):
                    found[name] = partial(parse, settings)
    return found
