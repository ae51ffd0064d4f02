"""The certificate on paper: what ISO/IEC 17025:2017, 7.8.2 to 7.8.6, asks for, and what is on every sheet."""

from __future__ import annotations

import re
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

from labcal.certificate import Signer, calibration_bytes, sign, verify
from labcal.certificate.report import Circumstances, archival_pdf, calibration_page, write_report
from labcal.certificate.report.front import images_in
from labcal.certificate.report.html import html
from labcal.certificate.report.page import Facts, Front, Page, Prose, Section, Table
from labcal.certificate.report.style import with_uncertainty
from labcal.errors import InputError
from labcal.model import AffineMap, Calibration, EffectRecord, Parameter
from labcal.record import Administrative, Channel, Dut, Reference, Run, Segment
from labcal.record.administrative import Address, Certified, Equipment, Item, Laboratory
from labcal.record.specification import Limit, Specification
from labcal.uncertainty.conformity import changes

NOW = datetime(2026, 11, 21, tzinfo=UTC)
BY = {"street": "Gasse 4", "postcode": "3011", "code": "FL", "accreditation": "SCS 0999", "place": "hall 2"}
THERMOMETER = Certified("T-1", "METAS", "2025-02-01", "2026-02-01", "0.05 K")
OF_REFERENCE = {"number": "M-1", "issuer": "PTB", "date": "2026-01-05", "due": "2027-01-05"}
STATED = Administrative(
    Laboratory("Field Laboratory", "Bern", "CH", **BY),
    Address("Satellite Works", "Bremen", "DE"),
    Item("Fluxworks", "one scratch", "2026-11-02"),
    (Equipment("thermometer", "Fluke", "1524", "T-77", THERMOMETER),),
)
RUN = Run(
    "r-2026-11-21-01",
    "2026-11-20T23:50:00Z",
    False,
    "Grace Häberli",
    Dut("FM-07"),
    Reference(
        "vector", "H-1", certificate={"number": "M-1", "issuer": "PTB", "date": "2026-01-05", "due": "2027-01-05"}
    ),
    (Segment("a", "static"),),
    np.array([5.0, 1205.0]),
    np.zeros(2, dtype=np.intp),
    np.zeros((2, 3)),
    specification=Specification(offset=Limit(500.0, "nT"), title="ICD-7, issue C"),
    environment={"pressure_hPa": 955.0, "ambient_nT": 48_000.0, "ambient_variation_nT": 35.0, "Kp": 2.0},
    channels=(Channel("t_room", "degC", "temperature", np.array([21.0, 23.0]), "room"),),
)
INSTRUMENTS = (
    {"name": "supply_x", "manufacturer": "Aim-TTi", "model": "PL303", "serial": ""},
    {"name": "fluxgate", "manufacturer": "Honeywell", "model": "HMR2300", "serial": "H-1"},
)
JUDGED = {"quantity": "scale x", "value": 1e-05, "U": 1e-6, "limit": 0.5, "unit": "%", "rule": "w = U", "risk": 0.0,
          "result": "pass", "tur": None}  # fmt: skip
ROW = {
    "source": "zero",
    "type": "B",
    "distribution": "normal",
    "u": 8.7,
    "unit": "nT",
    "sensitivity": 1.0,
    "share": 1.0,
}
BUDGET = {"quantity": "b x", "at": "50 µT along +x", "unit": "nT", "U": 17.4, "k": 2.0, "dof": None,
          "rows": ({**ROW, "share": 1.0, "dof": None},), "correlations": ()}  # fmt: skip

CLAUSES = [
    ("7.8.2.1 a", "Calibration certificate"),
    ("7.8.2.1 b", "Field Laboratory, Gasse 4, CH-3011 Bern"),
    ("7.8.2.1 c", "Place hall 2"),
    ("7.8.2.1 d", "No. FL-CAGE-2026-0007"),
    ("7.8.2.1 d, end", "End of the certificate FL-CAGE-2026-0007."),
    ("7.8.2.1 e", "Customer Satellite Works, Bremen (DE)"),
    ("7.8.2.1 f", "Method the laboratory&#39;s own: procedure preflight; estimated by ml"),
    ("7.8.2.1 g", "magnetometer, Fluxworks, flight model, serial FM-07"),
    ("7.8.2.1 g, condition", "Condition of the item one scratch"),
    ("7.8.2.1 h", "Received 2026-11-02"),
    ("7.8.2.1 i", "Calibrated 2026-11-20 to 2026-11-21"),
    ("7.8.2.1 j", "Issued 2026-11-21"),
    ("7.8.2.1 l", "The results relate only to the item named above"),
    ("7.8.2.1 m", "U = 17 nT largest expanded uncertainty of a component of the field from one reading, k = 2.00"),
    ("7.8.2.1 o", "Measured by Grace Häberli Approved by bob (has not signed)"),
    ("7.8.4.1 b", "Temperature 22.0 °C, from 21.0 to 23.0 measured along the run: t_room"),
    ("7.8.4.1 b", "Pressure 955 hPa"),
    ("7.8.4.1 b", "Its variation, peak to peak 35 nT"),
    ("7.8.4.1 c", "reference (vector) Honeywell HMR2300 H-1 M-1 PTB 2026-01-05 2027-01-05"),
    ("7.8.6.2 b", "Specification: ICD-7, issue C."),
    ("7.8.4.1 c", "thermometer Fluke 1524 T-77 T-1 METAS 2025-02-01 2026-02-01 OVERDUE 0.05 K"),
    (
        "7.8.4.3",
        "Last day of use 2027-11-21, as stated at approval: a recommendation, which the customer has to have agreed to",
    ),
    ("accreditation", "Accreditation SCS 0999"),
    ("7.8.8", "Supersedes"),
    ("signatures", "ssh-keygen -Y verify -f allowed_signers -I SIGNER -n labcal-calibration -s cal.json.sshsig"),
]


@pytest.fixture
def issued(calibration: Calibration) -> Calibration:
    return replace(
        calibration, simulated=False, number="FL-CAGE-2026-0007", issued_utc="2026-11-21T09:00:00Z", budget=(BUDGET,),
        specification=(JUDGED,),
        approvers=("bob",), made_by={"command": "fit", "method": "ml", "channels": None, "empirical": False,
                                     "version": "0.1.0"},
    )  # fmt: skip


def page_of(path: Path, calibration: Calibration, lab: tuple[Signer, ...] = (), run: Run | None = RUN) -> Page:
    path.write_bytes(calibration_bytes(calibration)) if not lab else None
    checked = verify(path, lab, frozenset(), NOW)
    said = Circumstances(STATED, "preflight", "cd" * 32, (), INSTRUMENTS)
    return calibration_page(calibration, checked, "now", run, None, said)


def words(page: Page) -> str:
    return " ".join(re.sub(r"<(style|svg).*?</\1>|<[^>]+>", " ", html(page), flags=re.DOTALL).split())


def test_every_clause_is_on_the_certificate(issued: Calibration, tmp_path: Path):
    page = words(page_of(tmp_path / "cal.json", issued))
    assert [clause for clause, says in CLAUSES if says not in page] == []


def test_what_nobody_stated_is_said_to_be_so(issued: Calibration, tmp_path: Path):
    path = tmp_path / "cal.json"
    path.write_bytes(calibration_bytes(replace(issued, number=None, issued_utc=None, budget=())))
    checked = verify(path, (), frozenset(), NOW)
    bare = replace(RUN, reference=Reference("vector", "H-1"), environment=None, channels=())
    page = words(calibration_page(replace(issued, number=None, issued_utc=None, budget=()), checked, "now", bare))
    for says in ("Without a number", "Laboratory not stated", "Customer not stated", "no date of issue is stated",
                 "Traceability to the SI is not shown", "Nothing is stated of temperature"):  # fmt: skip
        assert says in page, says
    assert "not known here: the run is not in this lab" in words(page_of(path, issued, run=None))


@pytest.mark.parametrize(
    ("dates", "says"),
    [
        ({"date": "2026-01-05", "due": "2026-11-19"}, "certificate was overdue on the day of the measurement."),
        ({"date": "2026-11-22", "due": "2027-11-22"}, "certificate was not yet issued on the day of the measurement."),
        ({"date": "2026-11-20", "due": "2026-11-20"}, "traceable to the International System of Units (SI)"),
    ],
)
def test_a_certificate_that_does_not_hold_on_the_day_shows_no_traceability(
    dates: dict[str, str], says: str, issued: Calibration, tmp_path: Path
):
    run = replace(RUN, reference=Reference("vector", "H-1", certificate={**OF_REFERENCE, **dates}))
    page = words(page_of(tmp_path / "cal.json", issued, run=run))
    assert says in page
    assert ("traceable to the International" in page) == ("traceable" in says)


def test_what_of_the_surroundings_is_not_stated_is_said_beside_what_is(issued: Calibration, tmp_path: Path):
    page = words(page_of(tmp_path / "cal.json", issued, run=replace(RUN, channels=())))
    for says in ("Temperature not stated", "Humidity not stated", "Ambient field, without the coils 48 000 nT"):
        assert says in page, says


def test_a_method_that_states_no_uncertainty_names_no_rule_for_it(issued: Calibration, tmp_path: Path):
    assert "no uncertainty" in words(page_of(tmp_path / "cal.json", replace(issued, covariance=None, budget=())))
    assert "; uncertainty by JCGM 100:2008" in words(page_of(tmp_path / "cal.json", issued))


def test_no_U_is_printed_beside_another_component_s_k(issued: Calibration, tmp_path: Path):
    budget = (BUDGET, {**BUDGET, "quantity": "b y", "U": 9.0, "k": 2.31}, {**BUDGET, "quantity": "b z"})
    page = words(page_of(tmp_path / "cal.json", replace(issued, budget=budget)))
    assert "50 µT along +x 17 9.0 17 2.00, 2.31, 2.00" in page


def test_no_unit_1_stands_behind_a_ratio(issued: Calibration, tmp_path: Path):
    row = {**ROW, "source": "noise", "u": 0.0006, "unit": "1", "dof": 90.0}
    scale = {**BUDGET, "quantity": "scale x", "at": "", "unit": "1", "U": 0.0012, "rows": (row,)}
    page = words(page_of(tmp_path / "cal.json", replace(issued, budget=(BUDGET, scale))))
    assert "scale x: U = 0.0012, k = 2.00" in page
    assert "noise B normal 0.00060 1 0.00060 100.0 % 90" in page  # u, and its sensitivity of one


def test_a_key_breaks_where_a_screen_ends_and_a_date_nowhere(issued: Calibration, tmp_path: Path):
    table = Table(
        ("Key", "Date", "Said"), (("SHA256:zI09vECcGr48ZduHuWSgrEdbMt1yUPOHR1xl+Y3Sxjw", "2026-11-21", "a b" * 9),)
    )
    page = replace(page_of(tmp_path / "cal.json", issued), sections=(Section("Signatures", (table,)),))
    assert '<td class="word">SHA256:' in html(page)
    assert '<td class="short">2026-11-21</td><td>a b' in html(page)


def test_what_the_sensor_indicates_is_what_its_map_reads_in_that_field(issued: Calibration, tmp_path: Path):
    affine = AffineMap(np.diag([1.02, 0.98, 1.0]), np.array([100.0, -50.0, 0.0]))
    _, high = issued.validity.field_nT
    made = replace(issued, affine=affine, effects=(), dut=replace(issued.dut, unit="nT", nominal_nT_per_unit=1.0))
    results = page_of(tmp_path / "cal.json", made).sections[0].blocks[0]
    assert results.header == ("Field", "Component", "Applied (nT)", "Indicated (nT)", "Error (nT)", "U (nT)", "k")
    assert [row[:2] for row in results.rows[:4]] == [
        ("60 µT along +x", "b x"),
        ("", "b y"),
        ("", "b z"),
        ("60 µT along +y", "b x"),
    ]
    printed = (cell.replace("\u202f", "").replace("\u2212", "-") for cell in results.rows[0][2:6])
    applied, indicated, error, U = map(float, printed)
    rounding = 10 ** np.floor(np.log10(U) - 1)
    assert applied == pytest.approx(high, abs=rounding)
    assert indicated == pytest.approx((high + 100.0) / 1.02, abs=rounding)
    assert error == pytest.approx((high + 100.0) / 1.02 - high, abs=rounding)
    loaded = page_of(tmp_path / "cal.json", replace(made, k_at={"i_load": 1.0})).sections[0].blocks[0]
    assert loaded.caption.startswith("Before correction, at i_load = 1: what it indicates is its reading")


def test_rows_that_were_set_aside_are_counted_without_an_uncertainty(issued: Calibration, tmp_path: Path):
    rows = Parameter("rows", 3.0, 0.0, "1")
    found = EffectRecord("outliers", (), {}, "data", (rows,), why="3 rows (0.5 %) set aside")
    page = words(page_of(tmp_path / "cal.json", replace(issued, findings=(found,))))
    assert "rows 3 \N{EN DASH} \N{EN DASH} Effects of the data" in page


def test_a_limit_and_a_direction_are_printed_as_the_other_numbers_are(issued: Calibration, tmp_path: Path):
    judged = {**JUDGED, "limit": 5000.0}
    changed = changes(issued, replace(issued, run_id="r-2025-11-02-01"))
    path = tmp_path / "cal.json"
    path.write_bytes(calibration_bytes(replace(issued, specification=(judged,))))
    checked = verify(path, (), frozenset(), NOW)
    page = words(calibration_page(replace(issued, specification=(judged,)), checked, "now", RUN, changed))
    assert "5 000 % PASS" in page
    assert "|b| at \N{MINUS SIGN}x" in page


@pytest.mark.parametrize(
    ("value", "U", "printed"),
    [
        (12.3456, 0.0996, ("12.35", "0.10")),
        (1234.6, 123.4, ("1\u202f230", "120")),
        (-0.00123456, 0.0000213, ("\u22120.001235", "0.000021")),
        (880.4, 9.96, ("880", "10")),
        (5.0, 0.0, ("5.000", "0.000")),
    ],
)
def test_U_has_two_digits_and_the_value_ends_where_it_does(value: float, U: float, printed: tuple[str, str]):
    assert with_uncertainty(value, U) == printed


def test_what_is_no_certificate_of_a_real_sensor_says_so_across_the_page(
    issued: Calibration, tmp_path: Path, lab: tuple[Signer, ...], key: Ed25519PrivateKey
):
    path = tmp_path / "cal.json"
    assert page_of(path, issued).front.stamp == "DRAFT, NOT SIGNED"
    assert page_of(path, replace(issued, simulated=True)).front.stamp == "SIMULATED · DRAFT, NOT SIGNED"
    page_of(path, issued)
    sign(path, "ada", key, lab)
    assert page_of(path, issued, lab).front.stamp == ""
    path.write_bytes(path.read_bytes() + b" ")
    assert page_of(path, issued, lab).front.stamp == "SIGNATURE NOT VALID"


def test_nothing_simulated_is_in_an_accreditation_s_scope(issued: Calibration, tmp_path: Path):
    assert "SCS 0999" not in words(page_of(tmp_path / "cal.json", replace(issued, simulated=True)))
    for name in ("logo", "accreditation"):
        (tmp_path / f"{name}.svg").write_text("<svg/>")
    assert len(images_in(tmp_path)) == 2
    assert images_in(tmp_path, accredited=False) == images_in(tmp_path)[:1]


def test_units_are_printed_with_their_symbols_and_points_with_their_units(issued: Calibration, tmp_path: Path):
    effect = EffectRecord("offset-current", ("i_eps",), {"i_eps": 0.05}, "sensor",
                          (Parameter("c_x", 900.0, 9.0, "nT/A"),))  # fmt: skip
    at, angle = "50 µT along +x, i_eps = 0.4276", {"quantity": "off 90° x-y", "at": "", "unit": "deg"}
    correlated = {"one": "K_xy", "other": "k_x", "r": -0.93}
    budgets = ({**BUDGET, "at": at, "correlations": (correlated,)}, {**BUDGET, **angle})
    told = words(page_of(tmp_path / "cal.json", replace(issued, budget=budgets, effects=(effect,))))
    assert "50 µT along +x, i_eps = 0.4276 A 17" in told
    assert "b x at 50 µT along +x, i_eps = 0.4276 A: U = 17 nT" in told
    assert "i_eps counts from 0.05 A." in told
    assert "K_xy and k_x −0.93" in told
    assert "off 90° x-y – 17 2.00 °" in told


def test_what_a_file_says_ends_no_style_sheet(issued: Calibration, tmp_path: Path):
    evil = replace(issued, number='"; } </style><script>alert(1)</script>')
    text = html(page_of(tmp_path / "cal.json", evil))
    assert "<script" not in text
    assert text.split("<body>")[0].count("</style>") == 1


def test_logo_and_mark_come_from_the_lab_s_folder(tmp_path: Path):
    (tmp_path / "logo.svg").write_text("<svg xmlns='http://www.w3.org/2000/svg'/>")
    (tmp_path / "accreditation.png").write_bytes(b"x" * 600_000)
    assert [image[:24] for image in images_in(tmp_path)] == ["data:image/svg+xml;base64"[:24]]


def test_without_the_extra_the_pdf_is_a_plain_one_and_that_is_said(
    issued: Calibration, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setitem(__import__("sys").modules, "weasyprint", None)
    page = page_of(tmp_path / "cal.json", issued)
    assert "labcal[paper]" in write_report(page, tmp_path / "cal.pdf")
    assert write_report(page, tmp_path / "cal.html") == ""
    pdfium = pytest.importorskip("pypdfium2")
    sheets = [sheet.get_textpage().get_text_range() for sheet in pdfium.PdfDocument(tmp_path / "cal.pdf")]
    assert "FL-CAGE-2026-0007" in "".join(sheets)


@pytest.fixture(scope="module")
def printed(tmp_path_factory: pytest.TempPathFactory) -> SimpleNamespace:
    try:
        archival_pdf.typesetter()
    except InputError:
        pytest.skip("needs the extra `paper` (weasyprint) and the system's Pango, which are not here")
    return SimpleNamespace(folder=tmp_path_factory.mktemp("printed"))


def test_the_pdf_is_archival_and_holds_what_was_signed(
    issued: Calibration, printed: SimpleNamespace, lab: tuple[Signer, ...], key: Ed25519PrivateKey
):
    pikepdf = pytest.importorskip("pikepdf")
    pdfium = pytest.importorskip("pypdfium2")
    path, out = printed.folder / "cal.json", printed.folder / "cal.pdf"
    simulated = replace(issued, simulated=True)
    page_of(path, simulated)
    sign(path, "ada", key, lab)
    page = page_of(path, simulated, lab)
    write_report(page, out)
    with pikepdf.open(out) as pdf:
        assert pdf.open_metadata().pdfa_status == "3B"
        assert [intent.S for intent in pdf.Root.OutputIntents] == ["/GTS_PDFA1"]
        assert "/DestOutputProfile" in pdf.Root.OutputIntents[0]
        assert set(map(_embedded, _fonts(pdf))) == {True}
        held = {name: spec.get_file().read_bytes() for name, spec in pdf.attachments.items()}
        assert held == {f.name: f.read_bytes() for f in (path, path.with_name("cal.json.sshsig"))}
        assert sorted(str(spec.UF) for spec in pdf.Root.AF) == sorted(held)
        assert not pdf.is_encrypted
    sheets = [sheet.get_textpage().get_text_range() for sheet in pdfium.PdfDocument(out)]
    for number, sheet in enumerate(sheets, 1):
        assert f"page {number} of {len(sheets)}" in sheet
        assert "FL-CAGE-2026-0007" in sheet
        assert "".join(sheet.split()).count("SIMULATED") >= 2  # in the margin, and across the sheet


def test_a_last_group_that_fits_with_smaller_gaps_has_no_sheet_of_its_own(printed: SimpleNamespace):
    pdfium = pytest.importorskip("pypdfium2")
    typesetter, out = archival_pdf.typesetter(), printed.folder / "gaps.pdf"

    def page(groups: int) -> Page:
        each = tuple(Section(f"Group {n}", (Prose(("One.", "Two.")),)) for n in range(groups))
        return Page("Certificate", "FM-07", "", False, Facts(()), each, front=Front("1", "foot", ""))

    def loose(one: Page) -> int:
        return len(typesetter.HTML(string=html(one)).render().pages)

    first = next(groups for groups in range(4, 40) if loose(page(groups)) > 1)
    write_report(page(first), out)
    assert len(pdfium.PdfDocument(out)) == 1
    write_report(page(2 * first), out)
    assert len(pdfium.PdfDocument(out)) == 2


def _fonts(pdf: object) -> list[object]:
    return [font for page in pdf.pages for font in (page.Resources.get("/Font") or {}).values()]


def _embedded(font: object) -> bool:
    descriptor = font.DescendantFonts[0].FontDescriptor if "/DescendantFonts" in font else font.FontDescriptor
    return any(name in descriptor for name in ("/FontFile", "/FontFile2", "/FontFile3"))


def test_needed_names_the_extra():
    assert "pip install 'labcal[paper]'" in archival_pdf.NEEDED
