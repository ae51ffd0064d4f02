"""The report of a calibration file: what it says, who stands for it, and what it does not cover."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from hashlib import sha256

import numpy as np

from labcal.certificate.parameters_k import COVERAGE, k_in_words, k_of_parameters
from labcal.certificate.report.budget import OF_THE_FIELD, budget_blocks, field_blocks, indication_blocks
from labcal.certificate.report.circumstances import (
    NOTHING_SAID,
    Circumstances,
    environment,
    equipment,
    how_to_check,
    identity,
    people,
    statements,
)
from labcal.certificate.report.conformity import change_blocks, conformity_blocks, conformity_marks
from labcal.certificate.report.derived import sensor_figures
from labcal.certificate.report.front import NO_NUMBER, front_of
from labcal.certificate.report.page import (
    Block,
    Facts,
    Headline,
    LargeNumber,
    Mark,
    Page,
    Prose,
    Table,
    section,
    sections,
)
from labcal.certificate.report.style import (
    NOTHING,
    number,
    of_the_map,
    printed_unit,
    sentence,
    two_digits,
    with_uncertainty,
)
from labcal.certificate.signing import Verification
from labcal.model import Calibration, EffectRecord, Parameter
from labcal.model.apply import temperature_channel
from labcal.model.calibration import units_of_channels
from labcal.model.effects import find, plainly
from labcal.model.records import Rival
from labcal.record import Dut, Run
from labcal.uncertainty.conformity import Changes, stated_lines
from labcal.uncertainty.unstated import not_stated

_UNKNOWN_RUN = (
    "Frame as mounted; mounting uncertainty not included. The reference's own scale, zero, alignment and time, "
    "where the run does not state them. (The run is not in this lab's store, so they cannot be listed here.)"
)
RESIDUAL_KEYS = (
    ("holdout_rms_nT", "on blocks of time that were held out: without and with the effects"),
    ("rms_scalar_nT", "of the magnitude, in sample: raw and calibrated"),
)


def calibration_page(
    calibration: Calibration,
    verification: Verification,
    checked: str,
    run: Run | None = None,
    changed: Changes | None = None,
    said: Circumstances = NOTHING_SAID,
) -> Page:
    """The certificate of `calibration`; `verification` of its file was made as `checked` says (when, by whose list).

    With its `run` at hand the page says which of the reference's uncertainties were never stated; `changed` is what
    changed since the calibration before, `said` what the record tells beside it.
    """
    dut, lines = calibration.dut, stated_lines(calibration)
    return Page(
        kind="Calibration certificate",
        title=dut.serial,
        subtitle=dut.model,
        simulated=calibration.simulated,
        marks=(*_marks(verification), *_doubts(calibration), *conformity_marks(lines)),
        headline=_headline(calibration),
        facts=identity(calibration, run, said),
        sections=sections(
            section(
                "Results", [*indication_blocks(calibration, run), *field_blocks(calibration), *_parameters(calibration)]
            ),
            section(
                "Is it in specification?",
                conformity_blocks(lines, run.specification if run else None, recorded=calibration.chain is not None),
            ),
            section("As found, as left", change_blocks(changed)),
            section("Environment", environment(run)),
            section("Equipment and traceability", equipment(calibration, run, said)),
            section(
                "Effects of the sensor, corrected by this calibration",
                effect_tables(calibration.effects, k_of_parameters(calibration)),
            ),
            section("Where it holds", [_validity(calibration, run)]),
            section("What is not covered", [Prose((*said.open_checks, *_not_covered(calibration, run)))]),
            section("Uncertainty budget", budget_blocks(calibration)),
            section(
                "Findings about the rig and the data, not part of the correction",
                effect_tables(calibration.findings, k_of_parameters(calibration)),
            ),
            section("How well it fits", [_residuals(calibration)]),
            section("Who stands for it", _signatures(calibration, verification, checked)),
            section("Statements", [Prose(statements(calibration))]),
            section("How to check the signatures", [Prose(how_to_check(verification.file.name))]),
        ),
        footer=f"b = K m − k − Σ effects, in nT of the sensor's own axes. Made by {calibration.software or 'labcal'}. "
        f"End of the certificate {calibration.number or NO_NUMBER}.",
        front=front_of(calibration, verification, said.images),
    )


def name_of(dut: Dut) -> str:
    """Serial and model, once where they are the same."""
    return dut.serial if dut.model in ("", dut.serial) else f"{dut.serial} {dut.model}"


def effect_tables(effects: Sequence[EffectRecord], k: float = COVERAGE) -> list[Table]:
    """A table an effect: its parameters with U = k u, and below them why it was decided so."""
    return [_effect_table(effect, k) for effect in effects]


def headline_of(before: float | None, after: float | None, caption: str) -> Headline | None:
    """Both numbers with the decimals the smaller one needs; None where one is missing."""
    if before is None or after is None:
        return None
    decimals = 1 if min(before, after) < 1000 else 0
    return Headline(number(before, decimals), number(after, decimals), "nT", caption)


def _effect_table(effect: EffectRecord, k: float) -> Table:
    name = named(effect) + (" (provisional)" if effect.provisional else "")
    family = find(effect.effect)
    kinds = {shape.name: shape.kind.name for shape in family.shapes} if family is not None else {}
    rows = tuple(_parameter_row(parameter, k, kinds.get(parameter.name)) for parameter in effect.parameters)
    if effect.basis is not None:  # its coefficients say nothing one by one
        rows = ((f"{len(rows)} coefficients of a smooth function", NOTHING, NOTHING, "nT"),)
    return Table((name, "Value", f"U (k = {k_in_words(k)})", "Unit"), rows, frozenset({1, 2}), _why(effect))


def _parameter_row(p: Parameter, k: float, kind: str | None = None) -> tuple[str, str, str, str]:
    name = f"{p.name} ({kind})" if kind else p.name
    if p.name == "rows":  # a finding's count
        return name, number(p.value, 0), NOTHING, NOTHING
    return name, *with_uncertainty(p.value, k * p.u), printed_unit(p.unit)


def _why(effect: EffectRecord) -> str:
    before, after = effect.holdout_rms_before_nT, effect.holdout_rms_after_nT
    said = [what_it_is(effect.effect), sentence(effect.why)]
    if before is not None and after is not None and "held-out" not in effect.why:
        said.append(f"Held-out rms {number(before)} → {number(after)} nT.")
    if (gain := effect.improvement_ci95_nT) is not None:
        said.append(f"What it takes off lies between {number(gain[0])} and {number(gain[1])} nT (95 %).")
    said += [f"Rival: {named(r)} ({number(r.holdout_rms_after_nT)} nT)." for r in effect.rivals]
    units = units_of_channels([effect])
    said += [
        f"{name} counts from {value:g} {units.get(name, '')}".rstrip() + "."
        for name, value in effect.reference_value.items()
    ]
    return " ".join(filter(None, said))


def named(cause: EffectRecord | Rival) -> str:
    """What happens, in plain words, then what files call it, and its channels."""
    words = plainly(cause.effect)
    return " · ".join(filter(None, (words if words != cause.effect else "", cause.effect, *cause.channels)))


def what_it_is(effect: str) -> str:
    """The physics of an effect in a sentence, as its own file begins; empty where it does not say."""
    known = find(effect)
    said = sys.modules[known.kernel.__module__].__doc__ if known is not None else None
    return " ".join((said or "").strip().split("\n\n")[0].split())


def _marks(verification: Verification) -> tuple[Mark, ...]:
    if not verification.checks:
        return (Mark("DRAFT · NOT SIGNED", "warning"),)
    if not verification.valid:
        return (Mark("SIGNATURE NOT VALID", "bad"),)
    provisional = (Mark("PROVISIONAL", "warning"),) if verification.provisional else ()
    return (Mark("SIGNED · VALID", "good"), *provisional)


def _doubts(c: Calibration) -> tuple[Mark, ...]:
    """What no signature takes away."""
    whole = () if not c.not_measured() else (Mark("NOT MEASURED WHOLE", "bad"),)
    return (*whole, *((Mark("UNEXPLAINED", "warning"),) if c.unexplained() else ()))


def _headline(c: Calibration) -> LargeNumber | None:
    """The largest U of the field's components over the working range; None where no budget tells it."""
    field = [b for b in c.budget if b["quantity"].startswith(OF_THE_FIELD)]
    if not field:
        return None
    worst = max(field, key=lambda b: b["U"])
    low, high = (number(b, 0) for b in c.validity.field_nT)
    caption = (
        f"largest expanded uncertainty of a component of the field from one reading, k = {worst['k']:.2f} "
        f"(about 95 %), over the working range of {low} to {high} nT"
    )
    return LargeNumber(f"U = {two_digits(worst['U'])}", "nT", caption)


def _residuals(c: Calibration) -> Table | None:
    """What the fit leaves of the run: how well it describes it, which is no uncertainty."""
    before, after = c.metrics.get("before", {}), c.metrics.get("after", {})
    rows = [
        (what, number(before[key]), number(after[key]), "nT")
        for key, what in RESIDUAL_KEYS
        if key in before and key in after
    ]
    note = "Residuals say how well the calibration describes its own run; they are no uncertainty."
    return Table(("Residual, rms", "Before", "After", "Unit"), tuple(rows), frozenset({1, 2}), note) if rows else None


def _parameters(c: Calibration) -> list[Block]:
    per_unit = "" if c.dut.unit == "nT" else f" (nT/{c.dut.unit})"
    u = None if c.covariance is None else np.sqrt(np.maximum(np.diag(c.covariance)[:12], 0.0))
    values = np.column_stack([c.affine.K, c.affine.k_nT])
    U = np.full((3, 4), np.nan) if u is None else k_of_parameters(c) * np.column_stack([u[:9].reshape(3, 3), u[9:]])
    rows = list[tuple[str, ...]]()
    for axis, value, spread in zip("xyz", values, U, strict=True):
        cells = [of_the_map(*pair) for pair in zip(value, spread, strict=True)]
        rows += [(f"b {axis}", *(cell[0] for cell in cells)), ("U", *(cell[1] for cell in cells))]
    header = ("", f"K · x{per_unit}", f"K · y{per_unit}", f"K · z{per_unit}", "offset k (nT)")
    note = _coverage(c) if u is not None else "No covariance stated."
    note += f" Offset k is that {c.k_means()}." if c.k_means() else ""
    return [Table(header, tuple(rows), frozenset({1, 2, 3, 4}), note), sensor_figures(c, COVERAGE)]


def _coverage(c: Calibration) -> str:
    """By which k the U of a parameter holds 95 %."""
    k = k_of_parameters(c)
    said = f"U is the expanded uncertainty, coverage factor {k_in_words(k)} (about 95 %)."
    few = " Few degrees of freedom are behind it: it is the largest of the sensor's figures, and holds 95 % or more."
    return said if k == COVERAGE else said.replace("(about 95 %)", "(95 % at least)") + few


def _validity(c: Calibration, run: Run | None) -> Facts:
    lo, hi = c.validity.field_nT
    temperature = c.validity.temperature_C
    warm = temperature_channel(c, {channel.name for channel in run.channels}) if run else None
    return Facts(
        (
            ("Field", f"{number(lo, 0)} to {number(hi, 0)} nT"),
            (
                f"Temperature ({warm})" if warm else "Temperature",
                f"{number(temperature[0])} to {number(temperature[1])} °C" if temperature else "not recorded",
            ),
            ("Power modes", ", ".join(c.validity.modes) or "not stated"),
            ("Last day of use", c.validity.until or "no date stated"),
            ("Run's clock", f"{number(c.span_s[0])} to {number(c.span_s[1])} s (for effects bound to the run's time)"),
        )
    )


def _not_covered(c: Calibration, run: Run | None) -> tuple[str, ...]:
    said = list(c.not_covered or (not_stated(run) if run else [_UNKNOWN_RUN]))
    if not c.frame_known:
        said.append("The attitude of the sensor in its body: the run does not show it; K is symmetric by convention.")
    if c.covariance is None:
        said.append("Uncertainty: the method that made this calibration states none.")
    if c.cage_sha256 is None:
        said.append("The cage: no cage calibration is named.")
    said.append("Fields, temperatures and power modes outside the ranges above; ageing and shocks after the run.")
    return (
        *said,
        *(f"{e.effect} is provisional: another cause may be the true one." for e in c.effects if e.provisional),
    )


def _head(c: Calibration) -> str:
    return f"{c.chain['head']}, {c.chain['rows']} rows" if c.chain else "origin not shown"


def _signatures(c: Calibration, v: Verification, checked: str) -> list[Block | None]:
    rows = tuple(
        (k.file.name, k.principal or "unknown", k.fingerprint or "–", v.signed_at(k), k.objection or "good")
        for k in v.checks
    )
    table = Table(("File", "Signed by", "Key", "Signed", "Result"), rows) if rows else None
    facts = Facts(
        (
            ("SHA-256 of the calibration file", sha256(v.content).hexdigest()),
            ("SHA-256 of its run", c.run_sha256),
            ("Head of its run's chain", _head(c)),
            ("Supersedes", c.supersedes or "–"),
            ("Checked", checked),
        )
    )
    return [people(c, v), Prose(tuple(v.sentences())), table, facts]
