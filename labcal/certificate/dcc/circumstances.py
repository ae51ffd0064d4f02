"""Method, equipment with traceability, and conditions of a DCC's measurement."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np

from labcal.certificate.dcc.parts import Makers, one_line
from labcal.certificate.report.circumstances import MEASURED, STATED, Circumstances, performed
from labcal.model import Calibration
from labcal.record import Run
from labcal.record.administrative import Certified, certified

KINDS = {
    "Temperature": "basic_temperature",
    "Humidity": "basic_humidityRelative",
    "Pressure": "basic_pressure",
}


def used_methods(m: Makers, c: Calibration, said: Circumstances) -> Any:
    """By which procedure and estimator, and by which rules the uncertainty was worked out."""
    by = c.made_by or {}
    how = [f"Procedure {said.procedure or 'not known here'}.", f"Estimated by {by.get('method', 'not stated')}."]
    how += [f"SHA-256 of the procedure's source: {said.procedure_sha256}."] if said.procedure_sha256 else []
    measured = m.d.usedMethod(
        m.text("name", "the laboratory's own method: comparison with a reference in a field cage"),
        m.text("description", " ".join(how)),
        refType="basic_calibrationMethod",
    )
    uncertain = m.d.usedMethod(
        m.text("name", "measurement uncertainty"),
        m.text("description", "Expanded uncertainty, k = 2 where no other k is stated, about 95 %."),
        m.d.norm("JCGM 100:2008"),
        m.d.norm("ILAC P14:09/2020"),
        refType="basic_methodMeasurementUncertainty",
    )
    return m.d.usedMethods(measured, uncertain)


def measuring_equipments(m: Makers, c: Calibration, run: Run, said: Circumstances) -> Any:
    """The reference and what else was stated, each with its certificate."""
    own = certified(run.reference.certificate)
    serial, kind, day = run.reference.serial, run.reference.kind, f"{performed(run)[0]:%Y-%m-%d}"
    made = partial(_equipment, m, day=day, simulated=c.simulated)
    reference = made(f"reference ({kind})", *said.made_by(serial), serial, own)
    others = [
        made(e.name, e.manufacturer, e.model, e.serial, e.certificate or Certified())
        for e in said.administrative.equipment
    ]
    reference.set("refType", "basic_referenceStandard")
    return m.d.measuringEquipments(reference, *others)


def _equipment(
    m: Makers,
    name: str,
    maker: str | None,
    model: str | None,
    serial: str | None,
    stated: Certified,
    *,
    day: str,
    simulated: bool,
) -> Any:
    d, known = m.d, [("manufacturer", serial, "serial number")]
    known += [("calibrationLaboratory", stated.number, "number of its certificate")]
    known += [("calibrationLaboratory", stated.issuer, "issuer of its certificate")]
    given = [m.identification(issuer, value, said) for issuer, value, said in known if value]
    identifications = [d.identifications(*given)] if given else []
    objection = stated.objection_on(day)
    shown = (
        f"traceability not shown: its certificate {objection}"
        if objection
        else "traceable to the SI through its certificate"
    )
    text = "SIMULATED: nothing is traceable" if simulated else shown
    description = m.text("description", f"{text}. {stated.in_words() or 'No certificate is stated'}.")
    made = [d.manufacturer(m.text("name", maker))] if maker else []
    of_model = [d.model(one_line(model))] if model else []
    return d.measuringEquipment(m.text("name", name), description, *made, *of_model, *identifications)


def influence_conditions(m: Makers, run: Run) -> Any:
    """The surroundings as measured along the run or stated for it; one condition that says so where none is."""
    measured = [_measured(m, c.name, c.quantity, c.unit, c.values) for c in run.channels if _of_the_room(c)]
    stated = run.environment or {}
    given = [
        _condition(m, name, "stated for the bench", m.quantity(stated[key], unit), KINDS.get(name, ""))
        for key, name, unit in STATED
        if key in stated
    ]
    if not (measured or given):
        text = m.d.text(m.d.content("not stated", lang="en"))
        given = [m.d.influenceCondition(m.text("name", "environment"), m.d.data(text))]
    return m.d.influenceConditions(*measured, *given)


def _of_the_room(channel: Any) -> bool:
    return channel.role == "room" and channel.quantity in MEASURED and bool(np.isfinite(channel.values).any())


def _measured(m: Makers, name: str, quantity: str, unit: str, values: Any) -> Any:
    seen = values[np.isfinite(values)]
    text = f"mean along the run of {name}, which went from {seen.min():.6g} to {seen.max():.6g} {unit}"
    said = MEASURED[quantity]
    return _condition(m, said, text, m.quantity(float(seen.mean()), unit), KINDS.get(said, ""))


def _condition(m: Makers, name: str, text: str, quantity: Any, ref_type: str) -> Any:
    of_type = {"refType": ref_type} if ref_type else {}
    return m.d.influenceCondition(m.text("name", name), m.text("description", text), m.d.data(quantity), **of_type)
