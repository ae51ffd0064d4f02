"""A platform that nobody stops any more is stopped beside the way to zero: it waits for no supply, dead or not.

By a process of its own, begun once zero is ordered: what is slow or fails there keeps no coil on. A run that lives has
the platform's line, stops it itself and lets go; of one that hangs, and is not ended, nobody has it: that is said. A
line that a supply is on as well is the coils' until they are down, whoever brings them there.
"""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, closing, contextmanager, nullcontext, suppress
from dataclasses import asdict, replace
from pathlib import Path
from typing import TYPE_CHECKING, cast

from labcal.errors import InputError, InstrumentError
from labcal.files.atomic import absolute
from labcal.files.home import for_children
from labcal.files.toml_file import read_toml

if TYPE_CHECKING:
    from labcal.bench.coils.state import PlatformReading
    from labcal.bench.driver_kit.roles import RotationPlatform
LINE_S = 1.0  # a run that was killed has its line no longer
LETS_GO_S = 8.0  # one that lives is at its end by then, and the platform at rest
ENDED_S = 20.0  # to load, to wait for the line, to stop and to see it stand
AGAIN_S = 0.05
COILS_ARE_DOWN = b"coils are down\n"
NOT_YET = "not yet"  # the fault of one that was not seen to stand in time
KEPT = "another process ({}) keeps the platform's line and does not stop it"
_going_on: list[subprocess.Popen[bytes]] = []  # kept: they go on when this process has forgotten them


class StageStop:
    """Of the bench file `path`. `say`: what else goes on beside the way to zero, given what may be said of it."""

    def __init__(self, path: Path, say: Callable[[str], AbstractContextManager[object]] = nullcontext) -> None:
        self._path, self._say = path, say
        self._child: subprocess.Popen[bytes] | None = None

    @contextmanager
    def meanwhile(self, words: str) -> Iterator[None]:
        """Begin, for zero is ordered."""
        self.begin()
        with self._say(words):
            yield

    def begin(self) -> None:
        """Once, however often it is said."""
        if self._child is None and _has_a_line(self._path):
            with suppress(OSError):  # no memory, no handle: nobody hears of the platform
                self._child = subprocess.Popen(
                    [sys.executable, "-P", "-m", "labcal.bench.stage_off", str(absolute(self._path))],
                    stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, env=for_children(),
                    start_new_session=True,
                )  # fmt: skip

    def ended(self, within_s: float = ENDED_S) -> PlatformReading | None:
        """How the platform is, now that the coils are down as far as they go; None where none with a motor is known.

        Where that takes longer it is not known; it goes on.
        """
        from labcal.bench.coils.state import PlatformReading

        if self._child is None:
            return None
        try:
            said = self._child.communicate(COILS_ARE_DOWN, timeout=within_s)[0]
            return PlatformReading(**json.loads(said)) if said.strip() else None
        except subprocess.TimeoutExpired:
            _going_on.append(self._child)
            return PlatformReading(fault=NOT_YET)
        finally:
            for pipe in (self._child.stdin, self._child.stdout):
                if pipe is not None:
                    pipe.close()


def _has_a_line(path: Path) -> bool:
    """Whether the file names a platform that may still turn when its run has died."""
    try:
        instruments = read_toml(path)[1].get("instruments", {}).values()
        links = [str(one["link"]) for one in instruments if one.get("role") == "platform"]
    except (InputError, OSError, AttributeError, KeyError, TypeError):
        return False
    return any(not link.startswith(("emulated://", "manual://")) for link in links)


def stopped(path: Path, coils_are_down: Callable[[], bool] = lambda: True) -> PlatformReading | None:
    """Stop the platform of the bench `path` and see it stand; as `StageStop.ended`. Times are by the monotonic clock.

    `coils_are_down`: returns once they are, False where nobody will say so; asked where a supply is on its line.
    """
    from labcal.bench.clock import RealClock
    from labcal.bench.coils.state import PlatformReading
    from labcal.bench.config import read_config
    from labcal.bench.driver_kit.roles import ByHand
    from labcal.bench.guardian.hung import stands_still
    from labcal.bench.links import ports
    from labcal.bench.loading import Loader
    from labcal.bench.platform import BenchPlatform
    from labcal.bench.reading import held

    config = read_config(path)
    name = next(name for name, one in config.instruments.items() if one.role == "platform")
    loader = Loader(path, config, RealClock(), 0)
    line = loader.line_of(name)
    if ports.port_of(line) in map(ports.port_of, config.guarded_links) and not coils_are_down():
        return None
    loader.meet_group()
    begun_s = time.monotonic()
    while True:
        try:
            with closing(loader), held(loader, name):
                stage = loader.instrument(name)
                if isinstance(stage, ByHand):
                    return None
                platform = BenchPlatform(cast("RotationPlatform", stage), config.platform, config.dut.limits)
                stage.identify()  # a stop is no word for another instrument
                how = platform.brought_to_rest(loader.clock)
                seen = how.read_s is not None  # the clock of this bench began when it was loaded: nobody else has it
                return replace(how, read_s=time.monotonic()) if seen else how
        except InstrumentError as fault:
            if fault.fault != "in use":
                return PlatformReading(fault=fault.what)
            holder, waited_s = ports.holding(line), time.monotonic() - begun_s
            if waited_s > (LINE_S if stands_still(holder) else LETS_GO_S):
                return PlatformReading(fault=KEPT.format(holder or "?"))
            time.sleep(AGAIN_S)


if __name__ == "__main__":
    if (how := stopped(Path(sys.argv[1]), lambda: sys.stdin.buffer.readline() == COILS_ARE_DOWN)) is not None:
        print(json.dumps(asdict(how)), flush=True)
