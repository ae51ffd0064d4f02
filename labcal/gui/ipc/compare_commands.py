"""What the worker does with two runs of one sensor: each by its own calibration, side by side, and what changed."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from labcal.files.home import home
from labcal.gui.ipc.answers import Compared, Comparison
from labcal.gui.ipc.channel import Channel
from labcal.gui.ipc.handlers import handles
from labcal.gui.ipc.messages import CompareRuns
from labcal.gui.ipc.study_commands import loaded_fit, loaded_run, regressors, stated_noise, thinned
from labcal.record import Run
from labcal.record.run_id import as_file_name
from labcal.uncertainty.conformity import Change, Changes, changes

if TYPE_CHECKING:
    from labcal.model import Calibration

METHOD = "ml"  # of a run that has no calibration yet


def compare(channel: Channel, asked: CompareRuns) -> Comparison:
    """Both runs, each as its newest calibration has it, and what changed from the older to the newer."""
    (older, before), (newer, after) = (side_of(run) for run in (asked.older, asked.newer))
    try:
        found, refused = _changes(after, before), ""
    except ValueError as error:
        found, refused = None, f"The calibration of {asked.older} {error}: their parameters cannot be compared."
    return Comparison(older, newer, found, refused)


def newest_file(run_id: str) -> Path | None:
    """The newest calibration file of a run in the lab's folder; None where there is none."""
    from labcal import session

    stem = as_file_name(run_id)
    paths = (path for path in (home() / "calibrations").glob("*.json") if path.name.startswith(f"{stem}."))
    mine = [path for path in paths if session.load_calibration(path).run_id == run_id]
    return max(mine, key=lambda path: (len(path.name), path.name), default=None)


def side_of(run_id: str) -> tuple[Compared, Calibration]:
    """A run by its own calibration, or by one that is made of it."""
    from labcal import session

    run, file = loaded_run(run_id), newest_file(run_id)
    found = _fitted_now(run_id) if file is None else session.load_calibration(file)
    field_nT = _field(found, run)
    rows = thinned(len(run))
    left = np.linalg.norm(field_nT, axis=1) - run.magnitude_nT if run.reference.kind != "none" else None
    own_nT, stated_nT = found.metrics.get("after", {}).get("noise_nT"), stated_noise(run)
    noise_nT = own_nT if stated_nT is None else stated_nT  # as Fit judges it
    compared = Compared(
        run_id=run_id,
        dut=run.dut.serial,
        calibration="" if file is None else file.name,
        noise_nT=None if noise_nT is None else float(noise_nT),
        residual=None if left is None else left[rows],
        after=field_nT[rows],
        against=regressors(replace(run, t_s=run.t_s - run.t_s[0]), rows),
        noise_stated=stated_nT is not None,
    )
    return compared, found


def _fitted_now(run_id: str) -> Calibration:
    """What the recommended method makes of a run that nobody calibrated; written nowhere."""
    from labcal.fit import draft_calibration

    return draft_calibration(loaded_run(run_id), loaded_fit(run_id, METHOD), "")


def _field(calibration: Calibration, run: Run) -> NDArray[np.float64]:
    from labcal.model.apply import apply
    from labcal.model.readings import readings_of

    return apply(calibration, readings_of(run)).field_nT


def _changes(new: Calibration, old: Calibration) -> Changes:
    """Of the map, and of the parameters of every effect that both have. Raises ValueError, as `changes` does."""
    found = changes(new, old)
    before = {(e.effect, e.channels, p.name, p.unit): p for e in old.effects for p in e.parameters}
    rows = list(found.rows)
    for effect in new.effects:
        for p in effect.parameters:
            if (was := before.get((effect.effect, effect.channels, p.name, p.unit))) is not None:
                name = " ".join((effect.effect, *effect.channels, p.name))
                rows.append(_change(name, was.value, p.value, 2 * float(np.hypot(was.u, p.u)), p.unit))
    return replace(found, rows=tuple(rows), remarks=(*found.remarks, *_alone(new, old)))


def _change(name: str, found: float, left: float, U: float, unit: str) -> Change:
    return Change(name, found, left, U or None, unit, (left - found) / U if U else None)


def _alone(new: Calibration, old: Calibration) -> list[str]:
    """What only one of the two corrects."""
    named = [{" ".join((e.effect, *e.channels)) for e in one.effects} for one in (old, new)]
    pairs = (("earlier", named[0] - named[1]), ("later", named[1] - named[0]))
    return [f"Only the {which} corrects {', '.join(sorted(names))}." for which, names in pairs if names]


HANDLERS = (handles(CompareRuns, compare),)
