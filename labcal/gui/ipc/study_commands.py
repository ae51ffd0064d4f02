"""What the worker does with a run that is over: fits, the loop, and the arrays that their pictures are drawn from."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import asdict
from functools import lru_cache
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from labcal.gui.ipc.channel import Channel
from labcal.gui.ipc.wire import pack
from labcal.home import home, own_folder
from labcal.record import Run
from labcal.record.run_id import as_file_name

if TYPE_CHECKING:
    from labcal.fit import Fit
    from labcal.loop import Pictures

MAX_POINTS = 1500  # rows in a picture


def calibration_path(run_id: str) -> Path:
    """Where the draft of a run lies: beside the earlier one where that is signed."""
    folder = own_folder(own_folder(home()) / "calibrations")
    name, number = as_file_name(run_id), 1
    while True:
        path = folder / (f"{name}.json" if number == 1 else f"{name}.{number}.json")
        if not path.with_name(path.name + ".sshsig").exists():
            return path
        number += 1


@lru_cache(maxsize=2)
def _run(run: str) -> Run:
    from labcal import session

    return session.load_run(run)


@lru_cache(maxsize=24)
def _fit(run: str, method: str) -> Fit:
    from labcal import session

    return session.fit_run(run, method)[1][0]


def methods(channel: Channel) -> list[str]:
    """The names of all estimators; whoever asks first waits for what everything else here needs."""
    from labcal import fit

    import_module("labcal.session")
    return list(fit.methods())


def look(channel: Channel, run: str) -> dict[str, Any]:
    """A run as it was recorded, thinned for pictures."""
    measured = _run(run)
    rows = thinned(len(measured))
    head = {"run_id": measured.run_id, "dut": measured.dut.serial, "n_samples": len(measured)}
    return head | _regressors(measured, rows) | {"before": pack(measured.reading_nT[rows])}


def fit(channel: Channel, run: str, method: str) -> dict[str, Any]:
    """One method's answer, its residual and its loci."""
    from labcal.fit.document import one
    from labcal.fit.metrics import scalar_residual

    measured, found = _run(run), _fit(run, method)
    rows = thinned(len(measured))
    said: dict[str, Any] = {"fit": one(found), "noise_nT": found.noise_nT}
    if found.affine is not None:
        said |= {
            "residual": pack(scalar_residual(measured, found)[rows]),
            "after": pack(found.affine.apply(measured.reading[rows])),
        }
    return said


def draft(channel: Channel, run: str, method: str) -> str:
    """Write the draft calibration of a method; returns its path."""
    from labcal import session

    path = calibration_path(_run(run).run_id)
    session.draft(run, _fit(run, method), path, force=True)  # a draft of the window's own
    return str(path)


def loop(channel: Channel, run: str) -> dict[str, Any]:
    """Close the loop; the draft with the effects is written, and the verdict beside it."""
    from labcal import session
    from labcal.files import write_text
    from labcal.model.effects import families

    measured = _run(run)
    path = calibration_path(measured.run_id)
    closed = session.close_loop(run, path, lambda text: channel.send("progress", text=text), force=True)
    document = closed.to_json()
    write_text(path.with_suffix(".loop"), json.dumps(document))
    said = {"loop": document, "remarks": list(closed.remarks), "draft": str(path)}
    said |= {"drawn_against": {family.id: family.drawn_against for family in families()}}
    return said | _before_and_after(measured, closed.pictures)


def together(channel: Channel, run: str, new: str) -> str:
    """Keep the run of all rows of both; returns its id."""
    from labcal import measuring

    return measuring.together(run, new)


def cause(channel: Channel, run: str, effect: str, channels: list[str]) -> dict[str, Any]:
    """The residual before and after one cause alone, named by the loop or not."""
    from labcal import session

    found, measured = session.one_cause(run, effect, tuple(channels)), _run(run)
    return {"parameters": [asdict(p) for p in found.parameters]} | _before_and_after(measured, found.pictures)


def growth(channel: Channel, run: str, method: str) -> dict[str, Any]:
    """How a filter's estimate grew with the readings."""
    from labcal import session

    found = session.filter_history(run, method)
    return {"t_s": pack(found.t_s), "bias_nT": pack(found.bias_nT), "u_nT": pack(found.u_nT)}


def _before_and_after(run: Run, pictures: Pictures) -> dict[str, Any]:
    rows = thinned(len(pictures.t_s))
    at = np.clip(np.searchsorted(run.t_s, pictures.t_s[rows]), 0, len(run) - 1)
    both = {"before": pack(pictures.before_nT[rows]), "after": pack(pictures.after_nT[rows])}
    return both | _regressors(run, at)


def thinned(n: int) -> NDArray[np.intp]:
    """Row numbers of at most `MOST` rows, evenly taken."""
    return np.arange(0, n, max(1, -(-n // MAX_POINTS)), dtype=np.intp)


def _regressors(run: Run, rows: NDArray[np.intp]) -> dict[str, Any]:
    """Everything a residual may be drawn against, by name with unit."""
    against = {"time  s": run.t_s[rows]}
    if run.angle_deg is not None:
        against["angle  deg"] = run.angle_deg[rows]
    if run.reference.kind != "none":
        against["field  nT"] = run.magnitude_nT[rows]
    against |= {f"{c.name}  {c.unit}": c.values[rows] for c in run.channels}
    return {"against": {name: pack(values) for name, values in against.items()}}


COMMANDS: dict[str, Callable[..., Any]] = {
    "methods": methods,
    "look": look,
    "fit": fit,
    "draft": draft,
    "loop": loop,
    "cause": cause,
    "together": together,
    "growth": growth,
}
