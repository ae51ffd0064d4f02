"""A cage calibration is a draft until another person approves it; then it drives the coils and carries a reference."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
from collections.abc import Callable
from pathlib import Path
from unittest.mock import patch

import numpy as np
import pytest
from cage_files import MATRIX, a_calibration, with_the_file

from labcal import certificate, session
from labcal.bench.coils.cage_file import read_cage, write_cage
from labcal.bench.config import read_config
from labcal.certificate.agent import signed
from labcal.cli import execute
from labcal.errors import InputError
from labcal.files.home import home
from labcal.record.stream import REMARK
from labcal.session.audited import note_file
from labcal.store import Store

BenchFile = Callable[..., Path]
PLACE_M = [0.0, 0.0, 0.3]
REMOTE = ('place = "dut"\nposition_m = [0.0, 0.0, 0.15]', f'place = "remote"\nposition_m = {PLACE_M}')
TWIN = f"reference_place_m = {PLACE_M}\nambient = {{ drift_nT = 0.0, mains_nT = 0.0 }}"
PASSPHRASE = "correct horse"
QUICK = {"rate_deg_per_s": "20", "zero_s": "2"}


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
    found, signature = session.approve_cage(measured, "R. Roe", out)
    assert signature is None
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


def a_signed_cage(folder: Path, signer: str = "r.roe") -> Path:
    """A cage calibration in `folder` that R. Roe approved and `signer`, whose key is made here, signed."""
    cage = folder / "cage.json"
    write_cage(a_calibration(np.zeros((3, 3)), np.zeros(3)), cage)
    if not session.asks_passphrase(signer):
        session.new_key(signer, PASSPHRASE)
    key = certificate.keys.signing_key(home(), signer, PASSPHRASE)
    cage.with_name("cage.json.sshsig").write_text(signed(cage.read_bytes(), key), encoding="utf-8")
    return cage


def test_an_approver_whose_key_is_here_signs_the_cage_and_the_bench_takes_it(
    bench_file: BenchFile, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The whole way by commands; the file that nobody could sign is named in the record of the run it drives."""
    bench, given = bench_file(TWIN, REMOTE), {"steps": "2", "dwell_s": "1"}
    measured = session.run("cage-calibration", bench, given, operator="J. Doe", seed=4).run_id
    cage = tmp_path / "cage.json"
    said = command(capsys, "bench", "cage", measured, "--as", "R. Roe", "--out", str(cage))
    assert "NOT SIGNED: no key of R. Roe is at hand here." in said
    run = session.run("rotate-axis", with_the_file(bench), QUICK, seed=4)
    assert run.status == "finished", run.fault
    with Store.open() as store:
        [remark] = [i.text for i in store.items(run.run_id, but="block") if getattr(i, "kind", "") == REMARK]
    assert remark == "cage.json is not signed: that R. Roe approved it is a claim."
    assert f"! {remark}" in command(capsys, "bench", "check", str(bench))

    session.new_key("r.roe", PASSPHRASE)
    monkeypatch.setenv("LABCAL_PASSPHRASE", PASSPHRASE)
    signature = tmp_path / "cage.json.sshsig"
    assert f"{signature}: signed " in command(capsys, "bench", "cage", measured, "--as", "R. Roe", "--out", str(cage))
    assert session.cage_remark(bench) is None
    [*_, last] = session.read_audit().entries
    assert last.about["signature"] == hashlib.sha256(signature.read_bytes()).hexdigest()
    with pytest.raises(InputError, match=r"is signed \(cage.json.sshsig\): nothing replaces it"):
        session.approve_cage(measured, "R. Roe", cage, lambda signer: PASSPHRASE, force=True)


def test_a_signed_cage_that_was_altered_drives_no_coil(bench_file: BenchFile, tmp_path: Path) -> None:
    cage, bench = a_signed_cage(tmp_path), with_the_file(bench_file(TWIN, REMOTE))
    assert session.cage_remark(bench) is None
    as_signed = cage.read_text(encoding="utf-8")
    forgeries = (
        lambda: cage.write_text(as_signed.replace("49942.0", "49492.0"), encoding="utf-8"),
        lambda: cage.write_text(as_signed.replace("R. Roe", "J. Roe"), encoding="utf-8"),
        lambda: cage.write_text(as_signed.replace("49942.0", "Infinity"), encoding="utf-8"),
        lambda: cage.with_name("cage.json.sshsig").write_bytes(b"-----BEGIN SSH SIGNATURE-----"),
    )
    for forge in forgeries:
        forge()
        with pytest.raises(InputError, match=r"its signature cage.json.sshsig: .*no coil is driven by it"):
            session.run("rotate-axis", bench, QUICK)
        a_signed_cage(tmp_path)
    assert session.runs() == []


def test_a_cage_that_its_own_operator_approved_drives_no_coil(bench_file: BenchFile, tmp_path: Path) -> None:
    bench = with_the_file(bench_file(TWIN, REMOTE))
    made = a_calibration(np.zeros((3, 3)), np.zeros(3))
    write_cage(made.model_copy(update={"operator": "r.r\N{CYRILLIC SMALL LETTER O}e"}), tmp_path / "cage.json")
    with pytest.raises(InputError, match=r"approved_by: R\. Roe is its operator, .*no coil is driven by it"):
        session.run("rotate-axis", bench, QUICK)
    assert session.runs() == []


def test_a_signed_cage_of_before_that_is_put_back_is_told(bench_file: BenchFile, tmp_path: Path) -> None:
    """The older one of two that were approved here, and one from elsewhere that was measured before them."""
    bench, cage = with_the_file(bench_file(TWIN, REMOTE)), tmp_path / "cage.json"
    made = a_calibration(np.zeros((3, 3)), np.zeros(3))
    for day in ("21", "22"):
        write_cage(made.model_copy(update={"measured_utc": f"2026-11-{day}"}), cage)
        shutil.copy(cage, tmp_path / f"{day}.json")
        told = {"cage": read_config(bench).name, "measured_utc": f"2026-11-{day}"}
        note_file("approve", "R. Roe", cage, **told)
        assert "not the newest" not in str(session.cage_remark(bench))
    shutil.copy(tmp_path / "21.json", cage)
    old = "cage.json, measured 2026-11-21, is not the newest of this bench: R. Roe approved that of 2026-11-22 on "
    assert old in str(session.cage_remark(bench))
    for measured, newest in (("2026-11-20", False), ("2026-11-23", True)):
        write_cage(made.model_copy(update={"run_id": "D", "measured_utc": measured}), cage)
        assert ("not the newest" in str(session.cage_remark(bench))) is not newest


def test_a_cage_that_another_signed_or_whose_signer_is_revoked_or_lacks_the_role_drives_no_coil(
    bench_file: BenchFile, tmp_path: Path
) -> None:
    bench = with_the_file(bench_file(TWIN, REMOTE))
    a_signed_cage(tmp_path, "eve")
    with pytest.raises(InputError, match=r"approved_by: R\. Roe approved it, and eve signed it"):
        session.cage_remark(bench)
    cage = a_signed_cage(tmp_path)
    listed = tmp_path / "people"
    listed.write_text(session.handed_out()[0].line() + "\n", encoding="utf-8")
    session.trust_keys(listed, ["approve"])  # eve alone has a role
    with pytest.raises(InputError, match=r"r\.roe has not the role approve"):
        session.cage_remark(bench)
    cage.with_name("cage.json.sshsig").unlink()
    with pytest.raises(InputError, match="is not signed, and in this lab an approver with a role signs it"):
        session.cage_remark(bench)
    with pytest.raises(InputError, match=r"R\. Loe has not the role approve; nothing was written"):
        session.approve_cage("any", "R. Loe", tmp_path / "another.json")
    (home() / "keys" / "eve.pem").unlink()
    with pytest.raises(InputError, match=r"no key of eve is at hand here; nothing was written"):
        session.approve_cage("any", "eve", tmp_path / "another.json")
    a_signed_cage(tmp_path)
    session.revoke_keys("r.roe")
    with pytest.raises(InputError, match="its key is revoked"):
        session.cage_remark(bench)


def command(capsys: pytest.CaptureFixture[str], *words: str) -> str:
    """What a command says, which ends well."""
    with patch.dict(os.environ):
        assert execute(list(words)) == 0
    return " ".join(capsys.readouterr().out.split())
