"""Working a calibration out again from its run; what was worked out is kept, by what it was worked out from."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import asdict, replace
from functools import cache
from importlib.metadata import entry_points
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from labcal import certificate, loop
from labcal.certificate.between_versions import final_fit, with_held_out
from labcal.certificate.recomputed import Recomputed, of_its_run, whole_way
from labcal.errors import InputError
from labcal.files.atomic import write_bytes
from labcal.files.home import FILE, home, own_folder
from labcal.fit import Fit, draft_calibration, fit
from labcal.fit.registry import methods
from labcal.loop import policy
from labcal.model import Calibration, EffectRecord
from labcal.model.effects import find
from labcal.record import Run
from labcal.session.of_its_record import of_its_record
from labcal.store import Bundle, Store
from labcal.version import __version__, sources

if TYPE_CHECKING:
    from labcal.loop.refit import Refit

FOLDER = "worked-out"
FIT, CLOSE_LOOP = "fit", "close-loop"  # commands that make a calibration
NOT_YET = "it was not worked out again here yet; `labcal verify` does"
Progress = Callable[[str], None]
MadeBy = Mapping[str, Any]


def made_by(command: str, method: str, channels: Sequence[str] | None = None, *, empirical: bool = False) -> MadeBy:
    """How this version makes a calibration (contract: made_by)."""
    named = None if channels is None else tuple(channels)
    return {"command": command, "method": method, "channels": named, "empirical": empirical, "version": version()}


def version() -> str:
    """The version of labcal, judgements that are not its own, and packages here that bring effects or methods."""
    own = [f"{name} {value}" for name, value in policy.moved().items()]
    return " ".join([__version__, *own, *_packages()])


@cache  # as what they bring is loaded once; to look takes 17 ms, and each run of a chart and job of a study asks
def _packages() -> tuple[str, ...]:
    there = (entry.dist for group in ("labcal.effects", "labcal.estimators") for entry in entry_points(group=group))
    return tuple(sorted({f"{d.name} {d.version}" for d in there if d and d.name != "labcal"}))


def this_labcal() -> str:
    """`version`, and what tells two labcals apart that say the same one: what is kept here is called by it."""
    return f"{version()} {sources()}"


def keep(made: Calibration) -> None:
    """Keep what was worked out from a run. Where labcal's folder takes nothing it is worked out again."""
    _keep(made, _whole_place(made))


def _keep(made: Calibration, place: Path) -> None:
    with suppress(OSError):
        own_folder(own_folder(home()) / FOLDER)
        write_bytes(place, certificate.calibration_bytes(made), FILE)


def keep_corrected(draft: Calibration, corrected: Calibration) -> None:
    """What is kept of `draft` goes on as that of `corrected`, whose run states another serial and is else the same."""
    if (made := _kept(_whole_place(draft))) is not None:
        dut, of_run = replace(made.dut, serial=corrected.dut.serial), corrected.run_sha256
        keep(replace(made, dut=dut, run_sha256=of_run, chain=corrected.chain))


def recomputed(
    stated: Calibration,
    bundle: Bundle | None = None,
    progress: Progress = lambda text: None,
    *,
    only_kept: bool = False,
    closely: bool = False,
) -> Recomputed:
    """`stated` beside what its run gives, that of `bundle` or else of the local store; from what is kept if it can be.

    The whole way by the version that made it, else the final fit with its effects, `closely` or within a tenth of U.
    `only_kept` works nothing out.
    Before that nothing in the run's record may speak against it, its hash chain and the audit log among it.
    """
    of_record = of_its_record(stated, bundle)
    if of_record.against:
        return Recomputed(False, of_record.against, holds=False)
    if of_record.fault:
        return Recomputed(False, (of_record.fault,))
    if of_record.gone:
        return Recomputed(None, (of_record.gone,))
    found = _worked_out(stated, bundle, progress, only_kept=only_kept, closely=closely)
    return Recomputed(None, of_record.unshown) if found.same and of_record.unshown else found


def _worked_out(
    stated: Calibration, bundle: Bundle | None, progress: Progress, *, only_kept: bool, closely: bool
) -> Recomputed:
    if (made := _kept(_whole_place(stated))) is not None:
        return whole_way(stated, made)
    if (made := _kept(_final_place(stated))) is not None:
        return final_fit(stated, made, closely=closely)
    if only_kept:
        return Recomputed(None, (NOT_YET,))
    if bundle is None:
        with Store.open() as store:
            bundle = store.bundle(stated.run_id)
    if bundle.sha256 != stated.run_sha256:
        return Recomputed(False, (f"run_sha256: the run {stated.run_id} of this store is not the one that it states",))
    return _beside(stated, bundle, lambda step: progress(f"working the calibration out again: {step}"), closely)


def _beside(stated: Calibration, bundle: Bundle, progress: Progress, closely: bool) -> Recomputed:
    if false := of_its_run(stated, bundle.run()):
        return Recomputed(False, false, holds=False)
    how = way_of(stated)
    same = stated.made_by is not None and how["version"] == version()
    if not same and (strange := _stranger(stated, how)) is not None:
        return Recomputed(None, (strange,))
    try:
        made = work_out(bundle, how, progress) if same else _final_fit(stated, bundle, how, progress)
        _keep(made, _whole_place(stated) if same else _final_place(stated))
    except InputError as error:
        return Recomputed(False, (f"{'made_by' if same else 'effects'}: {error}",), holds=not same)
    return whole_way(stated, made) if same else final_fit(stated, made, closely=closely)


def way_of(stated: Calibration) -> MadeBy:
    """How a calibration was made; where it does not say so, the loop's own residuals tell it from a fit."""
    if stated.made_by is not None:
        return stated.made_by
    looped = bool(stated.effects) or "train_rms_nT" in stated.metrics.get("after", {})
    command = CLOSE_LOOP if looped else FIT
    return {"command": command, "method": "ml", "channels": None, "empirical": False, "version": ""}


def work_out(bundle: Bundle, how: MadeBy, progress: Progress) -> Calibration:
    """All that its command did, by this version."""
    run = bundle.run()
    if how["command"] == CLOSE_LOOP:
        closed = loop.close_loop(run, progress, empirical=how["empirical"])
        found = closed.fit()
        again = made_by(CLOSE_LOOP, found.method, empirical=how["empirical"])
        return draft_calibration(run, found, bundle.sha256, made_by=again, chain=bundle.stated_chain)
    again, found = made_by(FIT, how["method"], how["channels"]), _fitted(run, how, progress)
    return draft_calibration(run, found, bundle.sha256, made_by=again, chain=bundle.stated_chain)


def _final_fit(stated: Calibration, bundle: Bundle, how: MadeBy, progress: Progress) -> Calibration:
    """The map with the effects that are named, by this version."""
    run = bundle.run()
    if how["command"] != CLOSE_LOOP:
        return draft_calibration(run, _fitted(run, how, progress), bundle.sha256, made_by=how)
    found = _refitted(run, stated, progress)
    again = {**how, "method": found.fit.method, "channels": None}
    metrics = with_held_out(found.metrics, stated.metrics)
    return draft_calibration(run, found.fit, bundle.sha256, metrics=metrics, made_by=again)


def _refitted(run: Run, stated: Calibration, progress: Progress) -> Refit:
    from labcal.loop.refit import refit_with_metrics  # and all that finds effects

    try:
        with np.errstate(all="ignore"):
            return refit_with_metrics(run, _fitted_effects(stated), progress)
    except InputError:
        raise
    except Exception as error:  # the formulas, other packages' too, may stumble over names and counts in many ways
        raise InputError(f"they are not whole, or give no numbers ({type(error).__name__})") from error


def _fitted(run: Run, how: MadeBy, progress: Progress) -> Fit:
    if how["command"] != FIT:
        raise InputError(f"no command {how['command']!r} makes a calibration")
    progress(f"fitting by {how['method']}")
    return fit(run if how["channels"] is None else _with_channels(run, how["channels"]), how["method"])


def _with_channels(run: Run, channels: Sequence[str]) -> Run:
    try:
        return run.with_channels(channels)
    except KeyError as error:
        raise InputError(str(error.args[0])) from None


def _fitted_effects(stated: Calibration) -> list[EffectRecord]:
    """The effects that are named, the sensor's without where they were seen: the run says that."""
    named = [effect for effect in (*stated.effects, *stated.findings) if effect.belongs_to != "data"]
    return [replace(effect, domain=()) if effect.belongs_to == "sensor" else effect for effect in named]


def _stranger(stated: Calibration, how: MadeBy) -> str | None:
    """What of another package it needs that is not installed here."""
    if how["command"] == FIT:
        there = how["method"] in methods()
        return None if there else f"made_by.method: no installed package has the method {how['method']!r}"
    for place, records in (("effects", stated.effects), ("findings", stated.findings)):
        for i, record in enumerate(records):
            if find(record.effect) is None:
                return f"{place}[{i}]: no installed package describes the effect {record.effect!r}"
    return None


def _kept(place: Path) -> Calibration | None:
    """What is kept there; None where nothing is that can be read."""
    try:
        return certificate.read_calibration(place)
    except (InputError, OSError):
        return None


def _whole_place(stated: Calibration) -> Path:
    """Where the whole way is kept: by the run's content, and how and by which version it was made."""
    return _place(stated.run_sha256, stated.made_by and dict(stated.made_by))


def _final_place(stated: Calibration) -> Path:
    """Where this labcal's final fit is kept: by the run's content, the effects that are named and the metrics."""
    effects, metrics = [asdict(e) for e in _fitted_effects(stated)], {w: dict(m) for w, m in stated.metrics.items()}
    return _place(stated.run_sha256, dict(way_of(stated)), this_labcal(), effects, metrics)


def _place(*made_from: object) -> Path:
    return home() / FOLDER / f"{hashlib.sha256(json.dumps(made_from, sort_keys=True).encode()).hexdigest()}.json"
