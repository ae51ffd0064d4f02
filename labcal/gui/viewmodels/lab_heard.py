"""The lab's state with what somebody who is no run has heard of it: who answered, what was read, what has failed."""

from __future__ import annotations

import time
from collections.abc import Collection, Mapping
from dataclasses import replace

from labcal.bench.coils import state
from labcal.bench.links.heard_before import NOT_HEARD, PLUG
from labcal.gui.ipc.answers import Bench, Doubt, Identified, InstrumentAnswer
from labcal.gui.ipc.lab_messages import InstrumentRead
from labcal.gui.ipc.wire import Fault
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.lab_now import UNHEARD
from labcal.gui.viewmodels.lab_off import coil_read

NO_REPLY = (*UNHEARD, "link was lost")  # in a fault: then it gives no answer, and has not failed otherwise


def identified(before: state.LabState | None, said: Identified) -> tuple[state.LabState, bool]:
    """Who answered, and who did not; whether a doubt about zero was lifted by the reference, which looked again."""
    now = time.monotonic()
    heard = tuple(
        state.Heard(one.name, None if one.fault else now, one.fault.text if one.fault else "")
        for one in said.instruments
    )
    after = replace(before or state.LabState(state.unread()), instruments=heard, guardian=None)
    if said.doubt is None:
        return after, False
    return looked_at(after, said.doubt), said.doubt.lifted


def looked_at(before: state.LabState | None, doubt: Doubt) -> state.LabState:
    """The lab after a zero in doubt was measured again: as it was seen now, in place of what was seen then."""
    known = before or state.LabState(state.unread())
    ends = {one.axis: coil_read(one) for one in doubt.coils}
    coils = tuple(ends.get(coil.axis, coil) for coil in known.coils)
    if doubt.lifted:
        return replace(known, coils=coils, reference=state.Witness("agrees", "", read_s=time.monotonic()))
    reference = state.Witness()
    if doubt.words.startswith(state.NOT_BY_REFERENCE):
        seen, _, advice = doubt.words.removeprefix(f"{state.NOT_BY_REFERENCE}: ").partition(". ")
        reference = state.Witness("disagrees", seen, read_s=time.monotonic(), advice=advice or state.OPEN_THEM)
    return replace(known, coils=coils, reference=reference)


def read(before: state.LabState | None, said: tuple[InstrumentRead, ...]) -> state.LabState:
    """The lab with what was read of these instruments; what another process has stays as it was known."""
    after = before or state.LabState(state.unread())
    coils = {coil.axis: coil for coil in after.coils}
    heard = {one.name: one for one in after.instruments}
    for one in said:
        if one.held:
            continue
        fault = "" if one.fault is None else one.fault.text
        heard[one.name] = state.Heard(one.name, None if fault else one.read_s, fault)
        if one.role.startswith("coil-"):
            axis, known = one.role[-1], one.current_A is not None
            coils[axis] = state.CoilReading(axis, None, one.current_A, one.zero, None, one.read_s if known else None,
                                            fault)  # fmt: skip
        if one.field_nT is not None:
            after = replace(after, field=state.FieldReading(None, one.field_nT, one.read_s))
        if one.moving is not None:
            after = replace(after, platform=state.PlatformReading(one.angle_deg, one.moving, one.read_s))
    return replace(after, coils=tuple(coils.values()), instruments=tuple(heard.values()), guardian=None)


def began_anew(before: state.LabState | None, after: state.LabState) -> bool:
    """Whether a platform that stood stands elsewhere, as it is shown: each session of a simulated bench begins anew."""
    was, now = None if before is None else before.platform, after.platform
    if was is None or now is None or was.moving or was.angle_deg is None or now.angle_deg is None:
        return False
    return round(was.angle_deg) != round(now.angle_deg)


def answers(said: tuple[InstrumentRead, ...]) -> dict[str, InstrumentAnswer]:
    """Who said who it is, or why it did not, by name."""
    return {
        one.name: InstrumentAnswer(one.name, one.role, one.link, one.identity, one.fault, one.serial)
        for one in said
        if one.identity or one.fault
    }


def plug_or_power(said: Mapping[str, InstrumentAnswer], heard: Collection[str]) -> dict[str, InstrumentAnswer]:
    """The same; of who is silent and was `heard` in this window the link is right: each worker hears for itself."""
    return {name: replace(one, fault=at_its_plug(one.fault)) if name in heard else one for name, one in said.items()}


def at_its_plug(fault: Fault | None) -> Fault | None:
    """Of who was heard before: not that its link may be wrong."""
    wrong = fault is not None and any(remedy in fault.remedy for remedy in NOT_HEARD)
    return replace(fault, remedy=PLUG) if fault is not None and wrong else fault


def named_before(fault: Fault | None, heard: Collection[str]) -> Fault | None:
    """The same of a run's, where it names one that was `heard` in this window."""
    return at_its_plug(fault) if fault is not None and any(name in fault.text for name in heard) else fault


def wrong(known: state.LabState | None, facts: Bench | None) -> tuple[str, ...]:
    """Who is to be read again: coils that are not known to be at zero, what has failed, a platform that may turn."""
    if known is None or facts is None:
        return ()
    on = {"coil-x", "coil-y", "coil-z"} if not all(coil.zero for coil in known.coils) else set[str]()  # at one moment
    turns = {"platform"} if known.platform is not None and known.platform.moving is not False else set[str]()
    failed = {one.name for one in known.instruments if one.fault}
    return tuple(name for name, one in facts.instruments.items() if one.role in on | turns or name in failed)


def blamed(known: state.LabState | None, fault: Fault, facts: Bench | None) -> state.LabState | None:
    """Instruments that a run failed over are shown so until they are heard again; None where it says that of nobody.

    A witness has not failed; a limit that is not met may name an instrument, and says nothing against it.
    """
    if facts is None or fault.kind != "instrument" or fault.text.startswith(state.NOT_BY_REFERENCE):
        return None
    before = known or state.LabState(state.unread())
    heard = {one.name: one for one in before.instruments}
    said = fault.text if any(words in fault.text for words in NO_REPLY) else translated("failed")
    for name in facts.instruments:
        if name in fault.text:
            heard[name] = replace(heard.get(name) or state.Heard(name), fault=said)
    return replace(before, instruments=tuple(heard.values()))
