"""Calibrations over the years, from files, this lab's folder or the archive: when, of what, and what was found."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from labcal import session
from labcal.certificate import looks_like_calibration
from labcal.errors import InputError
from labcal.files.home import home
from labcal.model import Calibration
from labcal.session.figures import SensorFigure, figures_of_calibration
from labcal.session.signing import CALIBRATIONS, SUPERSEDING

DAYS_A_YEAR = 365.25
UNDATED = datetime.min.replace(tzinfo=UTC)  # nothing tells when it was measured
OnRemark = Callable[[str], None]


@dataclass(frozen=True, slots=True)
class Calibrated:
    """One calibration: where it is kept, of which DUT, when its run began, how long that took, and what was found.

    `effects` {"offset-current i_eps c_x": figure} are the parameters of effects of the sensor.
    """

    where: str
    serial: str
    model: str
    utc: datetime
    simulated: bool
    figures: Mapping[str, SensorFigure]
    effects: Mapping[str, SensorFigure]
    hours: float = 0.0

    @property
    def days(self) -> float:
        """Since the epoch."""
        return self.utc.timestamp() / 86_400


def from_files(
    paths: Iterable[Path], on_remark: OnRemark = lambda one: None, *, undated: bool = False
) -> list[Calibrated]:
    """Those of files and folders, the oldest first; `on_remark` gets those in folders that are passed over, and why.

    Raises InputError where a file that is named is none, or nothing tells when it was measured; `undated` ones are
    taken, as UNDATED, where they are asked for.
    """
    started, found = _started(), dict[str, Calibrated]()
    for path, named in _files(paths):
        try:
            calibration = session.load_calibration(path)
            found.setdefault(calibration.run_sha256, _calibrated(calibration, path, started, undated=undated))
        except InputError as fault:
            if named:
                raise
            on_remark(f"passed over: {fault}")
    return sorted(found.values(), key=lambda one: one.utc)


def of_this_lab(on_remark: OnRemark = lambda one: None, *, undated: bool = False) -> list[Calibrated]:
    """Those of this lab's folder, the oldest first."""
    folders = [p for p in (home() / CALIBRATIONS, home() / SUPERSEDING) if p.is_dir()]
    return from_files(folders, on_remark, undated=undated)


def from_archive(given: str | None, *, model: str | None = None, serial: str | None = None) -> list[Calibrated]:
    """Those of the archive that this role may see, the oldest first; what has no date is left out."""
    from labcal.session.archiving import archived_parameters

    rows = archived_parameters(given, model=model, dut=serial)
    grouped: dict[tuple[str, str], list[dict[str, Any]]] = {}
    for row in rows:
        grouped.setdefault((row["site"], row["sha256"]), []).append(row)
    found = [_archived(group) for group in grouped.values() if group[0]["measured_utc"] is not None]
    return sorted(found, key=lambda one: one.utc)


def of_one_sensor(calibrations: Sequence[Calibrated], serial: str) -> list[Calibrated]:
    """Those of one serial. Raises InputError where there is none, or simulated ones stand among real ones."""
    found = [one for one in calibrations if one.serial == serial]
    if not found:
        raise InputError(f"there is no calibration of {serial} here")
    if len({one.simulated for one in found}) > 1:
        raise InputError(f"of {serial} there are simulated and real calibrations: name the files that belong together")
    return found


def _files(paths: Iterable[Path]) -> Iterator[tuple[Path, bool]]:
    """Every calibration file, and whether it was named itself."""
    for path in paths:
        if path.is_dir():
            yield from ((p, False) for p in sorted(path.rglob("*.json")) if looks_like_calibration(p))
        else:
            yield path, True


def _started() -> dict[str, str]:
    """When the runs of the local store began, by id; nothing where there is no store."""
    try:
        return {run.run_id: run.started_utc for run in session.runs()}
    except InputError:
        return {}


def _calibrated(calibration: Calibration, path: Path, started: Mapping[str, str], *, undated: bool) -> Calibrated:
    stated = started.get(calibration.run_id) or calibration.issued_utc
    if stated is None and not undated:
        raise InputError(
            "nothing tells when it was measured: its run is not in this store, and it has no date of issue", file=path
        )
    span = (calibration.span_s[1] - calibration.span_s[0]) / 3600
    dut = calibration.dut
    effects = {_named(e.effect, e.channels, p.name): SensorFigure(p.name, p.value, p.u, p.unit)
               for e in calibration.effects for p in e.parameters}  # fmt: skip
    figures = figures_of_calibration(calibration)
    utc = moment(stated) if stated else UNDATED
    return Calibrated(path.name, dut.serial, dut.model, utc, calibration.simulated, figures, effects, span)


def _named(effect: str, channels: Sequence[str], parameter: str) -> str:
    return " ".join((effect, *channels, parameter))


def _archived(rows: list[dict[str, Any]]) -> Calibrated:
    first, figures, effects = rows[0], dict[str, SensorFigure](), dict[str, SensorFigure]()
    for row in rows:
        one = SensorFigure(row["name"], row["value"], row["u"], row["unit"])
        if row["of"] == "figure":
            figures[one.quantity] = one
        elif row["belongs_to"] == "sensor":
            effects[_named(row["of"], (row["channels"] or "").split(), one.quantity)] = one
    where = f"{first['site']}: {first['run_id']}"
    utc = moment(first["measured_utc"])
    return Calibrated(where, first["dut_serial"], first["dut_model"], utc, first["simulated"], figures, effects)


def moment(stated: str) -> datetime:
    """The moment of an ISO 8601 text; without a zone it is UTC. Raises InputError."""
    try:
        found = datetime.fromisoformat(stated)
    except ValueError:
        raise InputError(f"{stated!r} is no date such as 2026-11-23") from None
    return found if found.tzinfo else found.replace(tzinfo=UTC)
