"""Administrative data of a DCC: identity, dates, item, laboratory, people, customer, statements."""

from __future__ import annotations

from hashlib import sha256
from typing import Any

from labcal.certificate.dcc.parts import LANGUAGE, Makers, one_line
from labcal.certificate.dcc.units import si_unit
from labcal.certificate.report.circumstances import performed, statements
from labcal.model import Calibration
from labcal.record import Administrative, Run
from labcal.record.administrative import Laboratory
from labcal.version import __version__


def administrative_data(
    m: Makers, c: Calibration, content: bytes, run: Run, stated: Administrative, signers: tuple[str, ...]
) -> Any:
    """The element dcc:administrativeData; the laboratory and the customer have to be stated."""
    d = m.d
    if stated.laboratory is None or stated.customer is None:
        raise ValueError("a DCC names its laboratory and its customer")
    return d.administrativeData(
        d.dccSoftware(software(m)),
        _core(m, c, content, run, stated, stated.laboratory),
        d.items(_item(m, c, stated)),
        _laboratory(m, stated.laboratory),
        d.respPersons(*_people(m, c, signers)),
        d.customer(*m.contact(stated.customer)),
        d.statements(*(d.statement(m.text("declaration", said)) for said in _statements(c)), *_other_units(m, c)),
    )


def software(m: Makers) -> Any:
    """labcal, with its release as the DCC's rules want it written."""
    numbers = ".".join(part for part in __version__.split(".")[:3] if part.isdigit())
    return m.d.software(m.text("name", "labcal"), m.d.release(f"v{numbers}"), m.d.type("application"))


def _core(m: Makers, c: Calibration, content: bytes, run: Run, stated: Administrative, by: Laboratory) -> Any:
    d, (begin, end) = m.d, performed(run)
    digest = sha256(content).hexdigest()
    received = [d.receiptDate(stated.item.received)] if stated.item and stated.item.received else []
    issued = [d.issueDate(c.issued_utc[:10])] if c.issued_utc else []
    before = [_previous(m, c.supersedes)] if c.supersedes else []
    identified = d.identifications(
        m.identification("calibrationLaboratory", digest, "SHA-256 of the calibration file"),
        m.identification("calibrationLaboratory", c.run_id, "run"),
    )
    return d.coreData(
        d.countryCodeISO3166_1(by.country),
        d.usedLangCodeISO639_1(LANGUAGE),
        d.mandatoryLangCodeISO639_1(LANGUAGE),
        d.uniqueIdentifier(c.number or f"sha256:{digest}"),
        identified,
        *received,
        d.beginPerformanceDate(begin.date().isoformat()),
        d.endPerformanceDate(end.date().isoformat()),
        d.performanceLocation("laboratory" if by.place is None else "other"),
        *issued,
        *before,
    )


def _previous(m: Makers, digest: str) -> Any:
    d = m.d
    named = m.text("referral", "the calibration file that this one takes the place of")
    return d.previousReport(named, d.referralID(digest), d.procedure("SHA-256"), d.value(digest))


def _item(m: Makers, c: Calibration, stated: Administrative) -> Any:
    d, item = m.d, stated.item
    condition = (item and item.condition) or "not stated"
    maker = [d.manufacturer(m.text("name", item.manufacturer))] if item and item.manufacturer else []
    model = [d.model(one_line(c.dut.model))] if c.dut.model else []
    serial = d.identifications(m.identification("manufacturer", c.dut.serial, "serial number"))
    said = m.text("description", f"Condition on receipt: {condition}")
    return d.item(m.text("name", "magnetometer"), said, *maker, *model, serial)


def _laboratory(m: Makers, by: Laboratory) -> Any:
    code = [m.d.calibrationLaboratoryCode(one_line(by.accreditation))] if by.accreditation else []
    return m.d.calibrationLaboratory(*code, m.d.contact(*m.contact(by)))


def _people(m: Makers, c: Calibration, signers: tuple[str, ...]) -> list[Any]:
    """Who signed, the first of them as the main signer, who approved, and who measured."""
    d, main = m.d, signers[0] if signers else None
    roles = dict.fromkeys(signers, "signer") | dict.fromkeys(c.approvers, "approver")
    people = [
        d.respPerson(d.person(m.text("name", name)), d.role(role), *([d.mainSigner("true")] if name == main else []))
        for name, role in roles.items()
    ]
    return [*people, d.respPerson(d.person(m.text("name", c.operator or "not stated")), d.role("operator"))]


def _statements(c: Calibration) -> tuple[str, ...]:
    simulated = ("SIMULATED: it describes no real sensor.",) if c.simulated else ()
    uncovered = (f"Not covered by the uncertainties: {said}" for said in c.not_covered)
    return (*simulated, *statements(c), *uncovered)


def _other_units(m: Makers, c: Calibration) -> list[Any]:
    """What units mean that the SI has no name for."""
    units = {"count", *(p.unit for effect in c.effects for p in effect.parameters)}
    named = sorted({name for unit in units if (name := si_unit(unit)).startswith("|")})
    said = {"|count": f"one step of the reading of the item, nominally {c.dut.nominal_nT_per_unit:g} nT"}
    return [
        m.d.statement(m.d.nonSIDefinition(said.get(name, f"the unit {name[1:]}")), m.d.nonSIUnit(name))
        for name in named
    ]
