"""What goes into the archive, and what is asked of it. Its libraries (the extra `archive`) load with the first use."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from datetime import datetime
from functools import partial
from pathlib import Path
from time import sleep
from typing import TYPE_CHECKING, Any, Literal, NoReturn

from labcal.errors import InputError
from labcal.files.outputs import claim
from labcal.session.opened_archive import archive_address, needing_the_extra, opened, place_of_bundles
from labcal.store import Bundle, save_bundle

if TYPE_CHECKING:
    from labcal.model import Calibration
    from labcal.session.pushing import Pushed

OnRemark = Callable[[str], None]


def init_archive(given: str | None, bundles: str | None) -> str:
    """Make the catalogue or bring it up to date, and state where bundles lie; returns what to tell."""
    with needing_the_extra():
        from labcal.archive import server, versions

        with server.opened(archive_address(given)) as archive:
            made = versions.make(archive, bundles)
            return f"{archive.address.shown}: catalogue of version {made}"


def grant_in_archive(given: str | None, role: str, lab: str, duty: Literal["read", "push", "nothing"]) -> None:
    """Let a PostgreSQL role see a lab's rows, add to them as well, or neither any more."""
    with opened(given) as archive:
        from labcal.archive.rights import grant

        grant(archive, role, lab, duty)


def archived_runs(given: str | None) -> list[dict[str, Any]]:
    """The runs of the archive that this role may see, the oldest first."""
    with opened(given) as archive:
        from labcal.archive.queries import runs

        return runs(archive)


def archived_calibrations(given: str | None, **wanted: Any) -> list[dict[str, Any]]:
    """The calibrations of the archive that are `wanted` (labcal.archive.queries.CalibrationQuery), the oldest first."""
    with opened(given) as archive:
        from labcal.archive.queries import CalibrationQuery, calibrations

        return calibrations(archive, CalibrationQuery(**wanted))


def archived_files(given: str | None, dut: str) -> list[tuple[dict[str, Any], Calibration]]:
    """The calibrations of one DUT in the archive, the oldest first: what is listed of each, and what its file says.

    A file that is none, or of another DUT than its row says, is left out: `check_archive` reports it.
    """
    from labcal.certificate import parse_calibration

    with opened(given) as archive:
        from labcal.archive.queries import files_of

        rows = files_of(archive, dut)
    found: list[tuple[dict[str, Any], Calibration]] = []
    for row, content in rows:
        with suppress(InputError):
            found.append((row, parse_calibration(content, Path(f"{row['site']}: {row['run_id']}"))))
    return [(row, made) for row, made in found if made.dut.serial == dut]


def archived_parameters(given: str | None, **wanted: Any) -> list[dict[str, Any]]:
    """Figures and effects' parameters of the calibrations of the archive that are `wanted`, the oldest first."""
    with opened(given) as archive:
        from labcal.archive.queries import CalibrationQuery, parameters

        return parameters(archive, CalibrationQuery(**wanted))


def fetch_from_archive(given: str | None, run: str, site: str | None, out: Path, *, force: bool = False) -> None:
    """Write the bundle of a run of the archive to `out`, a zip, its SHA-256 looked at."""
    [output] = claim("archive", out, force=force)
    if out.suffix.lower() != ".zip":
        raise InputError("a bundle from the archive is a zip: name it so", file=out)
    bundle = bundle_from_archive(given, run, site)
    with output.writing():
        save_bundle(bundle, out)


def bundle_from_archive(given: str | None, run: str, site: str | None = None) -> Bundle:
    """The bundle of a run of the archive, its SHA-256 looked at."""
    with opened(given) as archive:
        from labcal.archive.queries import runs_named
        from labcal.session.archive_check import bundle_of_row

        return _first_whole(partial(bundle_of_row, place_of_bundles(archive)), runs_named(archive, run, site))


def _first_whole(bundle: Callable[[dict[str, Any]], Bundle], rows: list[dict[str, Any]]) -> Bundle:
    """The bundle of the first site whose is what its row says. Raises InputError where none is."""
    for row in rows[:-1]:
        with suppress(InputError):
            return bundle(row)
    return bundle(rows[-1])


def check_archive(given: str | None, bundles: str | None, on_remark: OnRemark = lambda one: None) -> list[str]:
    """A sentence for each run and calibration of which the archive says something else than its bundle or file."""
    with opened(given) as archive:
        from labcal.session.archive_check import faults

        return list(faults(archive, place_of_bundles(archive, bundles), on_remark))


def push(
    given: str | None, names: Sequence[str] = (), bundles: str | None = None, on_remark: OnRemark = lambda one: None
) -> Pushed:
    """Push the runs and calibrations that are named, else all that is finished here and not there yet.

    The audit log goes with them. `on_remark` gets each that is new. Raises InputError where the server is away.
    """
    with opened(given, made=True) as archive:
        from labcal.session.pushing import Pusher

        return Pusher.at(archive, bundles, on_remark).push(names)


def push_every(
    seconds: float,
    given: str | None,
    names: Sequence[str],
    bundles: str | None,
    on_remark: OnRemark,
    wait: Callable[[float], object] = sleep,
) -> NoReturn:
    """Push again and again, until somebody stops it; `on_remark` gets what is new."""
    said = set[str]()
    with needing_the_extra():
        from labcal.archive.server import AwayError
    while True:
        try:
            now = set(push(given, names, bundles, on_remark).refused)
        except AwayError as away:
            now = {str(away)}
        for remark in sorted(now - said):
            on_remark(remark)
        said = now
        wait(seconds)


def as_moment(text: str | None) -> datetime | None:
    """The moment that a date or an ISO 8601 text states. Raises InputError."""
    if text is None:
        return None
    from labcal.archive.rows import utc

    return utc(text)
