"""One bit of what a lab hands out, flipped: caught wherever it is, or it changes no content and stands in a list here.

The calibration and its signature are those of `examples/short-preflight`; the run was recorded with its chain.
"""

from __future__ import annotations

import random
import shutil
from base64 import b64decode, b64encode
from collections import Counter
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

from labcal.bench.coils.cage_file import CageCalibration, Place, cage_text
from labcal.certificate import Signer, read_allowed_signers, signing, verify
from labcal.certificate.allowed_signers import own_line
from labcal.certificate.cage_signature import check_cage
from labcal.certificate.sshsig import public_key_blob, sign
from labcal.errors import InputError
from labcal.record import Dut, Reference, RunHeader, Segment
from labcal.record.stream import Block, Event, Measurement, SegmentClosed, SegmentOpened
from labcal.store import Bundle, Store, load_bundle, save_bundle

EXAMPLE = Path(__file__).parents[2] / "examples" / "short-preflight"
NOW = datetime(2026, 11, 21, 12, 0, tzinfo=UTC)
MANY = pytest.mark.slow
BEGIN, END = b"-----BEGIN SSH SIGNATURE-----\n", b"\n-----END SSH SIGNATURE-----\n"


def flipped(content: bytes, bit: int) -> bytes:
    place = bit // 8
    return content[:place] + bytes([content[place] ^ 1 << bit % 8]) + content[place + 1 :]


def every(content: bytes, step: int) -> Iterator[tuple[int, bytes]]:
    """Each bit of that step's flipped, with its number."""
    return ((bit, flipped(content, bit)) for bit in range(0, 8 * len(content), step))


@pytest.fixture
def example(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The calibration, its signature and the list of who made it; 3 names beside it are looked for, and not 99."""
    monkeypatch.setattr(signing, "MOST_SIGNATURES", 3)  # a third of the time
    for name in ("calibration.json", "calibration.json.sshsig", "allowed_signers"):
        shutil.copy(EXAMPLE / name, tmp_path / name)
    return tmp_path / "calibration.json"


def is_valid(calibration: Path, lab: tuple[Signer, ...]) -> bool:
    """By its signatures; a file that is refused is not."""
    try:
        return verify(calibration, lab, frozenset(), NOW).valid
    except InputError:
        return False


@pytest.mark.parametrize("step", [293, pytest.param(1, marks=MANY)])
def test_no_bit_of_a_calibration_can_be_another(example: Path, step: int) -> None:
    lab, content = read_allowed_signers(example.with_name("allowed_signers")), example.read_bytes()
    assert is_valid(example, lab)
    for bit, forged in every(content, step):
        example.write_bytes(forged)
        assert not is_valid(example, lab), f"bit {bit % 8} of byte {bit // 8}"


@pytest.mark.parametrize("step", [11, pytest.param(1, marks=MANY)])
def test_no_bit_of_a_decoded_signature_can_be_another(example: Path, step: int) -> None:
    lab, file = read_allowed_signers(example.with_name("allowed_signers")), example.with_name("calibration.json.sshsig")
    decoded = b64decode(file.read_bytes()[len(BEGIN) : -len(END)])
    file.write_bytes(BEGIN + b64encode(decoded) + END)
    assert is_valid(example, lab)
    for bit, forged in every(decoded, step):
        file.write_bytes(BEGIN + b64encode(forged) + END)
        assert not is_valid(example, lab), f"bit {bit % 8} of byte {bit // 8}"


@pytest.mark.parametrize("step", [7, pytest.param(1, marks=MANY)])
def test_what_passes_in_the_armour_decodes_to_the_same_signature(example: Path, step: int) -> None:
    """Line ends may be other blanks, and the last letter of base64 has bits that say nothing: no content is there."""
    lab, file = read_allowed_signers(example.with_name("allowed_signers")), example.with_name("calibration.json.sshsig")
    content, passed = file.read_bytes(), Counter[str]()
    decoded = b64decode(content[len(BEGIN) : -len(END)])
    for bit, forged in every(content, step):
        file.write_bytes(forged)
        if is_valid(example, lab):
            text = forged.strip()[len(BEGIN) - 1 : 1 - len(END)]
            assert b64decode(b"".join(text.split())) == decoded
            passed["a line end" if content[bit // 8] == 10 else "base64's last letter"] += 1
    print(f"armour: {len(range(0, 8 * len(content), step))} bits, no content: {dict(passed)}")
    assert set(passed) <= {"a line end", "base64's last letter"}
    assert sum(passed.values()) < 25


@pytest.fixture
def recorded(tmp_path: Path) -> Path:
    """A bundle with its chain, as a folder, and as a zip beside it."""
    header = RunHeader("r1", "2026-03-02T08:15:00Z", True, "bench", Dut("SN1"), Reference("none"))
    with Store.open() as store:
        with store.begin(header) as writer:
            writer.write(SegmentOpened(0.0, Segment("a", "free")))
            for number in range(12):
                t = 10.0 * number + np.arange(30) / 10
                columns = ("dut_x", "dut_y", "dut_z")
                writer.write(Block("dut", "dut", columns, t, np.outer(np.sin(t), [1e4, 2e4, -3e4]), b"frame\n" * 30))
                writer.write(Measurement(t[-1], "zero", 3.5, 0.5, "nT", 10.0))
                writer.write(Event(t[-1], "note", "a"))
            writer.write(SegmentClosed(120.0))
        bundle = store.bundle("r1", with_chain=True)
    save_bundle(bundle, tmp_path / "run.zip")
    save_bundle(bundle, tmp_path / "run")
    return tmp_path / "run"


def outcome(path: Path, before: Bundle) -> str:
    """What `verify --run` makes of a bundle: caught, or the same run; it compares the hashes and the head."""
    try:
        found = load_bundle(path)
        if (found.sha256, found.stated_chain) != (before.sha256, before.stated_chain):
            return "caught"
    except InputError:
        return "caught"
    assert (found.run_json, found.samples_csv) == (before.run_json, before.samples_csv)
    return "no content"


@pytest.mark.parametrize("flips", [120, pytest.param(10_000, marks=MANY)])
def test_a_bit_of_a_run_is_caught_or_changes_no_content(recorded: Path, flips: int) -> None:
    """What passes lies in a zip's dates and attributes, or writes a row of the chain in other letters."""
    before, chance, passed = load_bundle(recorded), random.Random(17), Counter[str]()
    assert before.stated_chain is not None
    files = [recorded.with_name("run.zip"), *sorted(recorded.iterdir())]
    contents = {file: file.read_bytes() for file in files}
    for _ in range(flips):
        file = chance.choice(files)
        bit = chance.randrange(8 * len(contents[file]))
        file.write_bytes(flipped(contents[file], bit))
        if outcome(file if file.suffix == ".zip" else recorded, before) == "no content":
            passed[file.name] += 1
        file.write_bytes(contents[file])
    print(f"run: {flips} bits, no content: {dict(passed)}")
    assert set(passed) <= {"run.zip", "chain.jsonl"}
    assert passed["chain.jsonl"] < 0.02 * flips
    assert passed["run.zip"] < 0.1 * flips


@pytest.mark.parametrize("flips", [400, pytest.param(10_000, marks=MANY)])
def test_no_bit_of_a_signed_cage_file_can_be_another(key: Ed25519PrivateKey, tmp_path: Path, flips: int) -> None:
    chance, cage = random.Random(17), tmp_path / "cage.json"
    numbers = np.random.default_rng(17).normal(size=(3, 12))
    place = Place(matrix_nT_per_A=numbers[:, :3].tolist(), offset_nT=numbers[0, :3].tolist(),
                  covariance=np.diag(numbers[1] ** 2).tolist())  # fmt: skip
    made = CageCalibration(run_id="C", simulated=True, measured_utc="2026-11-21T07:00:00Z", operator="J. Doe",
                           approved_by="Ada", dut=place)  # fmt: skip
    content, signers = cage_text(made).encode(), (own_line("ada", public_key_blob(key.public_key())),)
    cage.write_bytes(content)
    cage.with_name("cage.json.sshsig").write_text(sign(content, key))
    assert check_cage(cage, "Ada", signers, frozenset(), NOW) is None
    for _ in range(flips):
        bit = chance.randrange(8 * len(content))
        cage.write_bytes(flipped(content, bit))
        with pytest.raises(InputError, match="no coil is driven by it"):
            check_cage(cage, "Ada", signers, frozenset(), NOW)
