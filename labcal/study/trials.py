"""What a job of a simulated study gives: a Monte-Carlo trial, a blind trial of the loop, an optimal design."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from labcal import loop
from labcal.fit import Fit, fit
from labcal.fit.vector.information import information
from labcal.model import AffineMap
from labcal.record import Run
from labcal.study.accuracy import direction_U_deg, errors, sensitivities
from labcal.study.job import Row
from labcal.study.optimal import LabTime, Mask, quickest_first
from labcal.study.simulated import SimulatedRun, record, truth
from labcal.twin.pick import pick_effect

TRIES = 20  # choices that a fit is asked about before the search gives up


def monte_carlo(settings: Mapping[str, Any]) -> Row:
    """One procedure, its fit, and the error of the map against the twin's own."""
    recorded = record(settings)
    found = fit(recorded.run, settings["method"], holdout=False)
    done: Row = {"lab_s": recorded.lab_s, "rows": len(recorded.run), "limits_missed": len(recorded.missed)}
    if not found.ok or found.affine is None:
        return {"why_not": str(found.why_not), **done}
    return {"why_not": "", **done, **_accuracy(found, truth(settings["bench"]), settings["field_nT"])}


def _accuracy(found: Fit, true: AffineMap, field_nT: float) -> Row:
    """Directions only where the fit resolves the rotation; U only where it states a covariance."""
    assert found.affine is not None
    turned, longer = errors(found.affine, true, field_nT)
    offset = float(np.linalg.norm(found.affine.k_nT - true.k_nT))
    known = found.frame_known
    U = _direction_U(found, field_nT) if known and found.covariance is not None else None
    return {
        "direction_error_deg": turned if known else None, "direction_U_deg": U, "magnitude_error_nT": longer,
        "k_error_nT": offset if known else None,
    }  # fmt: skip


def _direction_U(found: Fit, field_nT: float) -> float:
    assert found.affine is not None
    assert found.covariance is not None
    return float(direction_U_deg(sensitivities(found.affine, field_nT), found.covariance[None, :12, :12])[0])


def blind(settings: Mapping[str, Any]) -> Row:
    """The twin suffers what its seed picked; the loop knows nothing of it. What it named beside what it was."""
    recorded = record(settings)
    closed = loop.close_loop(recorded.run)
    hidden, hidden_on = next((name, given.get("channel", "")) for name, given in pick_effect(settings["seed"]).items())
    named = [(e.effect, *e.channels) for e in closed.accepted]
    right = [n for n in named if n[0] == hidden and (not hidden_on or hidden_on in n)]
    rivals = [rival for e in closed.accepted for rival in e.rivals if rival.effect == hidden]
    return {
        "lab_s": recorded.lab_s, "verdict": closed.verdict, "hidden": f"{hidden} {hidden_on}".strip(),
        "named": "; ".join(" ".join(n) for n in named), "found": _found(named, right, rivals),
        "holdout_before_nT": closed.before.holdout_rms_nT, "holdout_after_nT": closed.after.holdout_rms_nT,
        "noise_floor_nT": closed.noise_floor_nT,
    }  # fmt: skip


def _found(named: list[Any], right: list[Any], rivals: list[Any]) -> str:
    """In one word: right (it and nothing else), among others, rival (named as one), missed (nothing), wrong."""
    if right:
        return "right" if len(named) == 1 else "among others"
    return "rival" if rivals else "wrong" if named else "missed"


def design(settings: Mapping[str, Any]) -> Row:
    """The rotations that reach the accuracy in the least lab time, proved by a fit to them alone."""
    recorded = record(settings)
    try:
        known = information(recorded.run)
    except ValueError as error:
        return {"why_not": str(error)}
    time, wanted = lab_time(recorded, settings["mount_s"]), settings["accuracy_deg"]
    fields = settings["field_nT"]
    everything = np.ones(len(recorded.run.segments), dtype=np.bool_)
    done: Row = {"rotations_recorded": len(everything), "all_lab_s": float(time.of(everything[None])[0]),
                 "all_U_deg": _direction_U(fit(recorded.run, holdout=False), fields)}  # fmt: skip
    looked, tried = 0, 0
    for chosen, lab_s, U in quickest_first(known, time, fields):
        looked += 1
        if wanted < U:
            continue
        found, tried = fit(part(recorded.run, chosen), holdout=False), tried + 1
        if found.ok and found.covariance is not None and _direction_U(found, fields) <= wanted:
            return {"why_not": "", **done, "choices_looked_at": looked, **_chosen(recorded, chosen, lab_s, U),
                    **_accuracy(found, truth(settings["bench"]), fields)}  # fmt: skip
        if tried == TRIES:
            return {"why_not": f"{TRIES} choices promised it, and the fit kept none of the promises", **done}
    return {"why_not": f"no choice of these rotations reaches {wanted:g} deg", **done, "choices_looked_at": looked}


def _chosen(recorded: SimulatedRun, chosen: Mask, lab_s: float, U: float) -> Row:
    names = [s.id for s, taken in zip(recorded.run.segments, chosen, strict=True) if taken]
    return {"rotations": "; ".join(names), "number": len(names), "lab_s": lab_s, "predicted_U_deg": U}


def part(run: Run, chosen: Mask) -> Run:
    """The run of these segments (segments,) alone."""
    return run.select(chosen[run.segment_index])


def lab_time(recorded: SimulatedRun, mount_s: float) -> LabTime:
    """What each part of a preflight took in the lab; a mounting takes its person `mount_s` besides."""
    segments = recorded.run.segments
    lasted, mountings = dict(recorded.steps), list(dict.fromkeys(s.mounting for s in segments))
    turn = np.array([lasted[s.id] for s in segments])
    own = {f"{step}-{m}": i for i, m in enumerate(mountings) for step in ("mount", "closure")}
    mounting = np.full(len(mountings), mount_s)
    for step, i in own.items():
        mounting[i] += lasted.get(step, 0.0)
    once = sum(lasted.values()) - turn.sum() - (mounting - mount_s).sum()
    return LabTime(float(once), mounting, turn, np.array([mountings.index(s.mounting) for s in segments]))
