"""Results of a DCC: errors of indication, parameters and effects with U and covariance, budget, conformity."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from labcal.certificate.dcc.basis import basis_in_words, basis_quantities
from labcal.certificate.dcc.changes import change_results
from labcal.certificate.dcc.conformity import conformity_results
from labcal.certificate.dcc.parts import Makers
from labcal.certificate.indications import Indication, indications
from labcal.certificate.parameters_k import k_of_parameters
from labcal.model import Calibration, EffectRecord
from labcal.model.affine import MAP_PARAMETERS
from labcal.model.effects import find
from labcal.record import Run
from labcal.uncertainty.conformity import Changes

MODEL = (
    "b = K m - k - sum of effects e(a, channels, t), a = K m - k: b is the field in the sensor's own axes in nT, m its "
    "reading. A channel enters an effect as its value less its reference value."
)


def results(m: Makers, c: Calibration, run: Run, changed: Changes | None) -> list[Any]:
    """All dcc:result elements."""
    per_reading = "1" if c.dut.unit == "nT" else "nT/count"
    u = np.full(12, np.nan) if c.covariance is None else np.sqrt(np.maximum(np.diag(c.covariance)[:12], 0.0))
    f = k_of_parameters(c)
    K, k = m.real_list(c.affine.K, per_reading, f * u[:9], f), m.real_list(c.affine.k_nT, "nT", f * u[9:], f)
    return [
        *(_indication(m, c, one) for one in indications(c, run)),
        m.result("K", f"Row by row. {MODEL}", m.d.quantity(K), ref_type="labcal_K"),
        m.result(f"k {c.k_means()}".rstrip(), "", m.d.quantity(k), ref_type="labcal_k"),
        *(_effect(m, i, effect, f, run) for i, effect in enumerate(c.effects) if effect.parameters),
        *_joint(m, c, per_reading),
        *conformity_results(m, c, run.specification),
        *change_results(m, changed),
        *(_budget(m, b) for b in c.budget if b["rows"]),
    ]


def _indication(m: Makers, c: Calibration, one: Indication) -> Any:
    """What the item indicates of a known field, and its error."""
    U, k = one.U_nT, one.k
    listed = m.d.list(
        m.d.quantity(
            m.text("name", "reference value"), m.real_list(one.field_nT, "nT"), refType="basic_referenceValue"
        ),
        m.d.quantity(
            m.text("name", "indicated value"), m.real_list(one.indicated_nT, "nT", U, k), refType="basic_measuredValue"
        ),
        m.d.quantity(
            m.text("name", "error of indication"),
            m.real_list(one.error_nT, "nT", U, k),
            refType="basic_measurementError",
        ),
    )
    what = f"Components x, y, z of the reading times {c.dut.nominal_nT_per_unit:g} nT, the nominal value of its unit."
    return m.result(f"Indication of {one.at}", what, listed, ref_type="basic_result")


def _effect(m: Makers, i: int, effect: EffectRecord, k: float, run: Run) -> Any:
    """One effect with its formula and the reference values of its channels: what is taken off, beside K m - k."""
    family = find(effect.effect)
    formula = " ".join((family.kernel.__doc__ or "").split()) if family else "known to the package that brings it"
    at = "; ".join(f"reference value of {name}: {value!r}" for name, value in effect.reference_value.items())
    parameters = [m.quantity(p.value, p.unit, k * p.u, "labcal_effectParameter", p.name, k) for p in effect.parameters]
    unit_of = {channel.name: channel.unit for channel in run.channels}
    reference = [
        m.quantity(value, unit_of.get(name, "1"), None, "labcal_channelReference", name)
        for name, value in effect.reference_value.items()
    ]
    channels = f" Channels: {', '.join(effect.channels)}." if effect.channels else ""
    what = f"Formula: {formula}{channels}{f' {at}.' if at else ''}{basis_in_words(effect)}"
    listed = m.d.list(*parameters, *reference, *basis_quantities(m, effect, unit_of))
    return m.result(f"effect {i}: {effect.effect}", what, listed, ref_type="labcal_effect")


def _joint(m: Makers, c: Calibration, per_reading: str) -> list[Any]:
    """All parameters with the covariance of every two of them; nothing where the method states none."""
    if c.covariance is None:
        return []
    values = dict(zip(MAP_PARAMETERS, [*c.affine.K.ravel(), *c.affine.k_nT], strict=True))
    units = dict.fromkeys(MAP_PARAMETERS[:9], per_reading) | dict.fromkeys(MAP_PARAMETERS[9:], "nT")
    for i, effect in enumerate(c.effects):
        values |= {f"{i}:{p.name}": p.value for p in effect.parameters}
        units |= {f"{i}:{p.name}": p.unit for p in effect.parameters}
    names = c.covariance_of
    joint = m.joint_list(names, [values[n] for n in names], [units[n] for n in names], c.covariance)
    what = "K row by row, k, then the parameters of the effects by their number."
    return [m.result("joint covariance", what, m.d.quantity(joint), ref_type="labcal_covariance")]


def _budget(m: Makers, b: Mapping[str, Any]) -> Any:
    """What each source contributes to the standard uncertainty of one quantity, and in words what it comes to."""
    rows, at = b["rows"], f" at {b['at']}" if b["at"] else ""
    dof = "infinite" if b["dof"] is None else f"{b['dof']:.4g}"
    what = f"U = {b['U']:.3g} {b['unit']}, k = {b['k']:.2f}, effective degrees of freedom {dof}. Sources: "
    what += "; ".join(
        f"{r['source']} (type {r['type']}, {r['distribution']}, u = {r['u']:.3g} {r['unit']}, "
        f"sensitivity {r['sensitivity']:.3g}, {100 * r['share']:.1f} %)"
        for r in rows
    )
    parts = m.real_list([abs(r["u"] * r["sensitivity"]) for r in rows], b["unit"])
    name = f"Contributions to the standard uncertainty of {b['quantity']}{at}"
    return m.result(name, what, m.d.quantity(parts), ref_type="labcal_budget")
