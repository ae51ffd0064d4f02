"""What the worker does with the store, calibrations, keys and reports: each a short word to labcal.session."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import asdict
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from labcal.files.home import home
from labcal.gui.ipc.answers import BudgetLine, CalibrationFile, Checked, Figure, Person, RunLine, Signature, Standing
from labcal.gui.ipc.channel import Channel
from labcal.gui.ipc.handlers import handles
from labcal.gui.ipc.messages import (
    ApplyCalibration,
    Approve,
    ChangedSince,
    CorrectSerial,
    ExportRun,
    FindSimulatedBench,
    ImportBundle,
    KeepPhoto,
    LastCageCheck,
    LastClosingCheck,
    ListCalibrations,
    ListKeys,
    ListPeople,
    ListRuns,
    NewKey,
    Progress,
    Sign,
    VerifyFile,
    WriteLabel,
    WriteReport,
)
from labcal.record.specification import UNITS
from labcal.uncertainty.conformity import LEFT_OPEN, Changes, Judged, stated_lines
from labcal.uncertainty.conformity.change import SHOWN
from labcal.uncertainty.conformity.decision import Measured
from labcal.uncertainty.conformity.of_the_map import figures_of_the_map

if TYPE_CHECKING:
    from labcal.certificate import Stated, Verification
    from labcal.model import Calibration
    from labcal.store import RunSummary

WORST = ("", "PASS", "CANNOT DECIDE", "MARGINAL", "FAIL")
UNDECIDED = WORST[2]
LOOKED_BACK = 8  # runs, for the last closing check


def runs(channel: Channel, asked: ListRuns) -> tuple[RunLine, ...]:
    """The runs of the store, the newest first, each with the verdict of its loop where there is one."""
    from labcal import session

    loops = {path.name.split(".")[0]: json.loads(path.read_text()) for path in sorted(_folder().glob("*.loop"))}
    return tuple(_line(one, loops.get(one.run_id)) for one in reversed(session.runs()))


def _line(one: RunSummary, loop: Mapping[str, Any] | None = None) -> RunLine:
    if loop is None:
        return RunLine(**asdict(one))
    left = loop["before"]["holdout_rms_nT"], loop["after"]["holdout_rms_nT"], loop["noise_floor_nT"]
    return RunLine(**asdict(one), verdict=loop["verdict"], left_nT=left)


def closing(channel: Channel, asked: LastClosingCheck) -> Checked | None:
    """The last run that was closed: when, which, and its worst result, of a closure or not: a run has one verdict."""
    from labcal import session
    from labcal.session.checks import not_measured, results, worst
    from labcal.store import Store

    finished = (one for one in reversed(session.runs()) if one.status == "finished")
    with Store.open() as store:
        for one in islice(finished, LOOKED_BACK):
            items = list(store.items(one.run_id, but="block"))
            found = results(items)
            if any("closure" in name for name in found) and (least := worst(found)) is not None:
                open_yet = least.verdict == "PASS" and any("closure" in one for one in not_measured(items, found))
                return Checked(_line(one), least, UNDECIDED if open_yet else least.verdict)
    return None


def cage_check(channel: Channel, asked: LastCageCheck) -> Checked | None:
    """The last finished cage-calibration there is, and its worst measurement that has a limit."""
    from labcal import session
    from labcal.record.stream import Measurement
    from labcal.store import Store

    last = next(
        (r for r in reversed(session.runs()) if (r.procedure, r.status) == ("cage-calibration", "finished")), None
    )
    if last is None:
        return None
    with Store.open() as store:
        judged = [i for i in store.items(last.run_id, but="block") if isinstance(i, Measurement) and i.limit]
    worst = max(judged, key=lambda m: abs(m.value) / (m.limit or 1.0), default=None)
    return Checked(_line(last), worst, max((m.verdict for m in judged), key=WORST.index, default=""))


def calibrations(channel: Channel, asked: ListCalibrations) -> tuple[CalibrationFile, ...]:
    """Every calibration file of this lab's folder, the newest first."""
    paths = sorted(_folder().glob("*.json"), key=lambda path: path.name, reverse=True)
    return tuple(map(_calibration, paths))


def _calibration(path: Path) -> CalibrationFile:
    """What a calibration file says, and how its signatures stand."""
    from labcal import session
    from labcal.model.effects import phrases

    found = session.load_calibration(path)
    covariance = found.covariance
    return CalibrationFile(
        path=str(path),
        run_id=found.run_id,
        dut=found.dut,
        K=found.affine.K.tolist(),
        k_nT=found.affine.k_nT.tolist(),
        k_means=found.k_means(),
        u=None if covariance is None else np.sqrt(np.diag(covariance)[:12]).tolist(),
        budget=tuple(map(_budget_line, found.budget)),
        effects=found.effects,
        findings=found.findings,
        operator=found.operator,
        approvers=found.approvers,
        simulated=found.simulated,
        standing=_standing(path, session.verify(path, only_kept=True)),
        specification=stated_lines(found),
        until=found.validity.until or "",
        left_open=tuple(said for said in found.not_covered if said.startswith(LEFT_OPEN)),
        figures=figures(found),
        method=str((found.made_by or {}).get("method", "")),
        unexplained=found.unexplained(),
        not_measured=found.not_measured(),
        left_nT=found.metrics.get("after", {}).get("holdout_rms_scalar_nT"),
        phrases=phrases(),
    )


def figures(found: Calibration) -> tuple[Figure, ...]:
    """Offsets, scale factors and angles of the map, each with its limit where it was judged by one."""
    limits = {line.quantity: line for line in stated_lines(found)}
    return tuple(_figure(one, limits.get(one.quantity)) for one in figures_of_the_map(found))


def _figure(one: Measured, judged: Judged | None) -> Figure:
    factor, unit = SHOWN[one.figure]
    U = 2 * one.u / factor if np.isfinite(one.u) else None
    limit = None if judged is None else judged.limit * UNITS[one.figure][judged.unit] / factor
    return Figure(one.figure, one.quantity, one.value / factor, U, unit, limit)


def _budget_line(stated: Mapping[str, Any]) -> BudgetLine:
    shares = sorted(((row["source"], row["share"]) for row in stated["rows"]), key=lambda one: -one[1])
    return BudgetLine(stated["quantity"], stated["at"], stated["U"], stated["k"], stated["unit"], tuple(shares))


def verify(channel: Channel, asked: VerifyFile) -> Standing:
    """Check a file that somebody dropped."""
    from labcal import session

    return _standing(Path(asked.path), session.verify(Path(asked.path), progress=_progress_to(channel)))


def _standing(path: Path, verification: Verification) -> Standing:
    return Standing(
        path=str(path),
        status=verification.status,
        valid=verification.valid,
        provisional=bool(verification.provisional),
        signers=tuple(verification.signers),
        signatures=tuple(Signature(c.file.name, c.principal, c.objection) for c in verification.checks),
        sentences=tuple(verification.sentences()),
    )


def keys(channel: Channel, asked: ListKeys) -> tuple[str, ...]:
    """Names with a private key here."""
    from labcal import session

    return tuple(sorted({e.signer.principal for e in session.trusted_keys() if e.private_key_here and not e.revoked}))


def people(channel: Channel, asked: ListPeople) -> tuple[Person, ...]:
    """Who has a role by the trust list, revoked ones left out."""
    from labcal import session

    there, _ = session.listed_keys()
    signers = [entry.signer for entry in there if not entry.revoked]
    roles = {one.principal: tuple(sorted(one.roles)) for one in signers if one.roles}
    return tuple(Person(name, roles[name]) for name in sorted(roles))


def new_key(channel: Channel, asked: NewKey) -> str:
    """Make a key."""
    from labcal import session

    _may_sign(asked.name)
    session.new_key(asked.name, asked.passphrase)
    return asked.name


def _may_sign(name: str) -> None:
    from labcal.certificate.allowed_signers import check_principal
    from labcal.errors import InputError

    try:
        check_principal(name)
    except ValueError:
        raise InputError(
            f"No key can bear the name {name!r}: use letters, digits and . _ @ + - without blanks, as in ada.smith"
        ) from None


def approve(channel: Channel, asked: Approve) -> CalibrationFile:
    """Write the approver into the draft. Raises InputError where no key can bear that name: they could never sign."""
    from labcal import session

    _may_sign(asked.name)
    session.approve(Path(asked.path), asked.name, _progress_to(channel), _stated(asked))
    return _calibration(Path(asked.path))


def _stated(asked: Approve | Sign) -> Stated:
    from labcal.certificate import stated_by_people

    return stated_by_people(asked.until or None, Path(asked.supersedes) if asked.supersedes else None)


def sign(channel: Channel, asked: Sign) -> CalibrationFile:
    """Sign; the passphrase is used and forgotten."""
    from labcal import certificate, session

    if (stated := _stated(asked)) != certificate.Stated():
        certificate.state(Path(asked.path), stated)
    session.sign(Path(asked.path), asked.name, asked.passphrase, _progress_to(channel))
    return _calibration(Path(asked.path))


def report(channel: Channel, asked: WriteReport) -> str:
    """Write the report of a run or a calibration."""
    from labcal import session

    session.report(asked.source, Path(asked.out), force=True)  # the dialogue has asked
    return asked.out


def label(channel: Channel, asked: WriteLabel) -> str:
    """Write the label for the DUT of a calibration."""
    from labcal import session

    session.label(Path(asked.source), Path(asked.out), force=True)  # the dialogue has asked
    return asked.out


def export(channel: Channel, asked: ExportRun) -> str:
    """Write a run as bundle, csv, hdf5 or mat."""
    from labcal import session

    session.export_run(asked.run, asked.format, Path(asked.out), force=True)
    return asked.out


def import_bundle(channel: Channel, asked: ImportBundle) -> str:
    """Take a bundle into the store."""
    from labcal import session

    return session.import_bundle(Path(asked.path))


def photo(channel: Channel, asked: KeepPhoto) -> Mapping[str, str]:
    """Keep a photograph; what a note says of it."""
    from labcal import session

    return session.keep_photo(Path(asked.path))


def correct_serial(channel: Channel, asked: CorrectSerial) -> str:
    """State another serial of a run's DUT, until a calibration of it is signed."""
    from labcal import session

    session.correct_serial(asked.run, asked.serial, asked.who, sorted(_folder().glob(f"{asked.run}*.json")))
    return asked.serial


def apply(channel: Channel, asked: ApplyCalibration) -> str:
    """Correct readings by a calibration; says how many rows, and how many of them carry a flag."""
    from labcal import session

    applied = session.apply_calibration(
        Path(asked.path), Path(asked.source), Path(asked.out), asked.dut or None, force=True
    )
    return f"{applied.rows} rows, {applied.rows - applied.flags['']} with a flag: {asked.out}"


def changed_since(channel: Channel, asked: ChangedSince) -> Changes | None:
    """What changed since the calibration before it in this lab's folder."""
    from labcal import session

    return session.changed_since(session.load_calibration(Path(asked.path)))


def simulated_bench(channel: Channel, asked: FindSimulatedBench) -> str:
    """The bench file of the simulated lab."""
    from labcal.demo import simulated_bench as found

    return str(found())


def _progress_to(channel: Channel) -> Callable[[str], None]:
    """What hears each step of working a calibration out again."""
    return lambda step: channel.send(Progress(step))


def _folder() -> Path:
    return home() / "calibrations"


HANDLERS = (
    handles(ListRuns, runs),
    handles(LastClosingCheck, closing),
    handles(LastCageCheck, cage_check),
    handles(ListCalibrations, calibrations),
    handles(VerifyFile, verify),
    handles(ListKeys, keys),
    handles(ListPeople, people),
    handles(NewKey, new_key),
    handles(Approve, approve),
    handles(Sign, sign),
    handles(WriteReport, report),
    handles(WriteLabel, label),
    handles(ExportRun, export),
    handles(ImportBundle, import_bundle),
    handles(KeepPhoto, photo),
    handles(CorrectSerial, correct_serial),
    handles(ApplyCalibration, apply),
    handles(ChangedSince, changed_since),
    handles(FindSimulatedBench, simulated_bench),
)
