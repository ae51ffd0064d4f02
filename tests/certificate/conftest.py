"""A calibration with something in every field."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

from labcal.certificate import Signer, pkcs8
from labcal.certificate.allowed_signers import own_line
from labcal.certificate.calibration_file import calibration_bytes
from labcal.certificate.sshsig import public_key_blob
from labcal.model import AffineMap, Calibration, EffectRecord, Parameter, Validity
from labcal.model.records import Rival
from labcal.record import Dut


@pytest.fixture
def calibration() -> Calibration:
    current = EffectRecord(
        effect="offset-current",
        channels=("i_eps",),
        reference_value={"i_eps": 0.25},
        belongs_to="sensor",
        parameters=tuple(
            Parameter(f"c_{axis}", v, 0.4, "nT/A") for axis, v in zip("xyz", (112.5, -40.25, 3.0), strict=True)
        ),
        holdout_rms_before_nT=88.5,
        holdout_rms_after_nT=43.75,
        improvement_ci95_nT=(38.0, 51.5),
        p_value=1e-9,
        rivals=(Rival("offset-temperature", ("temp_dut",), 71.0),),
        why="The offset follows the current of the power supply.",
    )
    tilt = EffectRecord(
        effect="axis-tilt",
        channels=(),
        reference_value={},
        belongs_to="rig",
        parameters=(Parameter("cage_x", 0.35, 0.02, "deg"),),
        provisional=True,
        why="The platform axis leans towards cage x.",
    )
    return Calibration(
        run_id="r-2026-11-21-01",
        simulated=True,
        dut=Dut("FM-07", "flight model", "count", 0.5),
        affine=AffineMap(np.array([[0.5, 0.001, 0.0], [0.0, 0.51, 0.0], [0.0, 0.002, 0.49]]), np.array([120.0, -8, 3])),
        covariance=np.diag([1e-10] * 9 + [4.0] * 3),
        frame_known=True,
        validity=Validity((20_000.0, 60_000.0), (18.5, 24.0), ("nominal", "safe"), "2027-11-21"),
        span_s=(0.0, 2700.0),
        run_sha256="ab" * 32,
        effects=(current,),
        findings=(tilt,),
        metrics={"before": {"train_rms_nT": 88.0, "holdout_rms_nT": 88.5}, "after": {"holdout_rms_nT": 43.75}},
        instruments=({"role": "reference", "model": "HMR2300", "serial": "H-1"},),
        software="labcal 0.1.0",
        operator="Grace Häberli",
    )


@pytest.fixture
def draft(calibration: Calibration, tmp_path: Path) -> Path:
    path = tmp_path / "cal.json"
    path.write_bytes(calibration_bytes(calibration))
    return path


@pytest.fixture
def real_draft(calibration: Calibration, tmp_path: Path) -> Path:
    path = tmp_path / "real.json"
    path.write_bytes(calibration_bytes(replace(calibration, simulated=False)))
    return path


@pytest.fixture(autouse=True)
def quick_passphrases(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pkcs8, "ROUNDS", 1000)


@pytest.fixture
def key() -> Ed25519PrivateKey:
    """RFC 8032, section 7.1, test 1."""
    return Ed25519PrivateKey.from_private_bytes(
        bytes.fromhex("9d61b19deffd5a60ba844af492ec2cc44449c5697b326919703bac031cae7f60")
    )


@pytest.fixture
def other_key() -> Ed25519PrivateKey:
    """RFC 8032, section 7.1, test 2."""
    return Ed25519PrivateKey.from_private_bytes(
        bytes.fromhex("4ccd089b28ff96da9db6c346ec114e0f5b8a319f35aba624da8cf6ed4fb8a6fb")
    )


@pytest.fixture
def lab(key: Ed25519PrivateKey, other_key: Ed25519PrivateKey) -> tuple[Signer, ...]:
    """A trust list of Ada (`key`) and Bob (`other_key`)."""
    pairs = (("ada", key), ("bob", other_key))
    return tuple(own_line(name, public_key_blob(k.public_key())) for name, k in pairs)
