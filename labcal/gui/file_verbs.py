"""What the worker does with the store, calibrations, keys and reports: each a short word to labcal.session."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import asdict
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np

from labcal.gui.talk import Talk
from labcal.home import home

WORST = ("", "PASS", "CANNOT DECIDE", "MARGINAL", "FAIL")
LOOKED_BACK = 8  # runs, for the last closing check


def runs(talk: Talk) -> list[dict[str, Any]]:
    """The runs of the store, the newest first, each with the verdict of its loop where there is one."""
    from labcal import session

    told = [asdict(summary) for summary in reversed(session.runs())]
    verdicts = {path.name.split(".")[0]: json.loads(path.read_text())["verdict"] for path in _folder().glob("*.loop")}
    return [one | {"verdict": verdicts.get(one["run_id"], "")} for one in told]


def describe(talk: Talk, run: str) -> dict[str, Any]:
    """What a run is, in one look."""
    from labcal import session

    return session.describe_run(run)


def closing(talk: Talk) -> dict[str, Any] | None:
    """The last closing check there is: when, of which run, and its worst measurement."""
    from labcal import session
    from labcal.record.stream import Measurement
    from labcal.store import Store

    finished = (one for one in reversed(session.runs()) if one.status == "finished")
    with Store.open() as store:
        for one in islice(finished, LOOKED_BACK):
            items = store.items(one.run_id, but="block")
            closures = (i for i in items if isinstance(i, Measurement) and "closure" in i.name)
            if worst := max(closures, key=lambda m: abs(m.value), default=None):
                return {"run": asdict(one), "measurement": asdict(worst), "verdict": worst.verdict}
    return None


def cage_check(talk: Talk) -> dict[str, Any] | None:
    """The last finished cage-calibration there is, and its worst measurement that has a limit."""
    from labcal import session
    from labcal.record.stream import Measurement
    from labcal.store import Store

    last = next(
        (r for r in reversed(session.runs()) if (r.procedure, r.status) == ("cage-calibration", "finished")), None
    )
    if last is None:
        return None
    with Store.open() as store:
        judged = [i for i in store.items(last.run_id, but="block") if isinstance(i, Measurement) and i.limit]
    worst = max(judged, key=lambda m: abs(m.value) / (m.limit or 1.0), default=None)
    verdict = max((m.verdict for m in judged), key=WORST.index, default="")
    return {"run": asdict(last), "measurement": asdict(worst) if worst else None, "verdict": verdict}


def calibrations(talk: Talk) -> list[dict[str, Any]]:
    """Every calibration file of this lab's folder, the newest first."""
    paths = sorted(_folder().glob("*.json"), key=lambda path: path.name, reverse=True)
    return [calibration(talk, str(path)) for path in paths]


def calibration(talk: Talk, path: str) -> dict[str, Any]:
    """What a calibration file says, and how its signatures stand."""
    from labcal import session

    found, verification = session.load_calibration(Path(path)), session.verify(Path(path))
    covariance = found.covariance
    u = None if covariance is None else np.sqrt(np.diag(covariance)).tolist()
    effects = [asdict(effect) for effect in found.effects]
    return {
        "path": path, "run_id": found.run_id, "simulated": found.simulated, "dut": asdict(found.dut),
        "K": found.affine.K.tolist(), "k_nT": found.affine.k_nT.tolist(), "u": u, "frame_known": found.frame_known,
        "effects": effects, "findings": [asdict(f) for f in found.findings], "operator": found.operator,
        "approvers": list(found.approvers), "metrics": {k: dict(v) for k, v in found.metrics.items()},
        "validity": asdict(found.validity), "software": found.software,
    } | _standing(verification)  # fmt: skip


def verify(talk: Talk, path: str) -> dict[str, Any]:
    """Check a file that somebody dropped."""
    from labcal import session

    return {"path": path} | _standing(session.verify(Path(path)))


def _standing(verification: Any) -> dict[str, Any]:
    return {
        "valid": verification.valid,
        "signers": list(verification.signers),
        "signatures": [[c.file.name, c.principal, c.objection] for c in verification.checks],
        "provisional": verification.provisional,
        "sentences": verification.sentences(),
    }


def keys(talk: Talk) -> list[str]:
    """Names with a private key here."""
    from labcal import session

    return sorted({e.signer.principal for e in session.trusted_keys() if e.private_key_here and not e.revoked})


def new_key(talk: Talk, name: str, passphrase: str) -> str:
    """Make a key for `name`."""
    from labcal import session

    _may_sign(name)
    session.new_key(name, passphrase)
    return name


def _may_sign(name: str) -> None:
    from labcal.certificate.allowed_signers import check_principal
    from labcal.errors import InputError

    try:
        check_principal(name)
    except ValueError:
        raise InputError(
            f"No key can bear the name {name!r}: use letters, digits and . _ @ + - without blanks, as in ada.smith"
        ) from None


def approve(talk: Talk, path: str, name: str) -> dict[str, Any]:
    """Write the approver into the draft. Raises InputError where no key can bear that name: they could never sign."""
    from labcal import session

    _may_sign(name)
    session.approve(Path(path), name)
    return calibration(talk, path)


def sign(talk: Talk, path: str, name: str, passphrase: str) -> dict[str, Any]:
    """Sign as `name`; the passphrase is used and forgotten."""
    from labcal import session

    session.sign(Path(path), name, passphrase)
    return calibration(talk, path)


def report(talk: Talk, source: str, out: str) -> str:
    """Write the report of a run or a calibration."""
    from labcal import session

    session.report(source, Path(out), force=True)  # the dialogue has asked
    return out


def export(talk: Talk, run: str, format: str, out: str) -> str:
    """Write a run as bundle, csv, hdf5 or mat."""
    from labcal import session

    session.export_run(run, format, Path(out), force=True)  # type: ignore[arg-type]  # checked by the window's list
    return out


def import_bundle(talk: Talk, path: str) -> str:
    """Take a bundle into the store."""
    from labcal import session

    return session.import_bundle(Path(path))


def photo(talk: Talk, path: str) -> dict[str, str]:
    """Keep a photograph; what a note says of it."""
    from labcal import session

    return session.keep_photo(Path(path))


def correct_serial(talk: Talk, run: str, serial: str, who: str) -> str:
    """State another serial of a run's DUT, until a calibration of it is signed."""
    from labcal import session

    session.correct_serial(run, serial, who, sorted(_folder().glob(f"{run}*.json")))
    return serial


def apply(talk: Talk, path: str, source: str, out: str, dut: str) -> str:
    """Correct readings by a calibration; says how many rows, and how many of them carry a flag."""
    from labcal import session

    applied = session.apply_calibration(Path(path), Path(source), Path(out), dut or None, force=True)
    return f"{applied.rows} rows, {applied.rows - applied.flags['']} with a flag: {out}"


def hand_out(talk: Talk, path: str, folder: str) -> str:
    """Copy a calibration, its signatures and the keys they are checked against to `folder`."""
    from labcal import session

    session.hand_out(Path(path), Path(folder))
    return folder


def simulated_bench(talk: Talk) -> str:
    """The bench file of the simulated lab."""
    from labcal.demo import simulated_bench as found

    return str(found())


def _folder() -> Path:
    return home() / "calibrations"


VERBS: dict[str, Callable[..., Any]] = {
    one.__name__: one
    for one in (
        runs, describe, closing, cage_check, calibrations, calibration, verify, keys, new_key, approve, sign, report,
        export, photo, correct_serial, apply, hand_out, simulated_bench,
    )
} | {"import": import_bundle}  # fmt: skip
