"""The certificate in XML as other people's programs read it: PTB's dcclib and dcc-json-toolkit, and pydcc."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from types import ModuleType
from xml.etree import ElementTree

import pytest
from dcc_json_toolkit import DccSchema, DccSourceContent, cache
from dcc_json_toolkit.content_validation import validate_dcc_content
from dcclib.validation import SchematronValidator

from labcal.certificate import read_calibration
from labcal.certificate.dcc import dcc_xml
from labcal.certificate.report import Circumstances
from labcal.record import Administrative
from labcal.record.administrative import Address, Laboratory
from labcal.store import read_bundle

EXAMPLE = Path(__file__).parents[2] / "examples" / "short-preflight"
LABORATORY = Laboratory("Field Laboratory", "Bern", "CH", email="lab@field.example")
SAID = Circumstances(Administrative(LABORATORY, Address("Satellite Works", "Bremen", "DE")), "preflight")
SCHEMAS = {"dcc.xsd": "dcc-3.3.0.xsd", "si.xsd": "SI_Format-2.2.1.xsd", "xmldsig.xsd": "xmldsig-core-schema.xsd"}
QUDT = """<xs:schema xmlns:xs="http://www.w3.org/2001/XMLSchema" targetNamespace="http://qudt.org/vocab/">
  <xs:simpleType name="quantitykind"><xs:restriction base="xs:string"/></xs:simpleType></xs:schema>"""


@pytest.fixture
def certificate(tmp_path: Path) -> Path:
    """Of the example, a recorded preflight."""
    content = (EXAMPLE / "calibration.json").read_bytes()
    found, run = read_calibration(EXAMPLE / "calibration.json"), read_bundle(EXAMPLE / "run.zip")
    path = tmp_path / "dcc.xml"
    path.write_bytes(dcc_xml(found, content, "calibration.json", run, SAID, ("ada",)))
    return path


@pytest.fixture
def schema(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> DccSchema:
    """As the toolkit would download it, laid where it would lie."""
    import signxml

    shared = Path(__file__).parents[3] / "shared" / "schemas"
    own = {"xmldsig.xsd": Path(signxml.__file__).parent / "schemas" / SCHEMAS["xmldsig.xsd"]}
    files = {name: own.get(name, shared / file) for name, file in SCHEMAS.items()}
    if absent := [file.name for file in files.values() if not file.is_file()]:
        pytest.skip(f"needs {' and '.join(absent)} in shared/schemas")
    folder = tmp_path / "3.3.0"
    folder.mkdir()
    places = (("SI_Format|/dsi/", "si.xsd"), ("xmldsig", "xmldsig.xsd"), ("qudt", "qudt.xsd"))
    for name, file in files.items():
        text = file.read_text(encoding="utf-8")
        for known, local in places:
            text = re.sub(rf'schemaLocation="[^"]*({known})[^"]*"', f'schemaLocation="{local}"', text)
        (folder / name).write_text(re.sub("<!DOCTYPE.*?]>", "", text, flags=re.DOTALL), encoding="utf-8")
    (folder / "qudt.xsd").write_text(QUDT)
    monkeypatch.setattr(cache, "CACHE_DIR_PATH", tmp_path)
    return DccSchema("3.3.0")


def test_no_rule_of_dcclib_fails_or_calls_it_unacceptable(certificate: Path):
    found = SchematronValidator.for_dcc().validate_str(certificate.read_text(encoding="utf-8"))
    assert [one.text for one in found.failed_assertions] == []
    serious = [one.text for one in found.successful_reports if one.role != "information"]
    assert len(serious) == 1  # parameters of several units have one covariance
    assert "differing units" in serious[0]


def test_the_toolkit_finds_every_unit_and_word_as_they_are_to_be(certificate: Path):
    assert validate_dcc_content(dcc_source=DccSourceContent(str(certificate))) == []
    spoilt = certificate.with_name("spoilt.xml")
    spoilt.write_text(certificate.read_text(encoding="utf-8").replace(r"\per\ampere", r"\per\ampere\per\second"))
    assert validate_dcc_content(dcc_source=DccSourceContent(str(spoilt))) != []


def test_the_toolkit_s_json_gives_the_same_certificate_back(certificate: Path, schema: DccSchema):
    assert schema.validate_dcc(str(certificate)) == []
    back = ElementTree.fromstring(schema.to_xml_string(schema.to_dict(str(certificate))))
    words = [[(one.tag, (one.text or "").strip()) for one in root.iter()]
             for root in (ElementTree.parse(certificate).getroot(), back)]  # fmt: skip
    assert words[0] == words[1]


def test_pydcc_reads_it(certificate: Path, monkeypatch: pytest.MonkeyPatch):
    """Without its checks of certificates (their library refuses OpenSSL 3.0.10) and of the schema (it downloads it)."""
    absent = ModuleType("certvalidator")
    for name in ("CertificateValidator", "ValidationContext", "errors"):
        setattr(absent, name, None)
    monkeypatch.setitem(sys.modules, "certvalidator", absent)
    from dcc import dcc

    monkeypatch.setattr(dcc, "DCCXMLValidator", lambda *_: None)
    read = dcc.DCC(str(certificate), signature_verification=False)
    assert read.calibration_laboratory_name() == "Field Laboratory"
    assert read.version() == "3.3.0"
    found = dict(read.get_calibration_results("name"))
    [k] = (value for name, value in found.items() if name.split()[:2] == ["Calibration", "k"])
    numbers = [float(one) for one in k["realListXMLList"]["valueXMLList"].split()]
    assert numbers == read_calibration(EXAMPLE / "calibration.json").affine.k_nT.tolist()
