"""What the worker does with a run that is over: fits, the loop, and the arrays that their pictures are drawn from."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import fields
from functools import lru_cache
from importlib import import_module
from math import hypot
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from labcal.files.home import home, own_folder
from labcal.gui.ipc.answers import Array, Change, FitFigures, Fitted, Growth, Look, Loop, Proposal, ShellLeft
from labcal.gui.ipc.channel import Channel
from labcal.gui.ipc.handlers import handles
from labcal.gui.ipc.kept_answers import keep_fit, keep_loop, kept_fits, kept_loop
from labcal.gui.ipc.messages import (
    CloseLoop,
    FilterHistory,
    FitRun,
    JoinRuns,
    ListMethods,
    LookAt,
    Progress,
    TryCause,
    WriteDraft,
)
from labcal.record import Run
from labcal.record.run_id import as_file_name
from labcal.system.given_back import give_back_memory

if TYPE_CHECKING:
    from labcal.fit import Fit
    from labcal.loop import ClosedLoop, NextExperiment, Pictures

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
def loaded_run(run: str) -> Run:
    """The run called so, kept while it is looked at."""
    from labcal import session

    return session.load_run(run)


@lru_cache(maxsize=24)
def loaded_fit(run: str, method: str) -> Fit:
    """One method's answer, kept while it is looked at."""
    from labcal import session

    return session.fit_run(run, method)[1][0]


def methods(channel: Channel, asked: ListMethods) -> tuple[str, ...]:
    """The names of all estimators; whoever asks first waits for what everything else here needs."""
    from labcal.fit.registry import methods as installed

    import_module("labcal.session")
    return installed()


def look(channel: Channel, asked: LookAt) -> Look:
    """A run as it was recorded, thinned for pictures, and what was worked out of it before."""
    measured = loaded_run(asked.run)
    rows = thinned(len(measured))
    before, against = measured.reading_nT[rows], regressors(measured, rows)
    names, index = tuple(one.id for one in measured.segments), measured.segment_index[rows].astype(float)
    fits, found = kept_fits(measured, methods(channel, ListMethods())), kept_loop(measured)
    return Look(measured.run_id, measured.dut.serial, len(measured), before, against, names, index, fits, found)


def fit(channel: Channel, asked: FitRun) -> Fitted:
    """One method's answer, its residual and its loci; it is kept for a window that is started again."""
    answer = _fitted(asked)
    keep_fit(loaded_run(asked.run), asked.method, answer)
    return answer


def _fitted(asked: FitRun) -> Fitted:
    from labcal import session
    from labcal.fit.metrics import scalar_residual
    from labcal.session.conformity import fit_conformity

    measured, found = loaded_run(asked.run), loaded_fit(asked.run, asked.method)
    if found.affine is None:
        return Fitted(figures(found), found.noise_nT, stated_nT=stated_noise(measured))
    rows = thinned(len(measured))
    residual, after = scalar_residual(measured, found)[rows], found.affine.apply(measured.reading[rows])
    shells = _shells(measured, found)
    judged = fit_conformity(measured, found)
    lines = () if judged is None else judged.lines
    open_yet = session.left_open(measured, found)
    return Fitted(figures(found), found.noise_nT, residual, after, shells, stated_noise(measured), lines, open_yet)


def stated_noise(measured: Run) -> float | None:
    """Of a magnitude's residual [nT], by what the run states of DUT and reference; None where that is nothing."""
    dut, reference = measured.dut.noise_nT, measured.reference.noise_nT
    return None if dut is None or reference is None else hypot(dut, reference)


def _shells(measured: Run, found: Fit) -> tuple[ShellLeft, ...]:
    """What the map left of a sphere of fields at rest; nothing where the frame is not known, or no shell goes round."""
    from labcal.fit.harmonics import shells_of_standstills
    from labcal.fit.metrics import vector_residual

    left = vector_residual(measured, found) if found.frame_known else None
    shells = () if left is None else shells_of_standstills(measured, left)
    return tuple(
        ShellLeft(shell.magnitude_nT, tuple(shell.rms_nT.tolist()), tuple(shell.noise_nT.tolist())) for shell in shells
    )


def figures(found: Fit) -> FitFigures:
    """One method's answer, as the contract's FIT has it."""
    from labcal.fit.document import one

    said = one(found)
    return FitFigures(**{field.name: said[field.name] for field in fields(FitFigures)})


def draft(channel: Channel, asked: WriteDraft) -> str:
    """Write the draft calibration of a method; returns its path."""
    from labcal import session

    path = calibration_path(loaded_run(asked.run).run_id)
    session.draft(asked.run, loaded_fit(asked.run, asked.method), path, force=True)  # a draft of the window's own
    return str(path)


def loop(channel: Channel, asked: CloseLoop) -> Loop:
    """Close the loop; the draft with the effects is written, and the verdict beside it."""
    from labcal import session
    from labcal.files.atomic import write_text

    measured = loaded_run(asked.run)
    path = calibration_path(measured.run_id)
    try:
        closed = session.close_loop(asked.run, path, lambda text: channel.send(Progress(text)), force=True)
    finally:
        give_back_memory()  # this process stays as long as the window
    write_text(path.with_suffix(".loop"), json.dumps(closed.to_json()))
    answer = _loop_answer(closed, str(path), _change(measured, closed.pictures))
    keep_loop(measured, answer)
    return answer


def _loop_answer(closed: ClosedLoop, draft: str, change: Change) -> Loop:
    from labcal.model.effects import families, phrases

    next_one = closed.next_experiment
    return Loop(
        verdict=closed.verdict,
        summary=closed.summary,
        before_nT=closed.before.holdout_rms_nT,
        after_nT=closed.after.holdout_rms_nT,
        noise_floor_nT=closed.noise_floor_nT,
        noise_floor_source=closed.noise_floor_source,
        set_aside=closed.set_aside,
        accepted=closed.accepted,
        rejected=closed.rejected,
        next_experiment=None if next_one is None else proposal(next_one),
        remarks=closed.remarks,
        draft=draft,
        change=change,
        drawn_against={family.id: family.drawn_against for family in families()},
        phrases=phrases(),
    )


def proposal(one: NextExperiment) -> Proposal:
    """What the loop would measure next, as the window shows it and begins it."""
    return Proposal(one.why, one.do, one.procedure, one.settings)


def together(channel: Channel, asked: JoinRuns) -> str:
    """Keep the run of all rows of both; returns its id."""
    from labcal.session import measuring

    return measuring.together(asked.run, asked.new)


def cause(channel: Channel, asked: TryCause) -> Change:
    """The residual before and after one cause alone, named by the loop or not."""
    from labcal import session

    return _change(loaded_run(asked.run), session.one_cause(asked.run, asked.effect, asked.channels).pictures)


def growth(channel: Channel, asked: FilterHistory) -> Growth:
    """How a filter's estimate grew with the readings."""
    from labcal import session

    found = session.filter_history(asked.run, asked.method)
    return Growth(found.t_s, found.bias_nT, found.u_nT)


def _change(run: Run, pictures: Pictures) -> Change:
    rows = thinned(len(pictures.t_s))
    at = np.clip(np.searchsorted(run.t_s, pictures.t_s[rows]), 0, len(run) - 1)
    return Change(pictures.before_nT[rows], pictures.after_nT[rows], regressors(run, at))


def thinned(n: int) -> NDArray[np.intp]:
    """Row numbers of at most `MAX_POINTS` rows, evenly taken."""
    return np.arange(0, n, max(1, -(-n // MAX_POINTS)), dtype=np.intp)


def regressors(run: Run, rows: NDArray[np.intp]) -> Mapping[str, Array]:
    """Everything a residual may be drawn against, by name with unit."""
    against = {"time  s": run.t_s[rows]}
    if run.angle_deg is not None:
        against["angle  deg"] = run.angle_deg[rows]
    if run.reference.kind != "none":
        against["field  nT"] = run.magnitude_nT[rows]
    return against | {f"{c.name}  {c.unit}": c.values[rows] for c in run.channels}


HANDLERS = (
    handles(ListMethods, methods),
    handles(LookAt, look),
    handles(FitRun, fit),
    handles(WriteDraft, draft),
    handles(CloseLoop, loop),
    handles(TryCause, cause),
    handles(JoinRuns, together),
    handles(FilterHistory, growth),
)
