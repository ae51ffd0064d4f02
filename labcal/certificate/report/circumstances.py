"""What a certificate says beside its numbers: who, for whom, on what, when, where, how, and by which equipment.

Each block names in its comment the clause of ISO/IEC 17025:2017 that asks for it; what nobody stated is said to be so.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from datetime import date, datetime, timedelta

import numpy as np

from labcal.certificate import roles
from labcal.certificate.report.page import Block, Facts, Prose, Table
from labcal.certificate.report.style import NOTHING, number
from labcal.certificate.signing import Verification
from labcal.model import Calibration
from labcal.record import Administrative, Run
from labcal.record.administrative import Address, Certified, certified
from labcal.record.person import perhaps_one_person

NOT_STATED = "not stated"
NOTHING_STATED = Administrative()
UNKNOWN_RUN = "not known here: the run is not in this lab's store"
MEASURED = {"temperature": "Temperature", "pressure": "Pressure", "humidity": "Humidity"}
STATED = (  # keys of [environment], as they are printed
    ("temperature_C", "Temperature", "°C"),
    ("pressure_hPa", "Pressure", "hPa"),
    ("humidity_percent", "Humidity", "%"),
    ("ambient_nT", "Ambient field, without the coils", "nT"),
    ("ambient_variation_nT", "Its variation, peak to peak", "nT"),
    ("Kp", "Planetary index Kp", ""),
)


@dataclass(frozen=True, slots=True)
class Circumstances:
    """What the record tells beside the calibration; `images` are data: addresses of logo and accreditation mark.

    `instruments` are what answered on the bench, as `RunHeader` has them.
    """

    administrative: Administrative = NOTHING_STATED
    procedure: str = ""
    procedure_sha256: str = ""
    images: tuple[str, ...] = ()
    instruments: tuple[Mapping[str, str], ...] = ()
    open_checks: tuple[str, ...] = ()  # of the run: a sentence for each that is no PASS

    def made_by(self, serial: str) -> tuple[str, str]:
        """Manufacturer and model of the instrument of this serial number, as it answered; empty where unknown."""
        known = (one for one in self.instruments if serial and one.get("serial") == serial)
        return next(((one.get("manufacturer", ""), one.get("model", "")) for one in known), ("", ""))


NOTHING_SAID = Circumstances()


def identity(c: Calibration, run: Run | None, said: Circumstances) -> Facts:
    """Laboratory, customer, item, dates, place, method (7.8.2.1 b, c, e to k)."""
    stated = said.administrative
    item, laboratory = stated.item, stated.laboratory
    accredited = laboratory.accreditation if laboratory and not c.simulated else ""  # nothing simulated is in its scope
    rows = [
        ("Laboratory", _address(laboratory)),
        *([("Accreditation", accredited)] if accredited else []),
        ("Customer", _address(stated.customer)),
        ("Item", _item(c, item.manufacturer if item else None)),
        ("Condition of the item", (item and item.condition) or NOT_STATED),
        ("Received", (item and item.received) or NOT_STATED),
        ("Calibrated", _when(run)),
        ("Issued", c.issued_utc[:10] if c.issued_utc else "no date of issue is stated"),
        ("Place", _place(stated)),
        ("Method", _method(c, said)),
        ("Run", c.run_id),
    ]
    return Facts(tuple(rows))


def _address(who: Address | None) -> str:
    return ", ".join(who.lines()) if who else NOT_STATED


def _item(c: Calibration, manufacturer: str | None) -> str:
    reading = "nT" if c.dut.unit == "nT" else f"counts of {c.dut.nominal_nT_per_unit:g} nT"
    named = ", ".join(filter(None, ("magnetometer", manufacturer, c.dut.model)))
    return f"{named}, serial {c.dut.serial}; it reads in {reading}"


def performed(run: Run) -> tuple[datetime, datetime]:
    """When the measurement began and ended."""
    begin = datetime.fromisoformat(run.started_utc)
    return begin, begin + timedelta(seconds=float(run.t_s[-1] - run.t_s[0]) if len(run) else 0.0)


def _when(run: Run | None) -> str:
    if run is None:
        return UNKNOWN_RUN
    days = [f"{when:%Y-%m-%d}" for when in performed(run)]
    return " to ".join(dict.fromkeys(days))


def _place(stated: Administrative) -> str:
    if stated.laboratory is None:
        return NOT_STATED
    return stated.laboratory.place or "at the laboratory's address"


def _method(c: Calibration, said: Circumstances) -> str:
    by = c.made_by or {}
    steps = [f"procedure {said.procedure}" if said.procedure else "", f"estimated by {by['method']}" if by else ""]
    steps += [f"procedure's source SHA-256 {said.procedure_sha256[:16]}…" if said.procedure_sha256 else ""]
    how = "; ".join(filter(None, (*steps, c.software)))
    uncertainty = "no uncertainty" if c.covariance is None else "uncertainty by JCGM 100:2008 (GUM)"
    return f"the laboratory's own: {how}; {uncertainty}"


def environment(run: Run | None) -> list[Block | None]:
    """What the surroundings were, as measured along the run or as stated for it (7.8.4.1 b)."""
    if run is None:
        return [Prose((f"The environment is {UNKNOWN_RUN}.",))]
    rows, stated = _measured(run), run.environment or {}
    there = {name for name, *_ in rows}
    if not rows and not stated:
        return [Prose(("Nothing is stated of temperature, pressure, humidity and the ambient field.",))]
    rows += [_as_stated(name, stated.get(key), unit) for key, name, unit in STATED if name not in there]
    return [Table(("", "Value", "From"), tuple(rows))]


def _as_stated(name: str, value: float | None, unit: str) -> tuple[str, str, str]:
    if value is None:
        return name, NOT_STATED, NOTHING
    return name, f"{value:,g} {unit}".strip().replace(",", "\u202f").replace("-", "\u2212"), "stated for this bench"


def _measured(run: Run) -> list[tuple[str, str, str]]:
    rows = list[tuple[str, str, str]]()
    for channel in run.channels:
        seen = channel.values[np.isfinite(channel.values)]
        if channel.role == "room" and channel.quantity in MEASURED and len(seen):
            unit = channel.unit.replace("degC", "°C")
            value = f"{number(seen.mean())} {unit}, from {number(seen.min())} to {number(seen.max())}"
            rows.append((MEASURED[channel.quantity], value, f"measured along the run: {channel.name}"))
    return rows


def equipment(c: Calibration, run: Run | None, said: Circumstances) -> list[Block | None]:
    """Reference and equipment with their certificates, and what that says of traceability (7.8.4.1 c, 6.5)."""
    if run is None:
        return [Prose((f"Reference and equipment are {UNKNOWN_RUN}.",))]
    day, of_reference = performed(run)[0].date(), certified(run.reference.certificate)
    reference = (*said.made_by(run.reference.serial), run.reference.serial)
    rows = [_row(f"reference ({run.reference.kind})", reference, of_reference, day)]
    for one in said.administrative.equipment:
        rows.append(_row(one.name, (one.manufacturer, one.model, one.serial), one.certificate or Certified(), day))
    header = ("Equipment", "Maker, model, serial", "Certificate", "Issuer", "Date", "Due", "U")
    return [Table(header, tuple(rows)), Prose(_traceability(c, of_reference, day))]


def _row(name: str, known_as: Iterable[str | None], stated: Certified, day: date) -> tuple[str, ...]:
    overdue = stated.due is not None and date.fromisoformat(stated.due) < day
    due = f"{stated.due} OVERDUE" if overdue else stated.due
    cells = (" ".join(filter(None, known_as)), stated.number, stated.issuer, stated.date, due, stated.U)
    return name, *(cell or NOTHING for cell in cells)


def _traceability(c: Calibration, stated: Certified, day: date) -> tuple[str, ...]:
    if c.simulated:
        said = "SIMULATED: nothing was measured, and nothing is traceable."
    elif objection := stated.objection_on(day.isoformat()):
        said = f"Traceability to the SI is not shown: the reference's certificate {objection}."
    else:
        said = (
            "The results are traceable to the International System of Units (SI) through the reference, by its "
            f"certificate {stated.number} of {stated.issuer}, {stated.date}."
        )
    named = c.cage_sha256 and f"The coils were driven by the cage calibration of SHA-256 {c.cage_sha256}."
    return tuple(filter(None, (said, named)))


def people(c: Calibration, v: Verification) -> Facts:
    """Who measured, approved and released it, and whether their signatures hold (7.8.2.1 o)."""
    releasing = [
        name for name in v.signers if roles.may(name, "release", v.trusted) and not perhaps_one_person(name, c.operator)
    ]
    approved = [f"{name} ({'signed' if name in v.signers else 'has not signed'})" for name in c.approvers]
    rows = (
        ("Measured by", c.operator or NOT_STATED),
        ("Approved by", ", ".join(approved) or "nobody"),
        ("Released by", ", ".join(releasing) or "nobody"),
    )
    return Facts(rows)


def statements(c: Calibration) -> tuple[str, ...]:
    """What every certificate states (7.8.2.1 l, 7.8.4.3; ILAC P14:09/2020, 5)."""
    until = c.validity.until
    said = (
        "The results relate only to the item named above, in the condition in which it was calibrated.",
        "U is the expanded uncertainty: the standard uncertainty times the coverage factor k, which gives a coverage "
        "probability of about 95 % (JCGM 100:2008).",
        "This certificate may be reproduced in full only, unless the laboratory agrees in writing.",
    )
    agreed = "a recommendation, which the customer has to have agreed to (ISO/IEC 17025, 7.8.4.3)"
    return (*said, f"Last day of use {until}, as stated at approval: {agreed}.") if until else said


def how_to_check(name: str) -> tuple[str, ...]:
    """How somebody without labcal checks the signatures of the file `name`."""
    return (
        "What is signed is the calibration file, byte for byte; this page is printed from it and carries its SHA-256.",
        f"With the laboratory's list of signers: ssh-keygen -Y verify -f allowed_signers -I SIGNER "
        f"-n labcal-calibration -s {name}.sshsig < {name} (OpenSSH 8.2 or newer).",
        f"With labcal: labcal verify {name}.",
    )
