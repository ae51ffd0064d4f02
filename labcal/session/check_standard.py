"""The charts of a bench's check standard, and who may begin a run though they are out of control."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, fields
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from labcal import certificate
from labcal.bench.check_standard import CheckStandardConfig
from labcal.bench.config import read_config
from labcal.certificate.agent import signed
from labcal.errors import InputError, OutOfControl
from labcal.files.home import home
from labcal.quality.control_chart import Chart, control_chart
from labcal.record.person import check_person
from labcal.session.figures import SensorFigure, figures_of_run
from labcal.session.from_archive import runs_from_archive
from labcal.session.sources import Source
from labcal.store import RunSummary, Store
from labcal.store.listing import FILE as STORE

KIND = "override"  # of the event in the record
NAMESPACE = "labcal-override"
MEASURED = ("finished", "imported")
KEPT = "from-archive"  # bundles that charts were made of, in labcal's folder
First = tuple[str, str, Mapping[str, Any]]


@dataclass(frozen=True, slots=True)
class Override:
    """A person who lets a run begin though the check standard is out of control, why, and with whose key they sign."""

    who: str
    because: str
    key: str | None = None
    passphrase: str = ""


@dataclass(frozen=True, slots=True, eq=False)
class Charts:
    """The charts of one serial: for each quantity a chart, or why there is none; the runs of each point, in order.

    `not_used` are runs that give no figures, each with a sentence.
    """

    serial: str
    stated: CheckStandardConfig
    points: tuple[tuple[RunSummary, ...], ...]
    of: Mapping[str, Chart | str]
    units: Mapping[str, str]
    not_used: tuple[str, ...] = ()

    @property
    def out(self) -> dict[str, Chart]:
        """Those that are out of control at their last point."""
        return {name: c for name, c in self.of.items() if isinstance(c, Chart) and c.out_of_control}


def charts(
    stated: CheckStandardConfig, *, bench: str | None = None, simulated: bool | None = None, archive: str | None = None
) -> Charts:
    """The charts of what the local store has of the check standard, of one bench's runs where it is named.

    With `archive`, its URL, of all runs there that this role may see. Raises InputError where store or archive cannot
    be read, or simulated runs stand among real ones.
    """
    measured, values, left_out = list[RunSummary](), list[Mapping[str, SensorFigure]](), list[str]()
    found = _runs(stated, bench, simulated) if archive is None else _runs_of_archive(stated, archive)
    for run, source in sorted(found, key=lambda one: one[0].started_utc):
        try:
            values.append(figures_of_run(source))
            measured.append(run)
        except InputError as fault:
            left_out.append(f"{run.run_id}: {fault.what}")
    points = tuple(tuple(measured[i : i + stated.repeats]) for i in range(0, len(measured), stated.repeats))
    of: dict[str, Chart | str] = {name: _chart(stated, name, values) for name in stated.quantities}
    units: dict[str, str] = {name: values[0][name].unit for name in stated.quantities} if values else {}
    return Charts(stated.serial, stated, points, of, units, tuple(left_out))


def charts_of_bench(path: Path) -> Charts:
    """Those of the check standard that a bench file states. Raises InputError where it states none."""
    config = read_config(path)
    if config.check_standard is None:
        raise InputError("states no [check_standard] (docs/years.md)", file=path)
    return charts(config.check_standard, bench=config.name, simulated=config.unreal)


def admitted(path: Path, dut: str | None, procedure: str, run_id: str, override: Override | None) -> First | None:
    """What the record of a run begins with, where a person lets it begin; None where nothing is against it.

    Raises InputError where the check standard is out of control and nobody does, and where somebody answers for
    nothing. Its own runs always may begin.
    """
    config, out = read_config(path), dict[str, str]()
    own = config.check_standard is None or (dut or config.dut.serial) == config.check_standard.serial
    if not own:
        out = {name: why(chart) for name, chart in charts_of_bench(path).out.items()}
    if config.check_standard is None or not out:
        _refuse_needless(override, path)
        return None
    said = "; ".join(f"{name}: {reason}" for name, reason in out.items())
    words = f"the check standard {config.check_standard.serial} is out of control ({said})"
    if override is None:
        raise OutOfControl(
            words,
            f"No procedure begins on this bench: measure it again (--dut {config.check_standard.serial}), or "
            "let a person answer for it: --override NAME --because TEXT",
            file=path,
        )
    return KIND, f"{words}; {override.who} lets the run begin: {override.because}", _statement(
        override, config.name, config.check_standard.serial, out, procedure, run_id
    )  # fmt: skip


def _refuse_needless(override: Override | None, path: Path) -> None:
    if override is not None:
        words = "nothing keeps this run from beginning, so that there is nothing to answer for"
        raise InputError(f"{words}: begin it without --override; nothing was begun", file=path)


def why(chart: Chart) -> str:
    """What is against the last point, in words."""
    from labcal.quality.western_electric import RULES

    said = [RULES[rule] for rule in chart.broken[-1]]
    return ", ".join([*said, *(["a spread beyond its limits"] if chart.spread_out[-1] and not chart.single else [])])


def _statement(
    override: Override, bench: str, serial: str, out: Mapping[str, str], procedure: str, run_id: str
) -> dict[str, Any]:
    """What the person stands for, as text, and their signature of it where they have a key."""
    if not override.who.strip() or not override.because.strip():
        raise InputError("an override has a name and a reason: --override NAME --because TEXT")
    check_person(override.who)
    about = {
        "format": "labcal-override/1", "run_id": run_id, "bench": bench, "procedure": procedure,
        "check_standard": serial, "out_of_control": dict(out), "who": override.who, "because": override.because,
        "utc": datetime.now(UTC).isoformat(timespec="seconds"),
    }  # fmt: skip
    text = json.dumps(about, ensure_ascii=False, sort_keys=True)
    if override.key is None:
        return {"statement": text}
    key = certificate.keys.signing_key(home(), override.key, override.passphrase)
    return {"statement": text, "key": override.key, "signature": signed(text.encode(), key, NAMESPACE)}


def _runs(stated: CheckStandardConfig, bench: str | None, simulated: bool | None) -> list[tuple[RunSummary, Source]]:
    """The runs of the store that count."""
    if not (home() / STORE).is_file():
        return []
    with Store.open() as store:
        found = [r for r in store.runs() if r.dut_serial == stated.serial and r.status in MEASURED]
        found = [r for r in found if r.procedure in (stated.procedure, "")]
        found = [r for r in found if simulated is None or r.simulated == simulated]
        if len({r.simulated for r in found}) > 1:
            raise InputError(f"of {stated.serial} there are simulated and real runs: name its bench file")
        return [(r, r.run_id) for r in found if bench is None or _bench_of(store, r) == bench]


def _runs_of_archive(stated: CheckStandardConfig, given: str) -> list[tuple[RunSummary, Source]]:
    """The runs of the archive that count, each with its bundle, kept in labcal's folder."""
    names = [field.name for field in fields(RunSummary)]
    there = runs_from_archive(given, home() / KEPT, stated.serial)
    found = [(RunSummary(**{name: row[name] for name in names if name in row}), place) for row, place in there]
    if len({run.simulated for run, _ in found}) > 1:
        raise InputError(f"of {stated.serial} the archive has simulated and real runs: they make no chart together")
    return [(run, place) for run, place in found if run.procedure in (stated.procedure, "")]


def _bench_of(store: Store, run: RunSummary) -> str:
    """The name of the bench that a run was recorded on; "" of one that was imported."""
    if run.status == "imported":
        return ""
    try:
        return str(tomllib.loads(store.header(run.run_id).bench).get("name", ""))
    except tomllib.TOMLDecodeError:
        return ""


def _chart(stated: CheckStandardConfig, name: str, values: list[Mapping[str, SensorFigure]]) -> Chart | str:
    """The chart of one quantity, or why there is none yet."""
    of = [one[name].value for one in values]
    groups = [of[i : i + stated.repeats] for i in range(0, len(of), stated.repeats)]
    known: Mapping[Any, float] = stated.sigma
    centre: Mapping[Any, float] = stated.centre
    whole = len(of) // stated.repeats
    if whole < stated.baseline:
        return f"{whole} of the {stated.baseline} points of its baseline are there"
    try:
        return control_chart(
            groups, stated.baseline, sigma=known.get(name), centre=centre.get(name), between=stated.between,
            rules=stated.rules,
        )  # fmt: skip
    except ValueError as fault:
        return str(fault)
