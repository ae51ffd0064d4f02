"""What may be said of the lab now: from the one state that a worker sent, with its age, and nothing else."""

from __future__ import annotations

import math
import re
import time
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.bench.coils import state
from labcal.gui.ipc.answers import Bench
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.guardian import GUARDIAN
from labcal.gui.viewmodels.in_brief import in_brief
from labcal.gui.viewmodels.raw_reply import plainly

Light = Literal["ok", "old", "waiting", "fault", "absent"]
Lights = tuple[tuple[str, Light, str], ...]  # instrument, light, words
LIGHT_SHAPES = {  # shape, state, words where there are no better ones
    "ok": ("✓", "good", "answers"),
    "old": ("◌", "old", "heard before"),
    "waiting": ("…", "", "not heard yet"),
    "fault": ("✕", "bad", "failed"),
    "absent": ("○", "", "not asked"),
}
SILENT = QT_TRANSLATE_NOOP("Words", "no answer (plug? power?)")  # nobody can tell which: both are looked at
LOST = QT_TRANSLATE_NOOP("Words", "no answer (link lost)")
HEARD = QT_TRANSLATE_NOOP("Words", "heard {0}")
# in a fault: one state, however who asked puts it
UNHEARD = ("silent", "no reply", "no sample", "nothing came", "no valid Modbus reply")
BY_KEY = QT_TRANSLATE_NOOP(
    "Words",
    "press COILS OFF (F12) first: it stops the platform too, if it can be reached. If it keeps turning, stop it at its "
    "controller",
)
TOLD = QT_TRANSLATE_NOOP(
    "Words", "COILS OFF was pressed, and stops it if it can be reached. If it keeps turning, stop it at its controller"
)
STOP_UNSEEN = QT_TRANSLATE_NOOP("Words", "the platform was ordered to stop, and is not seen to stand yet")
LOOK_S, LONGEST_ANSWER_S = 2, 2  # at rest: from one look to the next (coils are looked at more often), and its answer
WATCHED_S = LOOK_S + LONGEST_ANSWER_S  # whole seconds: so old may be what lets hands in, with its age; then it is amber
HOMES_S = 10  # so long a platform that a run turns may look for its zero unread
LONG_AGO_S = 1800  # a zero that was read longer ago is to be read again before anybody relies on it
CURRENT, PLACES = re.compile(r"[+-]\d+\.\d+(?= A\b)"), 3
OFF = "off"  # the state of what keeps hands off where nothing is known to be wrong; where something is, it is "bad"
TELLERS = ("coil-", "polarity", "reference", "platform")  # roles that tell how coils and platform are
WITH_COILS = ("polarity", "interlock")  # heard by a run whenever the coils are
TEXTS = (
    QT_TRANSLATE_NOOP("Words", "heard before"),
    QT_TRANSLATE_NOOP("Words", "{0} s ago"),
    QT_TRANSLATE_NOOP("Words", "{0} min ago"),
    QT_TRANSLATE_NOOP("Words", "{0} h ago"),
    QT_TRANSLATE_NOOP("Words", "changing"),
    QT_TRANSLATE_NOOP("Words", "no answer"),
    QT_TRANSLATE_NOOP("Words", "not read in this step"),
    QT_TRANSLATE_NOOP("Words", "not read yet"),
    QT_TRANSLATE_NOOP("Words", "lost"),
    QT_TRANSLATE_NOOP("Words", "failed"),
    QT_TRANSLATE_NOOP("Words", "COILS OFF done {0}: {1}"),
    QT_TRANSLATE_NOOP("Words", "stop it at its controller, and see it stand"),
    BY_KEY,
    STOP_UNSEEN,
    QT_TRANSLATE_NOOP("Words", "platform turning"),
    QT_TRANSLATE_NOOP("Words", "platform may turn"),
)


@dataclass(frozen=True, slots=True)
class LabNow:
    """Parts of the state received, at one moment; `…_old_s`: whole seconds since that was read, None where fresh.

    Currents [A] and fields [nT] that are not known are None.
    """

    coil_A: tuple[float | None, ...] = (None, None, None)  # x, y, z
    coil_old_s: int | None = None
    coil_words: str = ""
    begun_s: tuple[int, int, int] = (0, 0, 0)  # how old coils, platform and reference are, in seconds that have begun
    others_by_s: float = WATCHED_S  # so old may platform and reference be at rest that let hands in
    coils_late: bool = False  # at rest: the next look at them was not answered in time
    coils_at_zero: bool | None = None
    alone: str = ""  # why a zero rests on the supplies' word alone; "" where the reference has seen it
    reference_agreed: bool = False  # when it was looked at last
    reference_old_s: int | None = None
    silent_with_current: str = ""  # supplies that are not read any more, with the current that they had
    driven: bool = False  # by a run of this window
    as_set: bool = False  # every coil that is on was set so by whoever drives it, and is read
    in_common: str = ""  # what to look at first where several instruments are silent
    platform_words: str = ""
    platform_deg: float | None = None  # as it was read last; None where it is not known
    platform_old_s: int | None = None
    stop_unseen: bool = False  # it was told to stop, and nobody has seen it stand since
    left_turning: bool = False  # so it was read last, and no run of this window stops it
    left_unseen: bool = False  # likewise, where nobody has seen it stand
    field_set_nT: state.Vector | None = None
    field_measured_nT: state.Vector | None = None
    field_old_s: int | None = None
    field_why: str = ""  # none was measured, in words
    field_changing: bool = False  # the coils are on their way
    field_more_nT: state.Vector | None = None  # than with the coils off, where that tells of a coil
    field_more_old_s: int = 0
    field_more_before_off: bool = False  # that was read before zero was ordered
    lights: Lights = ()
    heard_old_s: tuple[tuple[str, int | None], ...] = ()  # by instrument, of those that were heard
    heard_at_s: tuple[tuple[str, float], ...] = ()  # likewise, by the computer's monotonic clock
    silent_tellers: tuple[str, ...] = ()  # of those that tell how coils and platform are, who gives no answer now
    coils_lost: bool = False  # a supply gives no answer now, whatever it said before
    platform_lost: bool = False
    unread_since: str = ""  # by the clock on the wall: nobody has been at the window for long, and nobody reads
    left_by: str = ""  # the DUT of the last run on this bench, where nobody has ended that
    driven_elsewhere: bool = False  # that run goes on in another process
    earlier_on: str = ""  # a supply of an earlier session that answers and is not at zero, in words
    closed_with: str = ""  # what was not confirmed when a window closed, and was not read since

    @property
    def failed(self) -> list[str]:
        """Whose light is red, as they are called here."""
        return [shown_name(name) for name, light, _ in self.lights if light == "fault"]

    @property
    def to_be_mended(self) -> bool:
        """An instrument is silent, or the coils are not confirmed: that comes before going on with anything."""
        return bool(self.failed) or mark_of(self.coil_words)[1] == "bad"

    @property
    def at_rest(self) -> bool:
        """No run goes on, and the coils were read not long ago."""
        return not self.driven and (self.coil_old_s or 0) < LONG_AGO_S


NOT_TOLD = LabNow()


def shown_name(name: str) -> str:
    """What an instrument is called by the bench file; the guardian, of which none speaks, in the window's language."""
    return translated(name) if name == GUARDIAN else name


def lab_now(
    lab: state.LabState | None,
    received_s: float,
    roles: Mapping[str, str],
    now_s: float,
    *,
    driven: bool = False,
    contacts_heard: bool = True,
    coils_by_s: float = math.inf,
) -> LabNow:
    """The state `lab` at `received_s`, as it is at `now_s`; `roles` by instrument, in the order to be shown in.

    `driven`: by a run of this window. `contacts_heard`: whoever read the coils heard their contacts, as a run does.
    `coils_by_s`: how old their reading may become where nobody drives them, for they are read again sooner.
    """
    if lab is None:
        return LabNow(driven=driven, lights=tuple((name, "absent", "") for name in roles))
    known = any(coil.current_A is not None for coil in lab.coils)
    at_zero = all(coil.zero for coil in lab.coils)
    seen_nT, seen_s = _field_seen(lab)
    silent = {one.name for one in lab.instruments if one.fault}
    lost = {roles.get(name, "") for name in silent}
    coils_lost = any(role.startswith("coil-") for role in lost)
    return LabNow(
        coil_A=_currents(lab, lost),
        coil_old_s=old_s(now_s - lab.age_s(now_s), now_s) if known else None,
        coil_words=in_places(lab.sentence(now_s, time.time() - time.monotonic() + now_s, lost=coils_lost)),
        begun_s=(
            _begun_s(lab.age_s(now_s) if known else None),
            _begun_s(None if lab.platform is None or lab.platform.read_s is None else now_s - lab.platform.read_s),
            _begun_s(None if lab.reference.read_s is None else now_s - lab.reference.read_s),
        ),
        coils_late=known and not driven and lab.age_s(now_s) > coils_by_s,
        coils_at_zero=lab.at_zero(now_s),
        alone="" if lab.sentence(now_s) == state.AT_ZERO else lab.why_alone(now_s),
        reference_agreed=lab.reference.verdict == "agrees",
        reference_old_s=old_s(lab.reference.read_s, now_s),
        driven=driven,
        as_set=not at_zero and all(coil.zero or (coil.set_A and coil.current_A is not None) for coil in lab.coils),
        platform_words=_platform_words(lab, now_s, driven=driven, lost="platform" in lost),
        platform_deg=None if lab.platform is None else lab.platform.angle_deg,
        platform_old_s=None if lab.platform is None else old_s(lab.platform.read_s, now_s),
        field_set_nT=lab.field.set_nT if known and not at_zero else None,
        field_measured_nT=seen_nT,
        field_old_s=old_s(seen_s, now_s),
        field_why="" if seen_nT is not None else _field_why(lab, roles, driven=driven),
        field_changing=driven and lab.field.changing and old_s(seen_s, now_s) is None,
        lights=_lights(lab, received_s, roles, now_s, contacts_heard=contacts_heard),
        heard_old_s=tuple((one.name, old_s(one.heard_s, now_s)) for one in lab.instruments),
        silent_tellers=tuple(n for n, role in roles.items() if role.startswith(TELLERS) and n in silent),
        coils_lost=coils_lost,
        platform_lost="platform" in lost,
    )


def _begun_s(age_s: float | None) -> int:
    """An age is never said shorter than it is; 0 where nothing was read."""
    return 0 if age_s is None or not math.isfinite(age_s) else max(1, math.ceil(age_s))


def in_places(coil_words: str) -> str:
    """The same with each current in the places that the panel has."""
    return CURRENT.sub(lambda found: f"{float(found[0]):+.{PLACES}f}", coil_words)


def _currents(lab: state.LabState, lost: set[str]) -> tuple[float | None, float | None, float | None]:
    """Of the coils x, y, z, each by its name [A]; none of one whose supply does not answer, whatever it said before."""
    flows = {coil.axis: coil.current_A for coil in lab.coils if not coil.fault and f"coil-{coil.axis}" not in lost}
    return flows.get("x"), flows.get("y"), flows.get("z")


def _field_seen(lab: state.LabState) -> tuple[state.Vector | None, float | None]:
    """What the reference saw last, and when: where nothing came since it agreed, the reading by which it did."""
    field, agreed = lab.field, lab.reference
    if agreed.verdict != "agrees" or agreed.seen_nT is None or agreed.read_s is None:
        return field.seen_nT, field.read_s
    if all(coil.current_A is not None for coil in lab.coils) and (field.read_s or agreed.read_s) <= agreed.read_s:
        return agreed.seen_nT, agreed.read_s
    return field.seen_nT, field.read_s


def _platform_words(lab: state.LabState, now_s: float, *, driven: bool, lost: bool) -> str:
    """One that a run of this window turns is not read while it looks for its zero: it turns, which alarms nobody.

    It turns still for all that is known, but no longer where it was read. That one which is `lost` stood, nobody knows.
    """
    if lost and (lab.platform is None or not lab.platform.moving):
        return state.MAY_TURN
    turns = driven and lab.platform is not None and lab.platform.moving is True
    read_s = lab.platform.read_s if turns and lab.platform is not None else None
    age_s = 0.0 if read_s is None else now_s - read_s
    if read_s is None or age_s > HOMES_S:
        return lab.platform_sentence(now_s)
    said = lab.platform_sentence(min(now_s, read_s))
    return f"{said}, read {state.ago(age_s)}" if age_s > state.FRESH_S else said


def _field_why(lab: state.LabState, roles: Mapping[str, str], *, driven: bool) -> str:
    """Why no measured field is shown, where there is a reference: "answers" beside a dash would be a riddle."""
    name = next((name for name, role in roles.items() if role == "reference"), "")
    heard = next((one for one in lab.instruments if one.name == name), None)
    if not name or lab.field.changing or heard is None:
        return ""
    if heard.fault:
        return translated("no answer")
    return translated("not read in this step" if driven else "not read yet")


def age_words(old_s: int | None) -> str:
    """In words: 12 s ago, 3 min ago, 2 h ago; nothing of what is fresh."""
    if old_s is None:
        return ""
    if old_s < 120:
        return translated("{0} s ago").format(old_s)
    return translated("{0} min ago" if old_s < 7200 else "{0} h ago").format(old_s // (60 if old_s < 7200 else 3600))


def field_age(now: LabNow) -> str:
    """Of the measured field: what is seen while the coils are on their way is no settled value, however fresh."""
    return translated("changing") if now.field_changing else now.field_why or age_words(now.field_old_s)


def mark_of(coil_words: str, *, at_rest: bool = False) -> tuple[str, str]:
    """Shape and state that go with what is said of the coils: all clear only where a reference has seen it.

    That they were at zero when they were read last alarms nobody while the lab is `at_rest`.
    """
    if not coil_words:
        return "", ""
    if coil_words == state.AT_ZERO:
        return "✓", "good"
    if at_rest and coil_words.startswith((state.WAS_ZERO, state.WAS_ZERO_BY_WORD)):
        return "◌", "old"
    if coil_words.startswith(state.BY_WORD):
        return "■", ""  # at zero as far as anybody can tell: no alarm, and no all clear
    bad = coil_words.startswith((state.NOT_BY_REFERENCE, state.NOT_CONFIRMED))
    return ("✕", "bad") if bad else ("●", OFF if coil_words.startswith(state.ON) else "warning")


def platform_mark(words: str, coil_words: str = "") -> tuple[str, str]:
    """Shape and state that go with what is said of the platform: keep off where it turns, or may.

    That it stands is no tick while the coils are on: in a ramp nothing that is ticked may be taken for the field.
    """
    if not words:
        return "", ""
    if words.startswith(state.MAY_TURN):
        return "✕", "bad"
    if words.startswith("platform turns"):
        return "●", "warning"
    if "," in words:
        return "◌", "old"
    return ("■", "") if coil_words.startswith(state.ON) else ("✓", "good")


def off_words(coils: str, platform_words: str, at: str, *, later: bool = False) -> str:
    """One sentence after COILS OFF that reached zero: `at` what time, what was read back, whether the platform stands.

    `later`: it was told to stop, and is looked at again.
    """
    stands = translated(str(STOP_UNSEEN)) if later else ""
    said = translated("COILS OFF done {0}: {1}").format(at, coils)
    return "; ".join(filter(None, (said, stands or platform_said(platform_words, told=True))))


def platform_said(words: str, *, told: bool = False) -> str:
    """In the window's language; where it turns, or may, with what to do. `told`: COILS OFF was pressed just now."""
    if platform_mark(words)[1] not in ("bad", "warning"):
        return in_words(words)
    heard = words != state.MAY_TURN  # its line answers, or did not long ago: nobody has to go to it first
    stop = str(TOLD) if heard and told else str(BY_KEY) if heard else "stop it at its controller, and see it stand"
    return f"{in_words(words)}: {translated(stop)}"


def platform_drawn(words: str, coil_words: str = "") -> tuple[str, str]:
    """As `platform_mark`, which is the rule; an angle that is not fresh is drawn grey, as every other value.

    One that turns is drawn in the red of "Hands off": amber would be that hands may go in.
    """
    if not words.startswith("platform turns"):
        return platform_mark(words, coil_words)
    return ("◌", "old") if ", read " in words else ("●", OFF)


def alarm_of(coil_words: str) -> str:
    """Short, where the coils are not at zero though they were to be: nothing goes on as it was planned; else ""."""
    shape, mark = mark_of(coil_words)
    return f"{shape} {in_words(in_brief(coil_words))}" if mark == "bad" else ""


def old_s(read_s: float | None, now_s: float) -> int | None:
    """Whole seconds since `read_s`; None where that is fresh, or unknown."""
    old = read_s is not None and now_s - read_s > state.FRESH_S
    return int(now_s - read_s) if old and read_s is not None else None


def _lights(
    lab: state.LabState, received_s: float, roles: Mapping[str, str], now_s: float, *, contacts_heard: bool
) -> Lights:
    heard = {one.name: one for one in lab.instruments}
    coils_s = min((c.read_s for c in lab.coils if c.read_s is not None and contacts_heard), default=None)
    lights = [_light(name, role, heard.get(name), coils_s, now_s) for name, role in roles.items()]
    if lab.guardian is not None:
        one = state.Heard(GUARDIAN, received_s, "" if lab.guardian else translated("lost"))
        lights.append(_light(GUARDIAN, "", one, None, now_s))
    return tuple(lights)


def _light(
    name: str, role: str, heard: state.Heard | None, coils_s: float | None, now_s: float
) -> tuple[str, Light, str]:
    heard_s = None if heard is None else heard.heard_s
    if heard_s is None and role.startswith(WITH_COILS):
        heard_s = coils_s
    words = age_words(old_s(heard_s, now_s))
    if heard is not None and heard.fault:
        return name, "fault", ", ".join(filter(None, (_no_answer(heard.fault), words and _heard(words))))
    if heard_s is None:
        return name, "absent" if heard is None else "waiting", ""
    return name, "old" if words else "ok", words


def _no_answer(fault: str) -> str:
    """The one word for it; how it was found stands in the card and in the record. What failed otherwise says how."""
    if any(one in fault for one in UNHEARD):
        return translated(str(SILENT))
    if "link lost" in fault or "the link was lost" in fault:
        return translated(str(LOST))
    return in_words(plainly(fault).partition(": ")[2] if plainly(fault) != fault else fault)


def _heard(age: str) -> str:
    return translated(str(HEARD)).format(age)


def reference_U(facts: Bench | None, measured: state.Vector | None) -> float | None:
    """Of the reference, k = 2, from what the bench file states."""
    said = None if facts is None else facts.reference
    if measured is None or said is None or said.u_offset_nT is None:
        return None
    size = sum(v * v for v in measured) ** 0.5
    return 2.0 * float((said.u_offset_nT**2 + (size * 1e-6 * (said.u_scale_ppm or 0.0)) ** 2) ** 0.5)
