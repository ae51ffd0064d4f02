from __future__ import annotations

import base64
import shutil
import subprocess
from dataclasses import dataclass, replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from cryptography import x509
from cryptography.hazmat.primitives import hashes
from cryptography.hazmat.primitives.asymmetric import ec, rsa
from cryptography.hazmat.primitives.serialization import BestAvailableEncryption, Encoding, NoEncryption, PrivateFormat

from labcal.certificate.calibration_file import calibration_bytes
from labcal.certificate.dcc import DCC, SI, dcc_xml, objections, read_xml_key, signed_xml
from labcal.certificate.dcc.rules import RULES
from labcal.certificate.report import Circumstances
from labcal.certificate.signing import sign_simulated
from labcal.cli import execute
from labcal.errors import InputError
from labcal.geometry import rotation_vector
from labcal.model import AffineMap, Calibration
from labcal.record import Administrative, Channel, Dut, Reference, Run, Segment
from labcal.record.administrative import Address, Certified, Equipment, Item, Laboratory
from labcal.record.specification import Limit, Specification
from labcal.store import bundle_of, save_bundle
from labcal.uncertainty.conformity import Changes, changes
from labcal.uncertainty.working_points import working_points

etree = pytest.importorskip("lxml.etree", reason="needs the extra `dcc` (lxml), which is not installed")
SAID = Circumstances(
    Administrative(
        Laboratory("A lab & co", "Bern", "CH", street="Gasse 4", postcode="3011", email="a@b.example", phone="1",
                   accreditation="SCS 0999"),
        Address("X", "Y", "DE"),
        Item("Fluxworks", "one scratch", "2026-11-20"),
        (Equipment("thermometer", "Fluke", "1524", "T-77", Certified("T-1", "METAS", "2025-02-01")),),
    ),
    "preflight",
    "cd" * 32,
    instruments=({"name": "fluxgate", "manufacturer": "Honeywell", "model": "HMR2300", "serial": "H-1"},),
)  # fmt: skip
NAMES = {"dcc": DCC, "si": SI}
SI_OF = {"3.3.0": "SI_Format-2.2.1.xsd", "3.2.1": "SI_Format-2.2.0.xsd"}


@pytest.fixture
def run() -> Run:
    return Run(
        "r",
        "2026-11-21T23:50:00Z",
        True,
        "",
        Dut("FM-07"),
        Reference("vector", "H-1", certificate={"number": "M-1", "issuer": "PTB", "date": "2026-01-05"}),
        (Segment("a", "static"),),
        np.array([5.0, 1205.0]),
        np.zeros(2, dtype=np.intp),
        np.zeros((2, 3)),
        specification=Specification(offset=Limit(500.0, "nT"), title="ICD-7, issue C"),
        environment={"temperature_C": 22.0, "pressure_hPa": 955.0, "humidity_percent": 41.0, "Kp": 2.0},
        channels=(
            Channel("i_eps", "A", "current", np.array([0.0, 1.0])),
            Channel("t_room", "degC", "temperature", np.array([21.0, 23.0]), "room"),
        ),
    )


class Local(etree.Resolver):
    """The schemas' imports from this machine; quantity kinds as any name."""

    QUDT = """<xs:schema xmlns:xs="http://www.w3.org/2001/XMLSchema" targetNamespace="http://qudt.org/vocab/">
      <xs:simpleType name="quantitykind"><xs:restriction base="xs:string"/></xs:simpleType></xs:schema>"""

    def __init__(self, si: Path, signature: Path) -> None:
        self.si, self.signature = si, signature

    def resolve(self, url: str, pubid: object, context: object) -> object:
        if "qudt" in url:
            return self.resolve_string(self.QUDT, context)
        if "SI_Format" in url or "/dsi/" in url:
            return self.resolve_filename(str(self.si), context)
        if "xmldsig" in url:
            return self.resolve_filename(str(self.signature), context)
        return self.resolve_string("", context) if url.startswith("http") else None


@pytest.fixture(params=SI_OF)
def schema(request: pytest.FixtureRequest, shared: Path) -> Schema:
    """DCC 3.3.0; and 3.2.1, for a reader who has that: nothing newer than it is used but the version's name."""
    signxml = pytest.importorskip("signxml", reason="needs the extra `dcc` (signxml), which is not installed")
    version, schemas = request.param, shared / "schemas"
    files = (schemas / f"dcc-{version}.xsd", schemas / SI_OF[version])
    if absent := [file.name for file in files if not file.is_file()]:
        pytest.skip(f"needs {' and '.join(absent)} in shared/schemas")
    parser = etree.XMLParser(no_network=True)
    signature = Path(signxml.__file__).parent / "schemas" / "xmldsig-core-schema.xsd"
    parser.resolvers.add(Local(files[1], signature))
    return Schema(version, etree.XMLSchema(etree.parse(str(files[0]), parser)))


@dataclass(frozen=True)
class Schema:
    """A released schema, and what a certificate of ours has against it."""

    version: str
    xsd: Any

    def obeyed_by(self, xml: bytes) -> bool:
        root = etree.fromstring(xml)
        assert root.get("schemaVersion") == "3.3.0"
        root.set("schemaVersion", self.version)
        self.xsd.assertValid(root)
        root.find(".//dcc:uniqueIdentifier", NAMES).tag = f"{{{DCC}}}number"
        return not self.xsd.validate(root)  # an element that the schema has no name for is told


def xml_of(c: Calibration, run: Run, signers: tuple[str, ...] = ("ada",), changed: Changes | None = None) -> bytes:
    return dcc_xml(c, calibration_bytes(c), "calibration.json", run, SAID, signers, changed)


@pytest.fixture
def whole(calibration: Calibration, run: Run) -> Calibration:
    """With something of everything that a DCC can state."""
    at = {point.says for point in working_points(calibration, run)[:6]}
    budget = [
        {"quantity": f"b {axis}", "at": says, "unit": "nT", "U": 17.4, "k": 2.0, "dof": None, "correlations": (),
         "rows": ({"source": "zero", "type": "B", "distribution": "normal", "u": 8.7, "unit": "nT", "sensitivity": 1.0,
                   "share": 1.0, "dof": None},)}
        for says in sorted(at) for axis in "xyz"
    ]  # fmt: skip
    line = {"quantity": "scale x", "value": 1e-05, "U": 1e-6, "limit": 0.5, "unit": "%", "rule": "w = U", "risk": 0.0}
    judged = tuple({**line, "result": result, "tur": None} for result in ("pass", "conditional-fail"))
    names = (*calibration.covariance_of[:12], "0:c_x", "0:c_y", "0:c_z")
    return replace(
        calibration, specification=judged, budget=tuple(budget), number="FL-CAGE-2026-0007", covariance_of=names,
        covariance=np.diag([1e-10] * 9 + [4.0] * 3 + [0.16] * 3), issued_utc="2026-11-23T09:00:00Z",
        supersedes="cd" * 32, not_covered=("The reference's time.",),
    )  # fmt: skip


def test_the_certificate_obeys_its_schema(calibration: Calibration, whole: Calibration, run: Run, schema: Schema):
    bare = replace(calibration, covariance=None, effects=(), operator="", approvers=("Bob",))
    before = replace(calibration, run_id="r-2025-11-02-01")
    since = (None, changes(calibration, before), changes(bare, before))
    for variant, changed in zip((whole, calibration, bare), since, strict=True):
        assert schema.obeyed_by(xml_of(variant, run, changed=changed))
    nothing = Circumstances(Administrative(SAID.administrative.laboratory, SAID.administrative.customer))
    unstated = replace(run, environment=None, reference=Reference("none"))
    assert schema.obeyed_by(dcc_xml(bare, b"{}", "calibration.json", unstated, nothing))


def test_no_rule_of_the_public_schematron_calls_it_unacceptable(whole: Calibration, run: Run):
    validation = pytest.importorskip("dcclib.validation", reason="needs dcclib, which is not installed")
    found = validation.SchematronValidator.for_dcc().validate_str(xml_of(whole, run).decode())
    said = [*found.failed_assertions, *found.successful_reports]
    assert [one.text for one in said if one.role not in ("information", "warning")] == []
    assert [one.test for one in found.failed_assertions] == []


def test_it_says_which_specification_and_which_reference(whole: Calibration, run: Run):
    root = etree.fromstring(xml_of(whole, run))
    judged = {one.text for one in root.iterfind(".//dcc:metaData/dcc:name/dcc:content", NAMES)}
    assert judged == {"conformity with the specification ICD-7, issue C"}
    [reference] = root.iterfind(".//dcc:measuringEquipment[@refType='basic_referenceStandard']", NAMES)
    assert reference.findtext("dcc:model", namespaces=NAMES) == "HMR2300"
    assert reference.findtext("dcc:manufacturer/dcc:name/dcc:content", namespaces=NAMES) == "Honeywell"


def numbers(element: object, path: str) -> list[float]:
    return [float(v) for one in element.iterfind(path, NAMES) for v in one.text.split()]


def test_the_correction_can_be_worked_out_from_the_xml_alone(whole: Calibration, run: Run):
    root = etree.fromstring(xml_of(whole, run))
    root.remove(root.find("dcc:document", NAMES))  # the enclosed file
    found = {one.get("refType"): one for one in root.iterfind(".//dcc:result", NAMES)}
    K = np.reshape(numbers(found["labcal_K"], ".//si:valueXMLList"), (3, 3))
    k = np.array(numbers(found["labcal_k"], ".//si:valueXMLList"))
    effect = found["labcal_effect"]
    assert "Formula: E = c (i * h)(t)" in effect.findtext("dcc:description/dcc:content", namespaces=NAMES)
    values = {
        one.findtext("dcc:name/dcc:content", namespaces=NAMES): numbers(one, ".//si:value")[0]
        for one in effect.iterfind(".//dcc:quantity", NAMES)
    }
    readings, current = np.random.default_rng(7).uniform(-60_000, 60_000, (50, 3)), np.linspace(0.0, 1.0, 50)
    by_hand = readings @ K.T - k - np.outer(current - values["i_eps"], [values[f"c_{axis}"] for axis in "xyz"])
    b = whole.apply(readings, t_s=np.arange(50.0), segment=["a"] * 50, channels={"i_eps": current}).field_nT
    np.testing.assert_allclose(by_hand, b, rtol=1e-12, atol=1e-12 * 60_000)
    C = np.reshape(numbers(found["labcal_covariance"], ".//si:covarianceXMLList/si:valueXMLList"), (15, 15))
    np.testing.assert_array_equal(C, whole.covariance)


def test_its_numbers_are_the_file_s(whole: Calibration, run: Run):
    content = calibration_bytes(whole)
    root = etree.fromstring(xml_of(whole, run))
    core = {one.tag.rpartition("}")[2]: one for one in root.find("dcc:administrativeData/dcc:coreData", NAMES)}
    told = {name: one.text for name, one in core.items() if one.text and one.text.strip()}
    assert told["uniqueIdentifier"] == "FL-CAGE-2026-0007"
    assert (told["beginPerformanceDate"], told["endPerformanceDate"]) == ("2026-11-21", "2026-11-22")
    assert (told["issueDate"], told["receiptDate"]) == ("2026-11-23", "2026-11-20")
    assert core["previousReport"].findtext("dcc:value", namespaces=NAMES) == "cd" * 32
    [main] = root.iterfind(".//dcc:respPerson[dcc:mainSigner]", NAMES)
    assert main.findtext("dcc:person/dcc:name/dcc:content", namespaces=NAMES) == "ada"
    assert base64.b64decode(root.findtext("dcc:document/dcc:dataBase64", namespaces=NAMES)) == content
    assert "SIMULATED" in root.findtext(".//dcc:measurementResult/dcc:description/dcc:content", namespaces=NAMES)
    [k] = root.iterfind(".//dcc:result[@refType='labcal_k']", NAMES)
    assert numbers(k, ".//si:valueExpandedMUXMLList") == [4.0] * 3


def test_parameters_of_few_degrees_of_freedom_have_a_k_that_holds_95_percent(whole: Calibration, run: Run):
    """ν = 9 behind one angle of the map: t for 95.45 % is 2.32, and no U is stated with less."""
    angle = {"quantity": "off 90° x–y", "at": "", "unit": "deg", "U": 2.32, "k": 2.32, "dof": 9.0, "correlations": (),
             "rows": ()}  # fmt: skip
    root = etree.fromstring(xml_of(replace(whole, budget=(*whole.budget, angle)), run))
    for name, count, U in (("labcal_K", 9, 2.32e-5), ("labcal_k", 3, 4.64)):
        [one] = root.iterfind(f".//dcc:result[@refType='{name}']", NAMES)
        assert numbers(one, ".//si:valueExpandedMUXMLList") == pytest.approx([U] * count)
        assert numbers(one, ".//si:coverageFactorXMLList") == [2.32]
    [effect] = root.iterfind(".//dcc:result[@refType='labcal_effect']", NAMES)
    assert set(numbers(effect, ".//si:coverageFactor")) == {2.32}


def test_the_error_of_indication_is_what_the_reading_says_less_the_field(whole: Calibration, run: Run):
    root = etree.fromstring(xml_of(whole, run))
    first = root.find(".//dcc:result[@refType='basic_result']", NAMES)
    parts = {one.get("refType"): numbers(one, ".//si:valueXMLList") for one in first.iterfind(".//dcc:quantity", NAMES)}
    field = np.array([60_000.0, 0.0, 0.0])
    assert parts["basic_referenceValue"] == field.tolist()
    indicated = 0.5 * np.linalg.solve(whole.affine.K, field + whole.affine.k_nT)
    np.testing.assert_allclose(parts["basic_measuredValue"], indicated, rtol=1e-12)
    np.testing.assert_allclose(parts["basic_measurementError"], indicated - field, rtol=1e-9, atol=1e-6)


def test_equipment_shows_traceability_where_its_certificate_held_on_the_day(whole: Calibration, run: Run):
    cases = [({"due": run.started_utc[:10]}, "traceable to the SI"), ({"due": "2026-01-06"}, "was overdue")]
    for dates, says in [*cases, ({"date": "2099-01-01"}, "was not yet issued")]:
        certificate = {**(run.reference.certificate or {}), **dates}
        made = replace(run, reference=replace(run.reference, certificate=certificate))
        root = etree.fromstring(xml_of(replace(whole, simulated=False), made))
        [reference] = root.iterfind(".//dcc:measuringEquipment[@refType='basic_referenceStandard']", NAMES)
        assert says in "".join(reference.find("dcc:description", NAMES).itertext()), dates


def test_the_u_of_an_indication_is_the_scatter_of_what_drawn_maps_read(whole: Calibration, run: Run):
    """Of a sensor turned by 40° in its body, whose components of the field share an error: U = k u, k of the budget."""
    draw, turn, noise = np.random.default_rng(2), rotation_vector(np.array([0.0, 0.0, np.radians(40)])), 5.0
    theta = np.r_[(turn @ whole.affine.K).ravel(), turn @ whole.affine.k_nT]
    shared = np.r_[1e-4 * theta[:9], 30.0, 25.0, 0.0]
    covariance = np.zeros((15, 15))
    covariance[:12, :12] = np.outer(shared, shared) + np.diag([1e-9] * 9 + [16.0] * 3)
    turned = replace(
        whole, affine=AffineMap.from_parameters(theta), covariance=covariance,
        metrics={"before": {}, "after": {"noise_nT": noise}}, budget=tuple({**b, "k": 2.31} for b in whole.budget),
    )  # fmt: skip
    root = etree.fromstring(xml_of(turned, run))
    maps = draw.multivariate_normal(theta, covariance[:12, :12], 4000)
    for result in root.iterfind(".//dcc:result[@refType='basic_result']", NAMES):
        field, indicated, _ = (numbers(one, ".//si:valueXMLList") for one in result.iterfind(".//dcc:quantity", NAMES))
        read = [0.5 * np.linalg.solve(t[:9].reshape(3, 3), np.array(field) + t[9:]) for t in maps]
        drawn = np.std(np.array(read) + noise * draw.standard_normal((len(maps), 3)), axis=0)
        for quantity in result.findall(".//dcc:quantity", NAMES)[1:]:
            assert numbers(quantity, ".//si:coverageFactorXMLList") == [2.31]
            np.testing.assert_allclose(numbers(quantity, ".//si:valueExpandedMUXMLList"), 2.31 * drawn, rtol=0.06)
        np.testing.assert_allclose(np.mean(read, axis=0), indicated, atol=3.0)


def test_each_of_a_hundred_omissions_is_named_with_its_clause(whole: Calibration, run: Run):
    xml = xml_of(whole, run)
    assert objections(etree.fromstring(xml)) == ()
    root = etree.fromstring(xml)
    places = [(rule, n, m) for rule in RULES for n, node in enumerate(root.xpath(rule.each, namespaces=NAMES))
              for m, _ in enumerate(node.xpath(rule.has, namespaces=NAMES)[:1])]  # fmt: skip
    chosen = np.random.default_rng(17).permutation(len(places))
    assert len(chosen) >= 100
    assert {rule.says for rule, *_ in (places[i] for i in range(len(places)))} == {rule.says for rule in RULES}
    missed = []
    for i in {*chosen[:100], *(next(j for j, place in enumerate(places) if place[0] is rule) for rule in RULES)}:
        rule, n, _ = places[i]
        faulty = etree.fromstring(xml)
        for gone in faulty.xpath(rule.each, namespaces=NAMES)[n].xpath(rule.has, namespaces=NAMES):
            gone.getparent().remove(gone)
        if f"{rule.clause}: {rule.says}" not in objections(faulty):
            missed.append(rule)
    assert missed == []


def test_a_map_without_effects_or_specification_lacks_nothing_of_them(whole: Calibration, run: Run):
    bare = replace(
        whole, effects=(), specification=(), covariance=np.diag([1e-10] * 9 + [4.0] * 3),
        covariance_of=whole.covariance_of[:12],
    )  # fmt: skip
    assert objections(etree.fromstring(xml_of(bare, run))) == ()


def test_a_reference_value_has_the_unit_of_its_channel(whole: Calibration, run: Run):
    root = etree.fromstring(xml_of(whole, run))
    [current] = root.iterfind(".//dcc:quantity[@refType='labcal_channelReference']", NAMES)
    assert current.findtext(".//si:unit", namespaces=NAMES) == r"\ampere"


def test_the_command_needs_run_laboratory_and_signature(
    calibration: Calibration, run: Run, tmp_path: Path, home_of_its_own: Path, capsys: pytest.CaptureFixture[str]
):
    bare = bundle_of(replace(run, reference=Reference("none")))
    save_bundle(bare, tmp_path / "bundle")
    path = tmp_path / "cal.json"
    of_it = replace(calibration, dut=run.dut, operator="", span_s=(5.0, 1205.0))
    path.write_bytes(calibration_bytes(replace(of_it, run_id=run.run_id, run_sha256=bare.sha256)))
    command = ["report", str(path), "--out", str(tmp_path / "cal.xml"), "--allowed-signers", str(tmp_path / "trust")]
    (tmp_path / "trust").write_text("")
    assert execute(command) == 2
    assert "carries no signature" in capsys.readouterr().err
    sign_simulated(path, tmp_path / "trust")
    assert execute(command) == 2
    assert "is not in this lab's store" in capsys.readouterr().err
    assert execute(["import", str(tmp_path / "bundle")]) == 0
    assert execute(command) == 2
    assert "names its laboratory" in capsys.readouterr().err
    assert not (tmp_path / "cal.xml").exists()


KINDS = {"rsa": lambda: rsa.generate_private_key(65537, 2048), "p-256": lambda: ec.generate_private_key(ec.SECP256R1())}
DAY = timedelta(days=1)


def certified(folder: Path, kind: str = "p-256", lock: bytes = b"", since: timedelta = -DAY) -> tuple[Path, Path]:
    """A key in PEM, locked by `lock`, and its certificate, which is valid for two days."""
    folder.mkdir(exist_ok=True)
    key, name = KINDS[kind](), x509.Name([x509.NameAttribute(x509.NameOID.COMMON_NAME, "A lab")])
    begins = datetime.now(UTC) + since
    made = x509.CertificateBuilder(name, name, key.public_key(), x509.random_serial_number(), begins, begins + 2 * DAY)
    for_file = BestAvailableEncryption(lock) if lock else NoEncryption()
    paths = (folder / "key.pem", folder / "cert.pem")
    paths[0].write_bytes(key.private_bytes(Encoding.PEM, PrivateFormat.PKCS8, for_file))
    paths[0].chmod(0o600)
    paths[1].write_bytes(made.sign(key, hashes.SHA256()).public_bytes(Encoding.PEM))
    return paths


def nobody() -> str:
    raise AssertionError("nobody is asked")


@pytest.mark.parametrize("kind", KINDS)
def test_the_xml_is_signed_by_a_key_with_a_certificate(kind: str, whole: Calibration, run: Run, tmp_path: Path):
    xades = pytest.importorskip("signxml.xades", reason="needs the extra `dcc` (signxml), which is not installed")
    key, certificate = certified(tmp_path / "lab", kind)
    xml = signed_xml(xml_of(whole, run), read_xml_key(key, certificate, nobody))
    seen = xades.XAdESVerifier().verify(xml, x509_cert=certificate.read_text(), expect_references=3)[0]
    assert seen.signed_xml.tag == f"{{{DCC}}}digitalCalibrationCertificate"
    assert objections(etree.fromstring(xml)) == objections(etree.fromstring(xml_of(whole, run)))
    forged = xml.replace(b"A lab &amp; co", b"Another lab")
    assert forged != xml
    with pytest.raises(pytest.importorskip("signxml").InvalidDigest):
        xades.XAdESVerifier().verify(forged, x509_cert=certificate.read_text(), expect_references=3)
    if (xmlsec1 := shutil.which("xmlsec1")) is not None:  # another's reading of the same standard
        for content, holds in ((xml, True), (forged, False)):
            (tmp_path / "dcc.xml").write_bytes(content)
            signed_id = ["--id-attr:Id", "http://uri.etsi.org/01903/v1.3.2#:SignedProperties"]
            trusted = ["--trusted-pem", str(certificate), str(tmp_path / "dcc.xml")]
            done = subprocess.run([xmlsec1, "--verify", *signed_id, *trusted], capture_output=True, text=True)
            assert (done.returncode == 0) is holds, done.stderr


def test_a_signed_certificate_obeys_its_schema(whole: Calibration, run: Run, schema: Schema, tmp_path: Path):
    assert schema.obeyed_by(signed_xml(xml_of(whole, run), read_xml_key(*certified(tmp_path), nobody)))


def test_a_key_that_may_not_sign_is_refused_in_a_sentence(tmp_path: Path):
    key, certificate = certified(tmp_path / "one", lock=b"correct horse")
    assert read_xml_key(key, certificate, lambda: "correct horse").algorithm == "ecdsa-sha256"
    other, late = certified(tmp_path / "two")[1], certified(tmp_path / "three", since=DAY)
    short, text = tmp_path / "short.pem", tmp_path / "text.pem"
    weak = rsa.generate_private_key(65537, 1024)
    short.write_bytes(weak.private_bytes(Encoding.PEM, PrivateFormat.PKCS8, NoEncryption()))
    text.write_text("no key")
    open_to_all = certified(tmp_path / "four")
    open_to_all[0].chmod(0o644)
    for path in (short, text):
        path.chmod(0o600)
    for key_file, certificate_file, says in (
        (key, certificate, "the passphrase is not its own"),
        (text, certificate, "is no private key in PEM"),
        (short, certificate, "is no RSA key of 2048 bits or more"),
        (open_to_all[0], open_to_all[1], "others may read this key"),
        (late[0], late[1], "not now; nothing was signed"),
        (late[0], other, "its first certificate is not that of the key in key.pem"),
        (late[0], text, "holds no X.509 certificate in PEM"),
    ):
        with pytest.raises(InputError, match=says):
            read_xml_key(key_file, certificate_file, lambda: "wrong horse")
