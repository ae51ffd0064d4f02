"""A cage calibration is a draft until another person approves it; then it drives the coils and carries a reference."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from labcal import session
from labcal.bench.coils.cage_file import CageCalibration, Place, read_cage, write_cage
from labcal.errors import InputError
from labcal.store import Store

BenchFile = Callable[..., Path]
PLACE_M = [0.0, 0.0, 0.3]
REMOTE = ('place = "dut"\nposition_m = [0.0, 0.0, 0.15]', f'place = "remote"\nposition_m = {PLACE_M}')
TWIN = f"reference_place_m = {PLACE_M}\nambient = {{ drift_nT = 0.0, mains_nT = 0.0 }}"
MATRIX = ((49942.0, -221.0, 169.0), (-301.0, 49951.0, 101.0), (-179.0, 151.0, 49944.0))
QUICK = {"rate_deg_per_s": "20", "zero_s": "2"}


def with_the_file(bench: Path) -> Path:
    """The bench file with the cage calibration beside it in place of its matrix."""
    text = bench.read_text(encoding="utf-8")
    start, end = text.index("matrix_nT_per_A"), text.index("settle_s")
    bench.write_text(text[:start] + 'calibration = "cage.json"\n' + text[end:], encoding="utf-8")
    return bench


def a_calibration(matrix: np.ndarray, offset: np.ndarray, u: float = 2.0) -> CageCalibration:
    """As approved: the bench's own matrix at the DUT, and `matrix`, `offset` beyond the reference's place."""
    covariance = (u**2 * np.eye(12)).tolist()
    at_dut = Place(matrix_nT_per_A=MATRIX, offset_nT=(0.0, 0.0, 0.0), covariance=covariance)
    carry = Place(matrix_nT_per_A=matrix.tolist(), offset_nT=offset.tolist(), covariance=covariance)
    return CageCalibration(
        run_id="C", simulated=True, measured_utc="2026-11-21T07:00:00Z", operator="J. Doe", approved_by="R. Roe",
        dut=at_dut, carry=carry, reference_position_m=(0.0, 0.0, 0.3),
    )  # fmt: skip


def test_the_carry_is_added_to_every_reading_of_a_remote_reference_and_its_uncertainty_to_the_record(
    bench_file: BenchFile, tmp_path: Path
) -> None:
    """The same lab twice, once with nothing to carry: the readings differ by M I + b0 of the currents in the record."""
    beyond, offset = np.array([[400.0, 0.0, -90.0], [30.0, -250.0, 0.0], [0.0, 60.0, 500.0]]), np.array([70.0, -40, 9])
    runs = []
    for matrix, b0 in ((0 * beyond, 0 * offset), (beyond, offset)):
        write_cage(a_calibration(matrix, b0), tmp_path / "cage.json")
        outcome = session.run("rotate-axis", with_the_file(bench_file(TWIN, REMOTE)), QUICK, seed=4)
        assert outcome.status == "finished", outcome.fault
        runs.append(session.load_run(outcome.run_id))
    without, carried = runs
    currents = np.nanmedian([carried.channel(f"i_coil_{a}").values for a in "xyz"], axis=1)
    moved = np.nanmedian(carried.reference_vector, axis=0) - np.nanmedian(without.reference_vector, axis=0)
    # carried or not, the reference sees what the coils make; they are not driven alike
    made = np.array(MATRIX) @ (currents - np.nanmedian([without.channel(f"i_coil_{a}").values for a in "xyz"], axis=1))
    assert moved - made == pytest.approx(beyond @ currents + offset, abs=60)
    assert (carried.reference.kind, carried.reference.place) == ("vector", "remote")
    assert carried.reference.u_offset_nT == pytest.approx(np.hypot(3.0, 2.0))
    assert carried.reference.u_scale_ppm == pytest.approx(np.hypot(50.0, 1e6 * 2.0 / 49_945), rel=1e-3)
    with Store.open() as store:
        digest = hashlib.sha256((tmp_path / "cage.json").read_bytes()).hexdigest()
        assert store.header(carried.run_id).cage_sha256 == digest


def test_without_it_a_remote_reference_is_not_written_as_the_field_at_the_dut(bench_file: BenchFile) -> None:
    outcome = session.run("rotate-axis", bench_file(TWIN, REMOTE), QUICK, seed=4)
    assert outcome.status == "finished", outcome.fault
    bundle = session.run_bundle(outcome.run_id)
    assert json.loads(bundle.run_json)["reference"]["kind"] == "none"
    assert b"ref_x" not in bundle.samples_csv.splitlines()[0]


def test_a_draft_is_approved_by_another_person_and_only_within_its_limits(
    bench_file: BenchFile, tmp_path: Path
) -> None:
    out, bench, given = tmp_path / "cage.json", bench_file(TWIN, REMOTE), {"steps": "2", "dwell_s": "1"}
    measured = session.run("cage-calibration", bench, given, operator="J. Doe", seed=4).run_id
    found = session.approve_cage(measured, "R. Roe", out)
    assert read_cage(out) == found
    assert (found.approved_by, found.operator, found.reference_position_m) == ("R. Roe", "J. Doe", (0.0, 0.0, 0.3))
    assert found.carry is not None
    assert np.abs(found.carry.matrix_nT_per_A).max() < 5 * found.carry.u_matrix_nT_per_A  # the twin's coils are even
    out.unlink()
    for same in (" j. doe ", "j.doe@lab", "J. D\N{CYRILLIC SMALL LETTER O}e"):
        with pytest.raises(InputError, match="another person than the operator approves"):
            session.approve_cage(measured, same, out)
    beyond = session.run("cage-calibration", bench, given | {"limit_ppm": "1"}, seed=4).run_id
    with pytest.raises(InputError, match="failed its limits: DUT: uncertainty of the matrix"):
        session.approve_cage(beyond, "R. Roe", out)
    other = session.run("ambient", bench_file(), {"duration_s": "10"}).run_id
    with pytest.raises(InputError, match="is no finished cage-calibration: it is of ambient, finished"):
        session.approve_cage(other, "R. Roe", out)
    assert not out.exists()


@pytest.mark.parametrize(
    ("edit", "says"),
    [
        (None, r"bench.toml, line 7: cage.calibration: there is no file"),
        (("run_id", "run"), "run_id: Field required"),
        (("0.3\n", "0.2\n"), r"was measured with the reference at \(0.0, 0.0, 0.2\), not at \(0.0, 0.0, 0.3\)"),
        (("[", "{"), "Invalid JSON"),
    ],
)
def test_a_file_that_does_not_fit_is_refused_in_a_sentence_and_the_coils_still_go_off(
    bench_file: BenchFile, tmp_path: Path, edit: tuple[str, str] | None, says: str
) -> None:
    out = tmp_path / "cage.json"
    if edit is not None:
        write_cage(a_calibration(np.zeros((3, 3)), np.zeros(3)), out)
        out.write_text(out.read_text(encoding="utf-8").replace(*edit), encoding="utf-8")
    bench = with_the_file(bench_file(TWIN, REMOTE))
    with pytest.raises(InputError, match=says):
        session.run("rotate-axis", bench, QUICK)
    assert all(end.fault is None for end in session.coils_off(bench))
