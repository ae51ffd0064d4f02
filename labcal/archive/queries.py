"""What the archive is asked: its runs, and which calibrations a reference, a change or an effect concerns."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import Any

from sqlalchemy import ColumnElement, Label, Select, Subquery, and_, case, func, literal, or_, select, tuple_
from sqlalchemy.sql.elements import KeyedColumnElement

from labcal.archive.server import Archive
from labcal.archive.tables import CALIBRATION, DOCUMENT, EFFECT, INSTRUMENT, PARAMETER, RUN
from labcal.errors import InputError

COVERAGE = 2.0  # k of U, as in `labcal compare`
FIGURE = "figure"
Column = KeyedColumnElement[Any]
Condition = ColumnElement[bool]
LISTED_RUN = (
    *("site", "run_id", "started_utc", "status", "simulated", "dut_serial", "dut_model", "procedure", "operator"),
    *("reference_serial", "n_samples", "sha256", "bundle_sha256", "bundle_bytes", "pushed_utc", "pushed_by"),
)
LISTED_CALIBRATION = (
    *("site", "run_id", "measured_utc", "simulated", "dut_serial", "dut_model", "number", "sha256", "run_sha256"),
)
BEGAN = select(RUN.c.sha256, func.min(RUN.c.started_utc).label("utc")).group_by(RUN.c.sha256).subquery("began")
MEASURED = (  # when its run began, as far as that is there
    select(CALIBRATION, func.coalesce(BEGAN.c.utc, CALIBRATION.c.issued_utc).label("measured_utc"))
    .outerjoin(BEGAN, BEGAN.c.sha256 == CALIBRATION.c.run_sha256)
    .subquery("made")
)


@dataclass(frozen=True, slots=True)
class CalibrationQuery:
    """Which calibrations: all conditions that are stated hold together. Times bound when their runs began.

    `instrument` is a serial, the reference's or another's; `effect` an effect that was found, `above` (value, unit):
    with a parameter of that unit whose size is larger; `changed`: a figure differs from that of the calibration before
    of the same DUT by more than U of the difference (k = 2).
    """

    model: str | None = None
    dut: str | None = None
    instrument: str | None = None
    since: datetime | None = None
    until: datetime | None = None
    effect: str | None = None
    above: tuple[float, str] | None = None
    changed: bool = False


def runs(archive: Archive) -> list[dict[str, Any]]:
    """All runs that this role may see, the oldest first."""
    listed = select(*(RUN.c[name] for name in LISTED_RUN)).order_by(RUN.c.started_utc, RUN.c.site, RUN.c.run_id)
    return _plain(archive, listed)


def runs_named(archive: Archive, run: str, site: str | None) -> list[dict[str, Any]]:
    """The run of this SHA-256, else of this id, else whose SHA-256 begins so: a row for each site that has it.

    Raises InputError where there is none, or several runs are called so.
    """
    begins = and_(func.length(literal(run)) >= 8, RUN.c.sha256.startswith(run, autoescape=True))
    listed = select(*(RUN.c[name] for name in LISTED_RUN)).where(or_(RUN.c.run_id == run, begins))
    found = _plain(archive, (listed if site is None else listed.where(RUN.c.site == site)).order_by(RUN.c.pushed_utc))
    if not found:
        raise InputError(f"{archive.address.shown}: there is no run {run!r}; `labcal runs --archive` lists them")
    found = [one for one in found if one["sha256"] == run] or found  # a name that is another's hash hides nothing
    if len({one["sha256"] for one in found}) > 1:
        each = ", ".join(f"{one['site']}: {one['sha256'][:12]}" for one in found[:5])
        raise InputError(
            f"{archive.address.shown}: there are {len(found)} runs {run!r} ({each}): name one by its SHA-256"
        )
    return found


def came_utc(archive: Archive, digests: Sequence[str]) -> dict[str, datetime]:
    """When the signatures of these SHA-256 came to the archive first, by its server's clock; those that are there."""
    c = DOCUMENT.c
    listed = select(c.sha256, func.min(c.pushed_utc)).where(c.kind == "signature", c.sha256.in_(digests))
    with archive.transaction() as connection:
        return {str(digest): utc for digest, utc in connection.execute(listed.group_by(c.sha256))}


def superseding(archive: Archive, sha256: str) -> list[tuple[bytes, list[bytes]]]:
    """The calibrations that state to supersede the file of this SHA-256: bytes, and signatures as they came."""
    c, d = CALIBRATION.c, DOCUMENT.c
    with archive.transaction() as connection:
        found = connection.execute(select(c.site, c.sha256, c.content).where(c.supersedes == sha256)).all()
        each = []
        for site, digest, content in found:
            listed = select(d.content).where(d.site == site, d["of"] == digest, d.kind == "signature")
            each.append((content, list(connection.scalars(listed.order_by(d.pushed_utc, d.name)))))
        return each


def calibrations(archive: Archive, wanted: CalibrationQuery) -> list[dict[str, Any]]:
    """The calibrations that are wanted, the oldest first, each with its reference, signers, and what fits (`why`)."""
    if wanted.above is not None and wanted.effect is None:
        raise InputError("a size is that of an effect's parameter: say which effect")
    c = MEASURED.c
    listed = select(*(c[name] for name in LISTED_CALIBRATION), _reference(), _signers(), _superseded())
    for condition in _conditions(wanted):
        listed = listed.where(condition)
    shown = []
    if wanted.changed:
        change = _largest_change()
        listed = listed.join(change, _largest_of(change))
        shown += [change.c[name] for name in ("figure", "found", "left", "U", "unit", "e_n")]
    if wanted.effect is not None:
        size = _largest_parameter(wanted.effect, wanted.above)
        listed = listed.join(size, _largest_of(size))
        shown += [size.c[name] for name in ("parameter", "value", "u", "parameter_unit")]
    return _plain(archive, listed.add_columns(*shown).order_by(c.measured_utc, c.site, c.sha256))


def files_of(archive: Archive, dut: str) -> list[tuple[dict[str, Any], bytes]]:
    """The calibrations of a DUT that have a date, the oldest first: their rows, and the bytes of their files."""
    c = MEASURED.c
    listed = select(*(c[name] for name in LISTED_CALIBRATION), c.content)
    mine = listed.where(c.dut_serial == dut, c.measured_utc.is_not(None))
    rows = _plain(archive, mine.order_by(c.measured_utc, c.site, c.sha256))
    return [(row, bytes(row.pop("content"))) for row in rows]


def _largest_of(found: Subquery) -> Condition:
    mine = (found.c.site == MEASURED.c.site, found.c.calibration == MEASURED.c.sha256)
    return and_(*mine, found.c.place == 1)


def _conditions(wanted: CalibrationQuery) -> list[Condition]:
    c = MEASURED.c
    found = [c.dut_model == wanted.model] if wanted.model is not None else []
    found += [c.dut_serial == wanted.dut] if wanted.dut is not None else []
    found += [or_(c.measured_utc >= wanted.since, c.measured_utc.is_(None))] if wanted.since is not None else []
    found += [or_(c.measured_utc < wanted.until, c.measured_utc.is_(None))] if wanted.until is not None else []
    found += [_made_with(wanted.instrument)] if wanted.instrument is not None else []
    return found


def _made_with(serial: str) -> Condition:
    """The calibration itself, or its run, names an instrument of this serial."""
    i, c = INSTRUMENT.c, MEASURED.c
    used = select(i.site, i["of"]).where(i.serial == serial)
    return or_(tuple_(c.site, c.sha256).in_(used), tuple_(c.site, c.run_sha256).in_(used))


def _reference() -> Column:
    i, c = INSTRUMENT.c, MEASURED.c
    own = select(func.max(i.serial)).where(i.site == c.site, i["of"] == c.sha256, i.name == "reference")
    return own.scalar_subquery().label("reference_serial")


def _signers() -> Column:
    """Names of those whose signature held where it was pushed from."""
    d, c = DOCUMENT.c, MEASURED.c
    of = (d.site == c.site, d["of"] == c.sha256, d.kind == "signature", d.objection == "")
    named = select(func.string_agg(d.signer, literal(", "))).where(*of)
    return func.coalesce(named.scalar_subquery(), "").label("signers")


def _superseded() -> Column:
    """The run of a later calibration, with the site where that is not this one's: it is what that site states."""
    later = CALIBRATION.alias("later")
    named = case((later.c.site == MEASURED.c.site, later.c.run_id), else_=later.c.run_id + " of " + later.c.site)
    by = select(func.max(named)).where(later.c.supersedes == MEASURED.c.sha256)
    return by.scalar_subquery().label("superseded_by")


def _largest_parameter(effect: str, above: tuple[float, str] | None) -> Subquery:
    """Of each calibration with this effect its largest parameter, of those above the bound where one is stated."""
    p = PARAMETER.c
    columns = (p.site, p.calibration, p.name.label("parameter"), p.value, p.u, p.unit.label("parameter_unit"))
    of = select(*columns, _place(p.site, p.calibration, p.value)).where(p["of"] == effect)
    if above is not None:
        of = of.where(func.abs(p.value) > above[0], p.unit == above[1])
    return of.subquery("size")


def _largest_change() -> Subquery:
    """Of each calibration the figure that changed most since the one before of the same DUT, in units of U."""
    c = _changes().c
    return select(*c, _place(c.site, c.calibration, c.e_n)).where(func.abs(c.e_n) > 1).subquery("change")


def _place(site: Column, calibration: Column, value: Column) -> Label[int]:
    """1 for the largest value of a calibration, in either direction."""
    order = (func.abs(value).desc(), value)
    return func.row_number().over(partition_by=(site, calibration), order_by=order).label("place")


def _changes() -> Subquery:
    """Every figure beside that of the calibration before, of whichever site: E_n as `labcal compare` has it."""
    pair, new, old = _pairs().c, PARAMETER.alias("new").c, PARAMETER.alias("old").c
    U = COVERAGE * func.sqrt(new.u * new.u + old.u * old.u)
    e_n = ((new.value - old.value) / func.nullif(U, 0.0)).label("e_n")
    own = and_(new.site == pair.site, new.calibration == pair.sha256, new["of"] == FIGURE)
    before = and_(old.site == pair.site_before, old.calibration == pair.before, old["of"] == FIGURE)
    figures = (new.name.label("figure"), old.value.label("found"), new.value.label("left"), U.label("U"), new.unit)
    joined = pair.site.table.join(new.site.table, own).join(old.site.table, and_(before, old.name == new.name))
    return select(new.site, new.calibration, *figures, e_n).select_from(joined).subquery()


def _pairs() -> Subquery:
    """Each calibration with the one before of the same DUT, read in the same unit."""
    c = MEASURED.c
    same, order = (c.dut_serial, c.dut_model, c.dut_unit, c.simulated), (c.measured_utc, c.issued_utc, c.sha256, c.site)
    site, before = (func.lag(column).over(partition_by=same, order_by=order) for column in (c.site, c.sha256))
    pairs = select(c.site, c.sha256, site.label("site_before"), before.label("before"))
    return pairs.where(c.measured_utc.is_not(None)).subquery("pair")


def _plain(archive: Archive, asked: Select[Any]) -> list[dict[str, Any]]:
    """The rows as JSON has them."""
    with archive.transaction() as connection:
        found = connection.execute(asked).mappings().all()
    return [{name: _json_value(value) for name, value in row.items()} for row in found]


def _json_value(value: Any) -> Any:
    return value.isoformat(timespec="milliseconds").replace("+00:00", "Z") if isinstance(value, datetime) else value


def parameters(archive: Archive, wanted: CalibrationQuery) -> list[dict[str, Any]]:
    """The figures, and the parameters of effects, of the calibrations that are wanted, the oldest first."""
    c, p, e = MEASURED.c, PARAMETER.c, EFFECT.c
    mine = and_(p.site == c.site, p.calibration == c.sha256, p["of"] != "map")
    found = and_(e.site == c.site, e.calibration == c.sha256, e.effect == p["of"])
    effect = select(func.max(e.belongs_to)).where(found).scalar_subquery().label("belongs_to")
    channels = select(func.max(e.channels)).where(found).scalar_subquery().label("channels")
    listed = select(*(c[name] for name in LISTED_CALIBRATION), p["of"], p.name, p.value, p.u, p.unit, effect, channels)
    for condition in _conditions(wanted):
        listed = listed.where(condition)
    joined = listed.join_from(c.site.table, p.site.table, mine)
    return _plain(archive, joined.order_by(c.measured_utc, c.site, c.sha256, p.number))
