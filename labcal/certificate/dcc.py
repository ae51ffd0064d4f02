"""A Digital Calibration Certificate: PTB's DCC 3.2.1 in XML, with the calibration file itself inside (extra `dcc`).

The XML carries what its schema has words for, each number with its expanded uncertainty (k = 2), and each quantity of
the uncertainty budget; the covariances and the effects' evidence are in the enclosed file, byte for byte. What a
certificate must state and a calibration does not know, the laboratory and the customer, stands in `laboratory.toml` in
labcal's folder. The XML is not signed.
"""

from __future__ import annotations

import base64
from collections.abc import Mapping
from datetime import datetime, timedelta
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np

from labcal.certificate.dcc_conformity import conformity_results
from labcal.certificate.laboratory import administrative_of, read_laboratory
from labcal.errors import InputError
from labcal.files import atomic
from labcal.model import Calibration, EffectRecord
from labcal.record import Administrative, Run
from labcal.record.administrative import Address
from labcal.uncertainty.conformity import stated_lines
from labcal.version import __version__

DCC, SI = "https://ptb.de/dcc", "https://ptb.de/si"
COVERAGE, PROBABILITY = 2, 0.95
SI_NAMES = {
    "1": r"\one",
    "nT": r"\nano\tesla",
    "A": r"\ampere",
    "degC": r"\degreecelsius",
    "deg": r"\degree",
    "s": r"\second",
    "h": r"\hour",
    "V": r"\volt",
    "W": r"\watt",
    "m": r"\metre",
    "rad": r"\radian",
    "%": r"\percent",
    "ppm": r"\ppm",
    "pT": r"\pico\tesla",
    "uT": r"\micro\tesla",
    "µT": r"\micro\tesla",
    "arcmin": r"\arcminute",
    "arcsec": r"\arcsecond",
    "mrad": r"\milli\radian",
}


def write_dcc(
    calibration: Calibration, content: bytes, name: str, run: Run | None, laboratory: Path, out: Path
) -> None:
    """Write the certificate to `out`, whole or not at all. Raises InputError: no dates, or no issuer."""
    if run is None:
        told = f"a certificate states when it was measured; run {calibration.run_id} is not in this lab's store"
        raise InputError(f"{told} (`labcal import` takes its bundle in)")
    stated = administrative_of(run.administrative, laboratory)
    if stated.laboratory is None or stated.customer is None:
        stated = read_laboratory(laboratory)  # which says what is missing
    atomic.write_bytes(out, dcc_xml(calibration, content, name, run, stated))


def dcc_xml(calibration: Calibration, content: bytes, name: str, run: Run, stated: Administrative) -> bytes:
    """The certificate of `calibration`, whose file `name` has the bytes `content`; `run` gives the dates.

    Raises InputError where the extra `dcc` is not installed.
    """
    try:
        from lxml import etree
        from lxml.builder import ElementMaker
    except ImportError:
        raise InputError("a certificate in XML needs the extra `dcc`: pip install 'labcal[dcc]'") from None
    d, si = ElementMaker(namespace=DCC, nsmap={"dcc": DCC, "si": SI}), ElementMaker(namespace=SI)
    root = d.digitalCalibrationCertificate(
        _administrative(d, calibration, content, run, stated),
        d.measurementResults(_results(d, si, calibration)),
        d.document(d.fileName(name), d.mimeType("application/json"), d.dataBase64(base64.b64encode(content).decode())),
        schemaVersion="3.2.1",
    )
    return bytes(etree.tostring(root, xml_declaration=True, encoding="UTF-8", pretty_print=True))


def _administrative(d: Any, c: Calibration, content: bytes, run: Run, stated: Administrative) -> Any:
    laboratory, customer = stated.laboratory, stated.customer
    assert laboratory is not None
    assert customer is not None
    begin = datetime.fromisoformat(run.started_utc)
    end = begin + timedelta(seconds=float(run.t_s[-1] - run.t_s[0]) if len(run) else 0.0)
    software = d.software(_text(d, "name", "labcal"), d.release(__version__))
    core = d.coreData(
        d.countryCodeISO3166_1(laboratory.country),
        d.usedLangCodeISO639_1("en"),
        d.mandatoryLangCodeISO639_1("en"),
        d.uniqueIdentifier(f"sha256:{sha256(content).hexdigest()}"),
        d.beginPerformanceDate(begin.date().isoformat()),
        d.endPerformanceDate(end.date().isoformat()),
        d.performanceLocation("laboratory"),
    )
    serial = d.identification(d.issuer("manufacturer"), d.value(c.dut.serial), _text(d, "name", "serial number"))
    model = [d.model(c.dut.model)] if c.dut.model else []
    item = d.item(_text(d, "name", "magnetometer"), *model, d.identifications(serial))
    people = [(name, "approver") for name in c.approvers] + [(c.operator or "not stated", "operator")]
    persons = (d.respPerson(d.person(_text(d, "name", who)), d.role(role)) for who, role in people)
    return d.administrativeData(
        d.dccSoftware(software),
        core,
        d.items(item),
        d.calibrationLaboratory(d.contact(*_place(d, laboratory))),
        d.respPersons(*persons),
        d.customer(*_place(d, customer)),
    )


def _place(d: Any, place: Address) -> tuple[Any, Any]:
    return _text(d, "name", place.name), d.location(d.city(place.city), d.countryCode(place.country))


def _results(d: Any, si: Any, c: Calibration) -> Any:
    u = np.full(12, np.nan) if c.covariance is None else np.sqrt(np.maximum(np.diag(c.covariance)[:12], 0.0))
    per_reading = "1" if c.dut.unit == "nT" else "nT"
    given = [
        _result(
            d, si, f"K, row by row, in {per_reading} per {c.dut.unit}", c.affine.K.ravel(), u[:9], [per_reading] * 9
        ),
        _result(d, si, f"k {c.k_means()}".rstrip(), c.affine.k_nT, u[9:], ["nT"] * 3),
        *(_effect(d, si, effect) for effect in c.effects if effect.parameters),
        *conformity_results(d, si, stated_lines(c), si_unit),
        *(_budget(d, si, budget) for budget in c.budget if budget["rows"]),
    ]
    told = "b = K m - k - sum of effects: field in the sensor's own axes from its reading m."
    if c.simulated:
        told = f"SIMULATED: describes no real sensor. {told}"
    return d.measurementResult(_text(d, "name", "Calibration"), _text(d, "description", told), d.results(*given))


def _budget(d: Any, si: Any, b: Mapping[str, Any]) -> Any:
    """What each source contributes to the standard uncertainty of one quantity, and in words what it comes to."""
    rows, at = b["rows"], f" at {b['at']}" if b["at"] else ""
    dof = "infinite" if b["dof"] is None else f"{b['dof']:.4g}"
    told = f"U = {b['U']:.3g} {b['unit']}, k = {b['k']:.2f}, effective degrees of freedom {dof}. Sources: "
    told += "; ".join(
        f"{r['source']} (type {r['type']}, {r['distribution']}, u = {r['u']:.3g} {r['unit']}, "
        f"sensitivity {r['sensitivity']:.3g}, {100 * r['share']:.1f} %)"
        for r in rows
    )
    parts = [abs(r["u"] * r["sensitivity"]) for r in rows]
    values = si.realListXMLList(
        si.valueXMLList(_list(parts)), si.unitXMLList(" ".join([si_unit(b["unit"])] * len(rows)))
    )
    name = _text(d, "name", f"Contributions to the standard uncertainty of {b['quantity']}{at}")
    return d.result(name, _text(d, "description", told), d.data(d.quantity(values)))


def _effect(d: Any, si: Any, effect: EffectRecord) -> Any:
    values, u = (np.array([getattr(p, name) for p in effect.parameters]) for name in ("value", "u"))
    name = " ".join([effect.effect, *effect.channels]) + ": " + ", ".join(p.name for p in effect.parameters)
    return _result(d, si, name, values, u, [p.unit for p in effect.parameters])


def _result(d: Any, si: Any, name: str, values: Any, u: Any, units: list[str]) -> Any:
    parts = [si.valueXMLList(_list(values)), si.unitXMLList(" ".join(map(si_unit, units)))]
    if np.isfinite(u).all():
        expanded = si.expandedMUXMLList(
            si.valueExpandedMUXMLList(_list(COVERAGE * u)),
            si.coverageFactorXMLList(str(COVERAGE)),
            si.coverageProbabilityXMLList(str(PROBABILITY)),
        )
        parts.append(si.measurementUncertaintyUnivariateXMLList(expanded))
    return d.result(_text(d, "name", name), d.data(d.quantity(si.realListXMLList(*parts))))


def si_unit(unit: str) -> str:
    r"""The D-SI name of a unit: nT/degC is \nano\tesla\per\degreecelsius. What SI has no name for follows a bar."""
    above, _, below = unit.partition("/")
    if above not in SI_NAMES or (below and below not in SI_NAMES):
        return "|" + "".join(unit.split())
    if not below:
        return SI_NAMES[above]
    return ("" if above == "1" else SI_NAMES[above]) + r"\per" + SI_NAMES[below]


def _list(values: Any) -> str:
    return " ".join(repr(float(value)) for value in values)


def _text(d: Any, tag: str, words: str) -> Any:
    return getattr(d, tag)(d.content(words, lang="en"))
