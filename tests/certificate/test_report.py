from __future__ import annotations

import re
from dataclasses import replace
from datetime import UTC, datetime
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

from labcal.certificate import Signer, sign, verify
from labcal.certificate.report import calibration_page, run_page, write_report
from labcal.certificate.report.calibration import name_of
from labcal.certificate.report.derived import sensor_figures
from labcal.certificate.report.figures import coverage
from labcal.certificate.report.html import html
from labcal.certificate.report.page import Facts, Page, Plot, Prose, Section
from labcal.certificate.report.style import decimals_for, number
from labcal.cli import execute
from labcal.errors import InputError
from labcal.fit import Fit
from labcal.model import AffineMap, Calibration
from labcal.record import Channel, Dut, Reference, Run, Segment
from labcal.uncertainty.unstated import not_stated

NOW = datetime(2026, 11, 21, tzinfo=UTC)


def page_text(calibration: Calibration, path: Path, lab: tuple[Signer, ...] = ()) -> str:
    checked = verify(path, lab, frozenset(), NOW)
    return html(calibration_page(calibration, checked, "2026-11-21 12:00 UTC"))


@pytest.fixture
def run() -> Run:
    turn = np.linspace(0, 2 * np.pi, 60, endpoint=False)
    zero = np.zeros_like(turn)
    circles = [np.column_stack(c) for c in ((zero, np.cos(turn), np.sin(turn)), (np.cos(turn), zero, np.sin(turn)))]
    field = 40_000 * np.concatenate(circles)
    axes = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    return Run(
        run_id="r-<1>",
        started_utc="2026-11-21T08:00:00Z",
        simulated=True,
        operator="Grace",
        dut=Dut("FM-07", noise_nT=20.0),
        reference=Reference("scalar", noise_nT=3.0, u_time_s=0.001),
        segments=tuple(Segment(f"axis-{i}", "rotation", "nominal", axis_body=a) for i, a in enumerate(axes)),
        t_s=np.arange(120.0),
        segment_index=np.repeat([0, 1], 60),
        reading=field + 100.0,
        reference_magnitude=np.full(120, 40_000.0),
        channels=(Channel("temp_dut", "degC", "temperature", np.full(120, np.nan)),),
    )


def test_the_page_of_a_calibration_says_what_the_file_says(
    calibration: Calibration, draft: Path, lab: tuple[Signer, ...], key: Ed25519PrivateKey
):
    text = page_text(calibration, draft)
    assert "NOT SIGNED" in text
    sign(draft, "ada", key, lab)
    text = page_text(calibration, draft, lab)
    for said in (
        "FM-07",
        "SIMULATED",
        "SIGNED · VALID",
        "PROVISIONAL",
        "88.5",
        "43.8",
        "offset-current · i_eps",
        "112.50",
        "axis-tilt (provisional)",
        "The platform axis leans",
        "2027-11-21",
        "mounting uncertainty not included",
    ):
        assert said in text, said
    draft.write_bytes(draft.read_bytes() + b" ")
    assert "SIGNATURE NOT VALID" in page_text(calibration, draft, lab)


def test_a_real_calibration_does_not_say_simulated(calibration: Calibration, real_draft: Path):
    assert "simulated" not in page_text(replace(calibration, simulated=False), real_draft).lower().split("<body>")[1]


def test_what_a_file_says_is_never_markup(calibration: Calibration, draft: Path):
    evil = replace(
        calibration, operator="<script>alert(1)</script>", dut=replace(calibration.dut, serial="a'\"><img src=x>")
    )
    text = page_text(evil, draft)
    assert "<script" not in text
    assert "<img src=x" not in text


def test_a_page_needs_nothing_from_elsewhere(calibration: Calibration, draft: Path, run: Run):
    for text in (page_text(calibration, draft), html(run_page(run, "ab" * 32, Fit("ml", False, why_not="no reason")))):
        body = re.sub(r'xmlns(:\w+)?="[^"]*"|<!DOCTYPE.*?>', "", text)
        assert not re.findall(r"(?:src|href)=\"(?!#|data:)[^\"]*\"|url\((?!#)|@import|<link|<script", body)
        HTMLParser().feed(text)


def test_k_of_a_sensor_that_counts_is_in_nT_per_count(calibration: Calibration, draft: Path):
    assert "K · x (nT/count)" in page_text(replace(calibration, dut=replace(calibration.dut, unit="count")), draft)
    assert "K · x (" not in page_text(replace(calibration, dut=replace(calibration.dut, unit="nT")), draft)


def test_the_page_of_a_run_shows_the_residual_that_the_fit_leaves(run: Run):
    fit = Fit("ml", True, affine=AffineMap(np.eye(3), np.full(3, 100.0)))
    text = html(run_page(run, "ab" * 32, fit))
    assert "r-&lt;1&gt;" in text
    assert "residual of the magnitude has an rms of 0.0 nT; the sensor&#39;s declared noise alone gives 20.0 nT" in text
    assert text.count("<svg") == 4
    assert "Of the reference, because the run does not state it: scale, zero, own calibration." in text


def test_a_run_without_a_fit_says_why(run: Run):
    text = html(run_page(run, "ab" * 32, Fit("ml", False, why_not="one axis is missing")))
    assert "No fit: one axis is missing." in text
    bare = replace(run, reference=Reference("none"), reference_magnitude=None)
    assert "there is no reference" in html(run_page(bare, "ab" * 32, Fit("ml", False, why_not="no reference")))


def test_the_same_page_gives_the_same_bytes(run: Run):
    page = run_page(run, "ab" * 32, Fit("ml", True, affine=AffineMap(np.eye(3), np.full(3, 100.0))))
    assert html(page) == html(page)


@pytest.mark.slow
def test_the_same_page_gives_the_same_bytes_of_pdf(run: Run, tmp_path: Path):
    page = run_page(run, "ab" * 32, Fit("ml", True, affine=AffineMap(np.eye(3), np.full(3, 100.0))))
    for path in (tmp_path / "1.pdf", tmp_path / "2.pdf"):
        write_report(page, path)
    assert (tmp_path / "1.pdf").read_bytes() == (tmp_path / "2.pdf").read_bytes()


def test_a_run_is_set_on_sheets_with_its_figures(run: Run, tmp_path: Path):
    page = run_page(run, "ab" * 32, Fit("ml", True, affine=AffineMap(np.eye(3), np.full(3, 100.0))))
    write_report(page, tmp_path / "run.pdf")
    assert len((tmp_path / "run.pdf").read_bytes()) > 20_000


def sheets_of(path: Path) -> int:
    return len(re.findall(rb"/Type /Page\b", path.read_bytes()))


def test_the_last_group_has_no_sheet_of_its_own_where_lower_figures_make_room(tmp_path: Path):
    """Two figures, and a group that is a few lines too long for the first sheet; as many lines more have one."""

    def written(lines: int) -> int:
        figure = Plot(lambda figure: figure.subplots(), 4.0, "A figure.")
        last = Section("What is not covered", (Prose(("Its temperature.",) * lines),))
        page = Page("Run", "demo-0", "", False, Facts(()), (Section("Figures", (figure, figure)), last))
        write_report(page, tmp_path / "page.pdf")
        return sheets_of(tmp_path / "page.pdf")

    assert written(6) == 1
    assert written(40) == 2


def test_an_ending_that_is_no_report_is_refused(run: Run, tmp_path: Path):
    with pytest.raises(InputError, match=r"\.html or \.pdf"):
        write_report(run_page(run, "", Fit("ml", False, why_not="")), tmp_path / "x.doc")
    assert not list(tmp_path.iterdir())


def test_what_a_run_states_of_its_reference_is_not_listed(run: Run):
    whole = Reference("scalar", "", 1.0, u_scale_ppm=1, u_offset_nT=1, u_time_s=1, calibration="2026")
    segments = tuple(replace(s, u_axis_body_deg=0.1) for s in run.segments)
    assert not_stated(replace(run, reference=whole, segments=segments)) == (
        "All that the run states of its reference and mounting is covered.",
    )
    assert "alignment" in not_stated(replace(run, reference=replace(whole, kind="vector")))[0]


def test_a_sensor_is_not_named_twice():
    assert [name_of(Dut(*d)) for d in (("7", "M3"), ("HMC", "HMC"), ("7",))] == ["7 M3", "HMC", "7"]


def test_coverage_of_one_great_circle_is_the_band_around_it():
    turn = np.linspace(0, 2 * np.pi, 400)
    circle = np.column_stack([np.cos(turn), np.sin(turn), 0 * turn])
    assert coverage(circle) == pytest.approx(
        np.sin(np.radians(20)), abs=0.02
    )  # a zone's share is sin of its half width
    assert coverage(np.full((3, 3), np.nan)) == 0


def test_figures_of_the_sensor_are_those_it_was_built_with():
    angle = np.radians(0.5)
    scale, zero = np.array([0.5, 0.4, 0.25]), np.array([100.0, -50.0, 7.0])  # nT per count, counts
    sensitive = np.array([[1, 0, 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]]) / scale[:, None]
    affine = AffineMap(np.linalg.inv(sensitive), np.linalg.inv(sensitive) @ zero)
    calibration = _with(affine, np.diag([1e-12] * 9 + [1.0] * 3))
    x, y, z = sensor_figures(calibration, 2.0).rows
    assert [x[1], y[1], z[1]] == ["0.5000000", "0.4000000", "0.2500000"]
    assert [x[3], y[3], z[3]] == ["100.0", "−50.0", "7.0"]
    assert [x[6], y[6], z[6]] == ["0.50000"[: len(x[6])], "0.0000"[: len(y[6])], "0.0000"[: len(z[6])]]
    assert x[4] == "4.0"  # 2 * 1 nT / 0.5 nT per count


def test_uncertainty_of_a_scale_follows_a_monte_carlo():
    rng = np.random.default_rng(1)
    affine = AffineMap(np.array([[0.5, 0.01, 0], [0, 0.45, 0.02], [0.01, 0, 0.52]]), np.array([120.0, -8, 3]))
    root = rng.normal(size=(12, 12)) * np.r_[np.full(9, 1e-5), np.full(3, 1.0)][:, None]
    drawn = affine.parameters + rng.normal(size=(20_000, 12)) @ root.T
    K = drawn[:, :9].reshape(-1, 3, 3)
    scales = 1 / np.linalg.norm(np.linalg.inv(K), axis=2)
    zero = np.linalg.solve(K, drawn[:, 9:, None])[:, :, 0]
    rows = sensor_figures(_with(affine, root @ root.T), 1.0).rows
    for axis, row in enumerate(rows):
        assert float(row[2]) == pytest.approx(scales[:, axis].std(), rel=0.06)
        assert float(row[4]) == pytest.approx(zero[:, axis].std(), rel=0.06)


def _with(affine: AffineMap, covariance: np.ndarray) -> Calibration:
    from labcal.model import Validity

    return Calibration("r", True, Dut("s", unit="count"), affine, covariance, True, Validity((0, 1)), (0, 1), "ab" * 32)


@pytest.mark.parametrize(
    ("value", "decimals", "text"),
    [(-3.25, 1, "−3.2"), (20000.0, 0, "20\u202f000"), (-0.001, 1, "0.0"), (float("nan"), 1, "–"), (None, 1, "–")],
)
def test_numbers_are_written_one_way(value: float | None, decimals: int, text: str):
    assert number(value, decimals) == text


def test_decimals_show_two_digits_of_the_uncertainty():
    assert [decimals_for([u]) for u in (0.8, 0.04, 4.0, 25.0, 1300.0, 0.0)] == [2, 3, 1, 0, 0, 3]


def test_the_command_writes_a_certificate(draft: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    assert execute(["report", str(draft), "--out", str(tmp_path / "r.html")]) == 0
    assert "Calibration certificate" in (tmp_path / "r.html").read_text(encoding="utf-8")
    assert execute(["report", str(draft), "--out", str(tmp_path / "r.txt")]) == 2
    assert execute(["report", "no-such-run", "--out", str(tmp_path / "r.html")]) == 2
    draft.write_bytes(b"{}")
    assert execute(["report", str(draft), "--out", str(tmp_path / "s.html")]) == 2
    assert not (tmp_path / "s.html").exists()


def test_a_segment_may_be_called_anything_and_readings_may_be_nothing(run: Run):
    named = tuple(replace(s, id=id_) for s, id_ in zip(run.segments, ("$\\frac{$", "测" * 100), strict=True))
    strange = replace(run, segments=named, reading=np.zeros_like(run.reading))
    assert "$\\frac{$" in html(run_page(strange, "ab" * 32, Fit("ml", False, why_not="nothing moves")))
