"""Reports of runs and certificates of calibrations, as files for people and for programs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from labcal import certificate
from labcal.certificate.dcc import read_xml_key, write_dcc
from labcal.certificate.laboratory import FILE as LABORATORY
from labcal.certificate.laboratory import administrative_of
from labcal.certificate.report import Circumstances, calibration_page, run_page, write_report
from labcal.certificate.report.front import images_in
from labcal.certificate.report.label import write_label
from labcal.errors import InputError
from labcal.files.home import home
from labcal.files.outputs import claim
from labcal.fit import fit
from labcal.model import Calibration
from labcal.record import Run, RunHeader
from labcal.session.checks import open_words
from labcal.session.numbering import header_of
from labcal.session.records import runs
from labcal.session.signing import CALIBRATIONS, verify
from labcal.session.sources import paths, run_bundle, run_of
from labcal.session.told import told
from labcal.uncertainty.conformity import Changes

THIS_LAB = "this lab's trust list"


@dataclass(frozen=True, slots=True)
class XmlKeyFiles:
    """Files in PEM of who signs a DCC's XML: key and certificates; `ask` asks for the passphrase of a locked key."""

    key: Path
    certificates: Path
    ask: Callable[[], str]


def report(
    source: str,
    out: Path,
    allowed_signers: Path | None = None,
    *,
    before: Path | None = None,
    xml_key: XmlKeyFiles | None = None,
    on_remark: Callable[[str], None] = lambda remark: None,
    force: bool = False,
) -> None:
    """Write the report of a calibration file or of a run, as `.html` or `.pdf`; a calibration's also as DCC `.xml`.

    `xml_key` signs a DCC's XML. Raises InputError where it is given for anything else.

    A calibration's page and DCC say what changed since `before`, else since the lab's own before it, if there is one.
    `on_remark` gets what a DCC lacks, by the clause that asks for it, and what a PDF is not.
    """
    read = [*paths(source), *(file for file in (allowed_signers, before) if file)]
    read += [xml_key.key, xml_key.certificates] if xml_key else []
    if xml_key and not (out.suffix.lower() == ".xml" and certificate.looks_like_calibration(Path(source))):
        raise InputError("a key with a certificate signs the DCC of a calibration alone: name a FILE.xml", file=out)
    [output] = claim("report", out, inputs=read, force=force)
    with output.writing():
        if certificate.looks_like_calibration(Path(source)):
            _report_calibration(Path(source), out, allowed_signers, before, on_remark, xml_key)
            return
        bundle = run_bundle(source)
        run = bundle.run()
        write_report(run_page(run, bundle.sha256, fit(run, holdout=False), bundle.stated_chain), out)


def label(calibration: Path, out: Path, allowed_signers: Path | None = None, *, force: bool = False) -> None:
    """Write the label for the DUT of a calibration, as `.pdf`, `.svg` or `.png`. Raises InputError."""
    if not certificate.looks_like_calibration(calibration):
        raise InputError("a label is made of a calibration: name its file", file=calibration)
    read = [calibration, *([allowed_signers] if allowed_signers else [])]
    [output] = claim("report", out, inputs=read, force=force)
    with output.writing():
        checked = verify(calibration, allowed_signers)
        found = certificate.parse_calibration(checked.content, calibration)
        run = run_of(found)
        stated = _circumstances(found, run, calibration).administrative.laboratory
        write_label(found, checked, stated.name if stated else "", run.started_utc[:10] if run else "", out)


def _report_calibration(
    path: Path,
    out: Path,
    allowed_signers: Path | None,
    before: Path | None,
    on_remark: Callable[[str], None],
    xml_key: XmlKeyFiles | None,
) -> None:
    by = None if xml_key is None else read_xml_key(xml_key.key, xml_key.certificates, xml_key.ask)
    told_at, path = path, _beside(path, out)
    verification = verify(path, allowed_signers)
    calibration = certificate.parse_calibration(verification.content, path)
    run = run_of(calibration)
    said = _circumstances(calibration, run, told_at)
    changed = certificate.changed_from(calibration, before) if before else changed_since(calibration)
    if out.suffix.lower() == ".xml":
        for clause in write_dcc(calibration, verification, run, said, home() / LABORATORY, out, changed, by):
            on_remark(f"not stated: {clause}")
        return
    checked = f"{datetime.now(UTC):%Y-%m-%d %H:%M} UTC, against {allowed_signers or THIS_LAB}"
    page = calibration_page(calibration, verification, checked, run, changed, said)
    if lacking := write_report(page, out):
        on_remark(lacking)


def _circumstances(calibration: Calibration, run: Run | None, file: Path) -> Circumstances:
    """What the record, labcal's folder and what lies beside `file` tell beside the calibration."""
    stated = administrative_of(run.administrative if run else None, home() / LABORATORY, file)
    header = header_of(calibration.run_id) if run else None
    procedure = (header.procedure, header.source_sha256) if header else ("", "")
    images = images_in(home(), accredited=not calibration.simulated)
    return Circumstances(stated, *procedure, images, header.instruments if header else (), _open(header))


def _beside(path: Path, out: Path) -> Path:
    """The copy of the calibration that lies beside its report under the same name: that one the report names."""
    copy = out.with_suffix(".json")
    signed = len(certificate.signature_files(path)) if copy.exists() else 0
    same = copy.exists() and copy.read_bytes() == path.read_bytes() and len(certificate.signature_files(copy)) == signed
    return copy if same else path


def _open(header: RunHeader | None) -> tuple[str, ...]:
    """What the run's own checks left open."""
    if header is None:
        return ()
    left = told(header.run_id)
    return (*(f"{one}." for one in left.other_serials), *open_words(left.open, left.not_measured))


def changed_since(calibration: Calibration) -> Changes | None:
    """What changed since the calibration before this one of the same DUT in this lab's folder; None where none is.

    None too where this lab's store cannot be read: nothing tells then which was before.
    """
    try:
        started = {run.run_id: run.started_utc for run in runs()}
    except InputError:
        return None
    return certificate.changed_since(calibration, home() / CALIBRATIONS, started)
