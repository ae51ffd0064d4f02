"""A draft calibration from a run and a fit: what ships once it is approved and signed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError
from labcal.fit.result import Fit
from labcal.fit.wild import without_wild
from labcal.model import Calibration, EffectRecord, Validity
from labcal.model.apply import apply
from labcal.model.effects import of_temperature
from labcal.model.effects.inputs import CHANNEL
from labcal.model.plausibility import saturation_limits
from labcal.model.readings import readings_of
from labcal.model.smooth import Domain
from labcal.record import Run
from labcal.uncertainty.conformity import with_conformity
from labcal.uncertainty.of_calibration import as_json, budgets
from labcal.uncertainty.unstated import not_covered
from labcal.version import __version__

NEARLY_ALL = (0.01, 0.99)  # of the fields


def draft_calibration(
    run: Run,
    found: Fit,
    run_sha256: str,
    *,
    findings: Sequence[EffectRecord] = (),
    metrics: Mapping[str, Mapping[str, float]] | None = None,
    cage_sha256: str | None = None,
    made_by: Mapping[str, Any] | None = None,
    chain: Mapping[str, Any] | None = None,
) -> Calibration:
    """The calibration that `found` makes of `run`, its effects those of the sensor, valid where the run has been.

    `chain` is the head of the run's hash chain and its rows, None where its origin is not shown. `metrics` adds to what
    the fit says of itself, by default those that it brings along; `after` carries `noise_nT`, the noise of one axis of
    one reading, and what is left of held-out rows, which `apply` takes for its uncertainty. Raises InputError where the
    fit gives none.
    """
    if not found.ok or found.affine is None:
        raise InputError(f"method {found.method} gives no calibration of run {run.run_id}: {found.why_not}")
    own, saturated = _metrics(run, found), saturation_limits(run.reading, run.dut.unit)
    made = Calibration(
        run_id=run.run_id,
        simulated=run.simulated,
        dut=run.dut,
        affine=found.affine,
        covariance=found.covariance,
        frame_known=found.frame_known,
        validity=_validity(run, found.effects),
        span_s=(float(run.t_s[0]), float(run.t_s[-1])),
        run_sha256=run_sha256,
        effects=tuple(_where_seen(run, e) for e in found.effects if e.belongs_to == "sensor"),
        findings=(
            *(e for e in found.effects if e.belongs_to != "sensor"),
            *findings,
            *([saturated] if saturated else []),
        ),
        metrics={when: {**own[when], **(metrics or found.metrics or {}).get(when, {})} for when in own},
        instruments=_instruments(run),
        cage_sha256=cage_sha256,
        software=f"labcal {__version__}",
        operator=run.operator,
        covariance_of=found.covariance_of,
        k_at={
            name: value
            for e in found.effects
            if e.belongs_to == "sensor" and e.basis is None
            for name, value in e.reference_value.items()
        },
        made_by=made_by,
        chain=chain,
    )
    made = replace(made, not_covered=(*_held(made.not_measured()), *found.remarks, *not_covered(run)))
    if any(effect.belongs_to == "rig" for effect in found.effects):
        made = replace(made, validity=_with_fields_at_the_dut(made, run))
    if found.sources is not None:
        made = replace(made, budget=as_json(budgets(made, found.sources, run)))
    return with_conformity(made, run)


def _held(names: Sequence[str]) -> tuple[str, ...]:
    return (f"Not measured by this run, and held as they stand: {', '.join(names)}.",) if names else ()


def _metrics(run: Run, found: Fit) -> dict[str, dict[str, float]]:
    """Magnitude residuals of the raw readings and of the fit, and the noise that the fit met."""
    before: dict[str, float] = {}
    if run.reference.kind != "none":
        raw = np.linalg.norm(without_wild(run).reading_nT, axis=1) - run.magnitude_nT
        before["rms_scalar_nT"] = float(np.sqrt(np.nanmean(raw**2)))
    after = {
        "rms_scalar_nT": found.rms_scalar_nT,
        "holdout_rms_scalar_nT": found.holdout_rms_scalar_nT,
        "noise_nT": found.noise_nT if found.noise_nT is not None else run.dut.noise_nT,
    }
    return {"before": before, "after": {name: value for name, value in after.items() if value is not None}}


def _where_seen(run: Run, effect: EffectRecord) -> EffectRecord:
    """The same with the ends of each channel that it follows; an empirical term states its own domain."""
    ends = [(name, _ends(run.channel(name).values)) for name in effect.channels]
    if effect.domain or effect.basis is not None or any(found is None for _, found in ends):
        return effect
    seen = [Domain((f"{CHANNEL}{name}",), ((found[0],), (found[1],))) for name, found in ends if found]
    return replace(effect, domain=tuple(seen))


def _ends(values: NDArray[np.float64]) -> tuple[float, float] | None:
    known = values[np.isfinite(values)]
    return (float(known.min()), float(known.max())) if len(known) else None


def _validity(run: Run, effects: Sequence[EffectRecord]) -> Validity:
    magnitude = run.magnitude_nT
    seen = magnitude[np.isfinite(magnitude) & np.isfinite(run.reading).all(axis=1)]
    modes = tuple(str(m) for m in np.unique(run.mode) if m)
    return Validity((float(seen.min()), float(seen.max())), _temperatures(run, effects), modes)


def _with_fields_at_the_dut(made: Calibration, run: Run) -> Validity:
    """The validity with the fields that the DUT met: where the rig adds to it they are not the reference's.

    Nearly all of them: a wild reading among the others met no such field.
    """
    length = np.linalg.norm(apply(made, readings_of(run)).field_nT, axis=1)
    least, most = np.nanquantile(length, NEARLY_ALL)
    low, high = made.validity.field_nT
    return replace(made.validity, field_nT=(min(low, float(least)), max(high, float(most))))


def _temperatures(run: Run, effects: Sequence[EffectRecord]) -> tuple[float, float] | None:
    """Range of the temperature that an effect follows, else of `temp_dut`, else of the only one there is."""
    there = [c.name for c in run.channels if c.quantity == "temperature" and c.role == "dut"]
    used = [name for e in effects if of_temperature(e) for name in e.channels]
    wanted = [name for name in (*used, "temp_dut", *(there if len(there) == 1 else ())) if name in there]
    return _ends(run.channel(wanted[0]).values) if wanted else None


def _instruments(run: Run) -> tuple[Mapping[str, str], ...]:
    reference = run.reference
    if reference.kind == "none":
        return ()
    stated = {"role": "reference", "kind": reference.kind, "serial": reference.serial}
    return (stated | ({"calibration": reference.calibration} if reference.calibration else {}),)
