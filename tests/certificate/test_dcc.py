from __future__ import annotations

import base64
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from labcal.certificate.calibration_file import calibration_bytes
from labcal.certificate.dcc import DCC, SI, dcc_xml, si_unit
from labcal.certificate.laboratory import read_laboratory
from labcal.cli import execute
from labcal.errors import InputError
from labcal.model import Calibration
from labcal.record import Administrative, Dut, Reference, Run, Segment
from labcal.record.administrative import Address, Laboratory
from labcal.store import bundle_of, save_bundle

etree = pytest.importorskip("lxml.etree", reason="needs the extra `dcc` (lxml), which is not installed")
LABORATORY = Administrative(Laboratory("A lab & co", "Bern", "CH"), Address("X", "Y", "DE"))
NAMES = {"dcc": DCC, "si": SI}


@pytest.fixture
def run() -> Run:
    return Run(
        "r",
        "2026-11-21T23:50:00Z",
        True,
        "",
        Dut("FM-07"),
        Reference("none"),
        (Segment("a", "static"),),
        np.array([5.0, 1205.0]),
        np.zeros(2, dtype=np.intp),
        np.zeros((2, 3)),
    )


class Local(etree.Resolver):
    """The schemas' imports from this machine; quantity kinds as any name."""

    QUDT = """<xs:schema xmlns:xs="http://www.w3.org/2001/XMLSchema" targetNamespace="http://qudt.org/vocab/">
      <xs:simpleType name="quantitykind"><xs:restriction base="xs:string"/></xs:simpleType></xs:schema>"""

    def __init__(self, schemas: Path, signature: Path) -> None:
        self.schemas, self.signature = schemas, signature

    def resolve(self, url: str, pubid: object, context: object) -> object:
        if "qudt" in url:
            return self.resolve_string(self.QUDT, context)
        if "SI_Format" in url:
            return self.resolve_filename(str(self.schemas / "SI_Format-2.2.0.xsd"), context)
        if "xmldsig" in url:
            return self.resolve_filename(str(self.signature), context)
        return self.resolve_string("", context) if url.startswith("http") else None


@pytest.fixture
def schema(shared: Path) -> object:
    signxml = pytest.importorskip("signxml", reason="needs the extra `dcc` (signxml), which is not installed")
    signature = Path(signxml.__file__).parent / "schemas" / "xmldsig-core-schema.xsd"
    parser = etree.XMLParser(no_network=True)
    parser.resolvers.add(Local(shared / "schemas", signature))
    return etree.XMLSchema(etree.parse(str(shared / "schemas" / "dcc-3.2.1.xsd"), parser))


def test_the_certificate_obeys_its_schema(calibration: Calibration, run: Run, schema: object):
    line = {"quantity": "scale x", "value": 1e-05, "U": 0.0, "limit": 0.5, "unit": "%", "rule": "w = U", "risk": 0.0}
    judged = replace(
        calibration, specification=tuple({**line, "result": r, "tur": None} for r in ("pass", "conditional-fail"))
    )
    bare = replace(calibration, covariance=None, effects=(), operator="", approvers=("Bob",))
    for variant in (calibration, judged, bare):
        xml = dcc_xml(variant, calibration_bytes(variant), "calibration.json", run, LABORATORY)
        schema.assertValid(etree.fromstring(xml))
    broken = etree.fromstring(xml)
    broken.set("schemaVersion", "3.3.0")
    assert not schema.validate(broken)


def test_its_numbers_are_the_file_s(calibration: Calibration, run: Run):
    content = calibration_bytes(calibration)
    root = etree.fromstring(dcc_xml(calibration, content, "calibration.json", run, LABORATORY))
    lists = [[float(v) for v in e.text.split()] for e in root.iterfind(".//si:valueXMLList", NAMES)]
    assert lists == [calibration.affine.K.ravel().tolist(), [120.0, -8.0, 3.0], [112.5, -40.25, 3.0]]
    expanded = [[float(v) for v in e.text.split()] for e in root.iterfind(".//si:valueExpandedMUXMLList", NAMES)]
    assert expanded[1:] == [[4.0] * 3, [0.8] * 3]
    units = [e.text.split()[0] for e in root.iterfind(".//si:unitXMLList", NAMES)]
    assert units == [r"\nano\tesla", r"\nano\tesla", r"\nano\tesla\per\ampere"]
    assert base64.b64decode(root.findtext("dcc:document/dcc:dataBase64", namespaces=NAMES)) == content
    dates = [root.findtext(f".//dcc:{which}PerformanceDate", namespaces=NAMES) for which in ("begin", "end")]
    assert dates == ["2026-11-21", "2026-11-22"]
    assert "SIMULATED" in root.findtext(".//dcc:measurementResult/dcc:description/dcc:content", namespaces=NAMES)


@pytest.mark.parametrize(
    ("unit", "name"),
    [
        ("nT", r"\nano\tesla"),
        ("nT/degC", r"\nano\tesla\per\degreecelsius"),
        ("1/nT", r"\per\nano\tesla"),
        ("1", r"\one"),
        ("count", "|count"),
        ("nT/A^2", "|nT/A^2"),
    ],
)
def test_units_have_their_si_names(unit: str, name: str):
    assert si_unit(unit) == name


def test_a_laboratory_is_read_or_refused(tmp_path: Path):
    path = tmp_path / "laboratory.toml"
    with pytest.raises(InputError, match="names its laboratory"):
        read_laboratory(path)
    whole = 'name = "A lab & co"\ncity = "Bern"\ncountry = "CH"\n[customer]\nname = "X"\ncity = "Y"\ncountry = "DE"\n'
    path.write_text(whole)
    assert read_laboratory(path) == LABORATORY
    for broken in (whole.replace("CH", "Swiss"), whole.replace("city", "town"), "name = "):
        path.write_text(broken)
        with pytest.raises(InputError, match="expected"):
            read_laboratory(path)


def test_the_command_needs_the_run_and_the_laboratory(
    calibration: Calibration, run: Run, tmp_path: Path, home_of_its_own: Path, capsys: pytest.CaptureFixture[str]
):
    save_bundle(bundle_of(run), tmp_path / "bundle")
    made = replace(calibration, run_id=run.run_id, run_sha256=bundle_of(run).sha256)
    (tmp_path / "cal.json").write_bytes(calibration_bytes(made))
    command = ["report", str(tmp_path / "cal.json"), "--out", str(tmp_path / "cal.xml")]
    assert execute(command) == 2
    assert "is not in this lab's store" in capsys.readouterr().err
    assert execute(["import", str(tmp_path / "bundle")]) == 0
    assert execute(command) == 2
    assert "laboratory.toml" in capsys.readouterr().err
    text = 'name = "A"\ncity = "Bern"\ncountry = "CH"\n[customer]\nname = "X"\ncity = "Y"\ncountry = "DE"\n'
    (home_of_its_own / "laboratory.toml").write_text(text)
    assert not (tmp_path / "cal.xml").exists()
    assert execute(command) == 0
    assert etree.parse(str(tmp_path / "cal.xml")).getroot().tag == f"{{{DCC}}}digitalCalibrationCertificate"
