"""From a run of `cage-calibration`, a draft, to the cage calibration that a person has approved."""

from __future__ import annotations

from collections.abc import Iterable

from labcal.bench.coils.cage_file import CageCalibration, Place
from labcal.errors import InputError
from labcal.record import RunHeader
from labcal.record.person import perhaps_one_person
from labcal.record.stream import Event, Item, Measurement

DRAFT = "cage-calibration"  # the procedure, and the kind of the event that holds what it found


def approved_cage(header: RunHeader, status: str, items: Iterable[Item], name: str) -> CageCalibration:
    """The draft of a run, approved by `name`. Raises InputError where there is none, or none that may be approved."""
    if header.procedure != DRAFT or status != "finished":
        raise InputError(f"run {header.run_id} is no finished cage-calibration: it is of {header.procedure}, {status}")
    name = " ".join(name.split())
    if not name or perhaps_one_person(name, header.operator):
        raise InputError("another person than the operator approves: --as NAME")
    found, last = None, dict[str, Measurement]()
    for item in items:
        if isinstance(item, Measurement):
            last[item.name] = item
        if isinstance(item, Event) and item.kind == DRAFT:
            found = item.data
    if beyond := [m.name for m in last.values() if m.verdict == "FAIL"]:
        raise InputError(f"run {header.run_id} failed its limits: {', '.join(beyond)}")
    if found is None:
        raise InputError(f"run {header.run_id} found nothing")
    remote = "DUT less reference" in found
    return CageCalibration(
        run_id=header.run_id,
        simulated=header.simulated,
        measured_utc=header.started_utc,
        operator=header.operator,
        approved_by=name,
        dut=Place(**found["DUT"]),
        carry=Place(**found["DUT less reference"]) if remote else None,
        reference_position_m=header.reference.position_m if remote else None,
    )
