"""The bench without a procedure: who answers, coils off, and a zero in doubt."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from labcal.bench import shutdown
from labcal.bench.coils.at_zero import AtZero
from labcal.bench.coils.doubt import doubt_of
from labcal.bench.coils.state import PlatformReading
from labcal.bench.identify import Identified, identify_all
from labcal.bench.stage_off import StageStop
from labcal.errors import InputError
from labcal.files.atomic import write_text
from labcal.files.outputs import claim
from labcal.files.toml_file import named_files
from labcal.record.person import check_person

if TYPE_CHECKING:
    from labcal.bench.find import Found
    from labcal.bench.look_again import Looked
    from labcal.bench.reading import InstrumentReading

STANDS_S = 0.5  # a platform is waited for, once the coils are down; whoever asks reads on where it takes longer


def identify_instruments(bench: Path) -> list[Identified]:
    """Ask every instrument of a bench.toml who it is; silent ones are in the list, with why."""
    return identify_all(bench)


def prepare_to_read(bench: Path) -> None:
    """Load what `read_lab` takes; no link is opened."""
    from labcal.bench.reading import prepare_to_read

    prepare_to_read(bench)


def read_lab(bench: Path, names: Sequence[str] = ()) -> list[InstrumentReading]:
    """These instruments of a bench.toml as they are now (none named: all); nothing is set."""
    from labcal.bench.reading import read_lab

    return read_lab(bench, names)


def find_instruments(
    stated: Sequence[str], out: Path | None, say: Callable[[str], None], *, force: bool = False
) -> list[Found]:
    """Ask who answers at these places, or at this computer's devices; `out` is a draft of a bench file.

    Of a stated place where nothing is found, why is said. Where nothing is found at all, nothing is written.
    """
    from labcal.bench.clock import RealClock
    from labcal.bench.find import draft, find, places, why_silent
    from labcal.bench.loading import recogniser

    outputs, clock = claim("bench find", out, force=force), RealClock()
    found: list[Found] = []
    for here in [[place] for place in stated] or [list[str]()]:  # none: all that this computer sees
        before = len(found)
        for one in find(places(here), clock, recogniser("scpi-table")):
            found.append(one)
            say(f"{one.link}: {one.said}: {one.driver or 'no driver is known to fit'}")
        if here and len(found) == before:
            say(why_silent(here[0], clock))
    for output in outputs if found else ():
        with output.writing() as path:
            write_text(path, draft(found))
    return found


def serve_bench(bench: Path, out: Path, ready: Callable[[], None], *, force: bool = False) -> None:
    """Put the emulated instruments of `bench` on TCP ports and ptys until interrupted; `out` is the bench to use."""
    from labcal.bench.serve import serve

    [output] = claim("bench serve", out, inputs=named_files(bench), force=force)

    def written() -> None:
        output.remember()
        ready()

    serve(bench, out, written)


def look_again(bench: Path, clear_as: str = "") -> Looked | None:
    """Measure again where a zero of this bench is in doubt; None where none is. `clear_as`: who answers for it."""
    from labcal.bench.look_again import look_again

    check_person(clear_as)
    return look_again(bench, clear_as)


def refuse_doubt(bench: Path) -> None:
    """Where a zero of this bench is in doubt it is measured now. Raises InstrumentError where it is in doubt still."""
    if doubt_of(bench):
        from labcal.bench.look_again import refuse_doubt

        refuse_doubt(bench)


def coils_off(bench: Path) -> list[AtZero]:
    """Every coil to zero and open, one report an axis."""
    return shutdown.coils_off(bench)


def earlier_supplies_are_gone(bench: Path, ports: Sequence[str], who: str) -> None:
    """`who` says that what an earlier session on `bench` drove at these ports is gone: nobody asks for it again.

    Raises InputError where nobody says it.
    """
    from labcal.bench.guardian.earlier import forget
    from labcal.session.audited import note

    if not who:
        raise InputError("who says that these supplies are gone is named in the audit log; nobody was named")
    check_person(who)
    note("gone", who, bench=bench.name, supplies=", ".join(ports))
    forget(bench, ports)


def coils_off_and_stopped(bench: Path) -> tuple[list[AtZero], PlatformReading | None]:
    """As `coils_off`; and a platform that no run has any more is stopped meanwhile. None where that has no motor.

    Where it was not seen to stand soon after the coils were down, its reading has a fault that says so.
    """
    stage = StageStop(bench)
    try:
        ended = shutdown.coils_off(bench, stage.meanwhile, stage.begin)
    finally:
        stage.begin()  # whatever became of the coils
    return ended, stage.ended(STANDS_S)
