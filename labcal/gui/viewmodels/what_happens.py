"""What happens now, in one line to be read from the cage. No widgets."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.bench.coils import state
from labcal.bench.coils.agreement import CHANGED
from labcal.gui.ipc.bench_facts import Bench
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.failed_step import SHOWN
from labcal.gui.viewmodels.field_witness import field_says, still_live
from labcal.gui.viewmodels.hands import FAILED, READY, RETRY, coming
from labcal.gui.viewmodels.hands_now import MAY, hands_of
from labcal.gui.viewmodels.lab_now import OFF, WATCHED_S, LabNow, alarm_of, platform_drawn, platform_mark
from labcal.gui.viewmodels.number_format import step_title
from labcal.gui.viewmodels.pace import faster_than_life
from labcal.gui.viewmodels.run import RunViewModel
from labcal.gui.viewmodels.run_steps import kind_of
from labcal.record.endings import STOPPED, ended_word

COMES_BACK = QT_TRANSLATE_NOOP("Words", "A run goes on: the coils may be on. Hands off.")
WORDS = {
    "starting": QT_TRANSLATE_NOOP("Words", "Starting"),
    "stopping": QT_TRANSLATE_NOOP("Words", "Stopping"),
    "paused": QT_TRANSLATE_NOOP("Words", "Paused"),
}
HANDS_OFF = QT_TRANSLATE_NOOP("Words", "Hands off")
SIMULATED_S = QT_TRANSLATE_NOOP("Words", "{0} s simulated")
LIVE = QT_TRANSLATE_NOOP("Words", "HANDS OFF – no answer from {0}; {1}")
KEEP_OFF = QT_TRANSLATE_NOOP("Words", "HANDS OFF – {0}")
KEEP, OUT = QT_TRANSLATE_NOOP("Words", "HANDS OFF"), QT_TRANSLATE_NOOP("Words", "▲ Hands off")
OUT_NOW = QT_TRANSLATE_NOOP("Words", "▲ Hands off: {0}")
NEXT = QT_TRANSLATE_NOOP("Words", "the field and the platform come next")
COMES = QT_TRANSLATE_NOOP("Words", "the next field or turn comes unasked")
TURNS = QT_TRANSLATE_NOOP("Words", "the platform turns next")
GOING = QT_TRANSLATE_NOOP("Words", "COILS OFF: the run stops …")
STOPS = QT_TRANSLATE_NOOP("Words", "stopping")
BREAKS = QT_TRANSLATE_NOOP("Words", "the step is broken off")
BEGINS = QT_TRANSLATE_NOOP("Words", "the run begins")
GOES_ON = QT_TRANSLATE_NOOP("Words", "the run goes on")
WRONG = "✕ "  # before what keeps hands off and was not planned
DIAL = "angle_deg"  # in a prompt's drawing: to which a person turns the platform
ENDED = QT_TRANSLATE_NOOP("Words", "{0}: no answer from {1}")


def what_happens(run: RunViewModel, now: LabNow, *, alarmed: bool = False) -> str:
    """Of `run` with the lab as it is `now`; `alarmed`: a card above says that the coils may be on, which is enough."""
    if run.state == "ended":
        return _how_it_ended(run, now)
    if run.unheard:
        return translated(str(COMES_BACK))
    if run.state in WORDS:
        doing = translated(str(WORDS[run.state]))
        live = still_live(now)
        as_ordered = not (now.failed or alarm_of(now.coil_words))
        if run.by_off and run.state == "stopping" and as_ordered:  # one sentence, until it has ended
            return translated(str(KEEP_OFF)).format(translated(str(GOING)))
        return f"{_of_who_is_lost(now) or translated(str(KEEP_OFF)).format(live)} · {doing}" if live else doing
    return "" if alarmed else _of_who_is_lost(now) or _doing(run, now)


def is_alarm(words: str) -> bool:
    """Whether that is about hands that have to be off for something that is on, turns or is known to be wrong."""
    begins = (translated(str(one)).partition("{0}")[0] for one in (LIVE, KEEP_OFF))
    return words.removeprefix(WRONG).startswith(tuple(begins))


def headline_state(words: str) -> str:
    """The state of hands that goes with it: off in a turn as it was planned too; "" where it says nothing of hands."""
    if is_alarm(words):
        return "bad"
    return OFF if words.startswith((translated(str(HANDS_OFF)), translated(str(COMES_BACK)))) else ""


def is_wrong(run: RunViewModel, now: LabNow) -> bool:
    """Whether hands have to be off for what nobody planned: else a run does as it was told to."""
    unasked = now.coil_words.startswith(state.ON) or platform_mark(now.platform_words)[1] == "warning"
    unasked = unasked and not (run.alive or now.driven_elsewhere)
    left = now.closed_with or now.earlier_on or now.stop_unseen or (now.left_by and not now.driven_elsewhere)
    known = alarm_of(now.coil_words) or platform_mark(now.platform_words)[1] == "bad" or now.failed or field_says(now)
    return bool(unasked or left or known or now.coils_lost or now.platform_lost)


def _off(run: RunViewModel, now: LabNow) -> tuple[str, str]:
    """In the same red either way; what is wrong is told from a turn that was planned by its shape, and by its card."""
    return (WRONG if is_wrong(run, now) else "") + translated(str(KEEP)), "bad"


def keep_off_words() -> tuple[str, ...]:
    """All that the heading may say."""
    return WRONG + translated(str(KEEP)), translated(str(KEEP)), translated(str(OUT))


def at_rest(now: LabNow) -> bool:
    """Whether coils at zero and a platform that stands were read just now: then nobody has to keep off."""
    return now.coils_at_zero is True and platform_mark(now.platform_words)[1] in ("", "good")


def keep_off(run: RunViewModel, now: LabNow) -> tuple[str, str]:
    """The heading over every page, and its state: while anything is on, may be, or is promised to come on; else ""."""
    unknown = now.coil_words in (state.NOT_SINCE, state.NOT_YET) and not begins(run, now)
    promised = run.hands_off and run.state not in ("asking", "paused")  # until anything is asked
    measures = run.alive and (promised or run.segment is not None)
    if still_live(now) or unknown or measures:
        return _off(run, now)
    left = now.left_by or now.closed_with
    told = bool(now.coil_words or left or now.coils_lost or now.platform_lost)  # else there is no lab
    known = replace(now, coil_words=state.NOT_READ) if begins(run, now) else now
    mark = hands_of(known)[1] if told or run.alive else "good"
    if mark == "bad":  # in a run or at rest: a reason is known
        return _off(run, now)
    out = asked_out(run, now) or _just_begins(run) or _goes_on(run) or mark not in MAY
    return (translated(str(OUT)), OFF) if out else ("", "")


def begins(run: RunViewModel, now: LabNow) -> bool:
    """Whether a run of this window has not read the coils yet: it energises nothing before. Else nobody knows."""
    unread = now.coil_words in ("", state.NOT_READ, state.NOT_YET)
    return run.alive and run.unread and not run.unheard and unread and not (now.left_by or now.closed_with)


def _just_begins(run: RunViewModel) -> bool:
    """From the click until the run has read the coils and has a step: a first start as one that goes on."""
    return run.alive and (run.unread or run.state == "starting")


def _goes_on(run: RunViewModel) -> bool:
    """Whether it does something and nobody is asked: no time to reach in, though nothing comes on before a question."""
    return run.alive and run.state == "running"


def asked_out(run: RunViewModel, now: LabNow) -> str:
    """While it is asked whether all hands are off, they are not told to go in: they go out now, and for what; else "".

    Who does not answer is seen to first.
    """
    if run.state != "asking" or run.prompt is None or now.failed:
        return ""
    if run.prompt.key.startswith(FAILED) and RETRY in run.prompt.choices:
        return translated(str(OUT_NOW)).format(translated(str(NEXT)))
    if run.prompt.key != READY:
        return ""
    asked = in_words(run.prompt.text)
    what = asked.rpartition(". ")[0] or asked  # without "Hands off?"
    return translated(str(OUT_NOW)).format(coming(run.prompt, what))


def kept_out(run: RunViewModel, now: LabNow) -> tuple[str, str, bool]:
    """What stands in place of an order to reach in, its state, and whether its answer waits for the lab; else "".

    A dial is turned with the coils on. Of others it waits for what is on, turns or is silent: not for currents that the
    run has set, nor for what no supply and no platform owns to, or nobody reads any more of a simulated lab. None
    stands for ever.
    """
    words, mark = keep_off(run, now)
    ready = run.prompt is not None and run.prompt.key == READY
    if ready and now.failed and mark != "bad":
        return translated(str(SHOWN)).format(", ".join(now.failed)), "bad", False
    may_turn = now.platform_words.startswith(state.MAY_TURN) and not run.virtual_time
    if ready and may_turn and not now.failed:  # its line is back, and nobody has seen it stand yet
        return f"✕ {in_words(state.MAY_TURN)}", "bad", True
    sends = run.prompt is not None and run.prompt.acts and run.prompt.key != READY and DIAL not in run.prompt.drawing
    if not sends or now.coil_words in ("", state.NOT_YET):
        return "", "", False
    by_field = now.coil_words.startswith(state.NOT_BY_REFERENCE) or CHANGED in now.coil_words
    rests = by_field and platform_mark(now.platform_words)[1] in ("", "good")
    past = run.virtual_time and max(now.coil_old_s or 0, now.platform_old_s or 0) > WATCHED_S
    return words, mark, mark == "bad" and not (rests or past or now.as_set)


def at_hands(run: RunViewModel, now: LabNow, facts: Bench | None) -> dict[str, tuple[str, str]]:
    """For the frame: `keep_off`, and below the coils `hands`, where there is a lab that hands can be put into."""
    there = facts is not None or bool(now.closed_with)
    return {"keep_off": keep_off(run, now), "hands": hands_at(run, now) if there else ("", "")}


def in_shape(words: str, heading: str) -> str:
    """A no in `words` with the sign of the `heading` over every page: one state has one sign, wherever it is said."""
    quiet = translated(str(OUT)).partition(" ")[0] + " "
    loud = bool(words) and translated(str(KEEP)) in heading
    return heading.partition(translated(str(KEEP)))[0] + words.removeprefix(quiet) if loud else words


def hands_at(run: RunViewModel, now: LabNow) -> tuple[str, str]:
    """Whether they may go in, and why not, with the sign that the heading has."""
    words, mark = _hands_at(run, now)
    return (words if mark in MAY else in_shape(words, keep_off(run, now)[0])), mark


def _hands_at(run: RunViewModel, now: LabNow) -> tuple[str, str]:
    """What is known first, then what comes unasked."""
    promised = run.hands_off and run.state not in ("asking", "paused")
    words, mark = hands_of(replace(now, coil_words=state.NOT_READ) if begins(run, now) else now)
    if mark != "bad" and run.alive and (promised or run.segment is not None):
        return translated(str(OUT_NOW)).format(translated(str(_what_comes(run, now)))), "bad"
    if mark != "bad" and _just_begins(run):  # what was read before it says nothing of what it does
        return translated(str(OUT_NOW)).format(translated(str(BEGINS))), OFF
    if mark in MAY and _goes_on(run):
        return translated(str(OUT_NOW)).format(translated(str(GOES_ON))), OFF
    if mark in MAY and (out := asked_out(run, now)):
        return out, OFF
    return words, mark


def _what_comes(run: RunViewModel, now: LabNow) -> str:
    """Nothing, where the run or its step breaks off; else a turn, where the step is one, or what nobody asks about."""
    if run.state == "stopping":
        return str(STOPS)
    if run.time.failed or now.failed:
        return str(BREAKS)
    return str(TURNS if run.step is not None and kind_of(run.step.name) == "turn" and _is_there(now) else COMES)


def _is_there(now: LabNow) -> bool:
    """Whether there is a platform that stands: one without a motor a person turns."""
    return bool(now.platform_words) and platform_mark(now.platform_words)[1] in ("", "good")


def _how_it_ended(run: RunViewModel, now: LabNow) -> str:
    word = ended_word(run.status, stopped=run.fault is not None and run.fault.kind == "stopped")
    shape = {"finished": "✓", STOPPED: "■"}.get(word, "✕")
    ended = f"{shape} {translated(word).capitalize()}"
    if shape == "✕" and not now.driven and alarm_of(now.coil_words):  # graver than who did not answer
        return WRONG + translated(str(KEEP_OFF)).format(still_live(now))
    lost = now.failed if shape == "✕" else []
    return translated(str(ENDED)).format(ended, ", ".join(lost)) if lost else ended


def _of_who_is_lost(now: LabNow) -> str:
    """Nobody is sent to a plug before coils and platform rest; who is lost or not, what is not confirmed keeps off."""
    lost, live = ", ".join(now.failed), still_live(now)
    if not lost:
        sure = alarm_of(now.coil_words) or platform_mark(now.platform_words)[1] == "bad"
        return WRONG + translated(str(KEEP_OFF)).format(live) if live and sure else ""
    return WRONG + translated(str(LIVE)).format(lost, live) if live else translated(str(SHOWN)).format(lost)


def _doing(run: RunViewModel, now: LabNow) -> str:
    """The step, and "Hands off" as long as something is on, turns, may do so unasked, or is being measured.

    Between two questions nothing is: who goes on mounting is not called away.
    """
    if platform_drawn(now.platform_words)[1] == "old" and platform_mark(now.platform_words)[1] == "warning":
        return " · ".join((translated(str(HANDS_OFF)), in_words(now.platform_words)))  # its line is silent
    doing = step_title(run.segment) if run.segment else step_title(run.step.name) if run.step else ""
    if not run.segment and not run.hands_off and at_rest(now):
        return doing
    left = None if run.time.failed else run.step_left_s()
    asks = (needed := run.needed_s()) is not None and needed < 1.0
    seconds = translated(str(SIMULATED_S)) if faster_than_life(run.order, run.virtual_time) else "{0} s"
    wait = (
        seconds.format(f"{left:.0f}") if left and left >= 1.0 and not asks else ""
    )  # nothing is promised of a person, nor too late
    return " · ".join(part for part in (translated(str(HANDS_OFF)), wait, doing) if part)
