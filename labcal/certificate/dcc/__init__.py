"""A Digital Calibration Certificate: PTB's DCC 3.3.0 in XML, with the calibration file itself inside (extra `dcc`).

The XML carries the numbers, each with its expanded uncertainty and all with their covariance, method, equipment,
conditions, budget and conformity: K, k and the parameters of the effects can be taken from it alone. The effects'
evidence, and the basis of an empirical term, are in the enclosed file, byte for byte.
"""

from __future__ import annotations

import base64
from pathlib import Path

from labcal.certificate.dcc.administrative import administrative_data, software
from labcal.certificate.dcc.circumstances import influence_conditions, measuring_equipments, used_methods
from labcal.certificate.dcc.parts import DCC, SI, Makers, one_line
from labcal.certificate.dcc.results import MODEL, results
from labcal.certificate.dcc.rules import lacks, objections
from labcal.certificate.dcc.units import si_unit
from labcal.certificate.dcc.xades import XmlKey, read_xml_key, signed_xml
from labcal.certificate.laboratory import WANTED
from labcal.certificate.report.circumstances import Circumstances
from labcal.certificate.signing import Verification
from labcal.errors import InputError
from labcal.files import atomic
from labcal.model import Calibration
from labcal.record import Run
from labcal.uncertainty.conformity import Changes

__all__ = ["DCC", "SI", "XmlKey", "dcc_xml", "objections", "read_xml_key", "si_unit", "signed_xml", "write_dcc"]

VERSION = "3.3.0"


def write_dcc(
    calibration: Calibration,
    found: Verification,
    run: Run | None,
    said: Circumstances,
    laboratory: Path,
    out: Path,
    changed: Changes | None = None,
    xml_key: XmlKey | None = None,
) -> tuple[str, ...]:
    """Write the certificate to `out`, whole or not at all; returns what it lacks, a clause each.

    `changed` is what changed since the calibration before; `xml_key` signs the XML itself.

    Raises InputError for a draft, a signature that does not hold, and where dates or issuer are not known (`laboratory`
    is the file that may state them).
    """
    if not found.valid:
        why = "; ".join(found.against())
        raise InputError(f"is no certificate: {why}; nothing was written", file=found.file)
    if run is None:
        what = f"a certificate states when it was measured; run {calibration.run_id} is not in this lab's store"
        raise InputError(f"{what} (`labcal import` takes its bundle in)")
    if said.administrative.laboratory is None or said.administrative.customer is None:
        what = f"a certificate names its laboratory and its customer: state both in bench.toml, or here {WANTED}"
        raise InputError(what, file=laboratory)
    xml = dcc_xml(calibration, found.content, found.file.name, run, said, found.signers, changed)
    atomic.write_bytes(out, xml if xml_key is None else signed_xml(xml, xml_key))
    return lacks(xml)


def dcc_xml(
    calibration: Calibration,
    content: bytes,
    name: str,
    run: Run,
    said: Circumstances,
    signers: tuple[str, ...] = (),
    changed: Changes | None = None,
) -> bytes:
    """The certificate of `calibration`, whose file `name` has the bytes `content`; `run` gives dates and conditions.

    Raises InputError where the extra `dcc` is not installed.
    """
    try:
        from lxml import etree
        from lxml.builder import ElementMaker
    except ImportError:
        raise InputError("a certificate in XML needs the extra `dcc`: pip install 'labcal[dcc]'") from None
    m = Makers(ElementMaker(namespace=DCC, nsmap={"dcc": DCC, "si": SI}), ElementMaker(namespace=SI))
    d = m.d
    simulated = "SIMULATED: describes no real sensor. " if calibration.simulated else ""
    measured = d.measurementResult(
        m.text("name", "Calibration"),
        m.text("description", simulated + MODEL),
        used_methods(m, calibration, said),
        d.usedSoftware(software(m)),
        measuring_equipments(m, calibration, run, said),
        influence_conditions(m, run),
        d.results(*results(m, calibration, run, changed)),
    )
    enclosed = base64.b64encode(content).decode()
    root = d.digitalCalibrationCertificate(
        administrative_data(m, calibration, content, run, said.administrative, signers),
        d.measurementResults(measured),
        d.document(d.fileName(one_line(name)), d.mimeType("application/json"), d.dataBase64(enclosed)),
        schemaVersion=VERSION,
    )
    return bytes(etree.tostring(root, xml_declaration=True, encoding="UTF-8", pretty_print=True))
