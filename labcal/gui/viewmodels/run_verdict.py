"""How a run came out, in one word, with the rule by which it was decided and what is to be done next."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import dataclass

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.theming.theme import STATES
from labcal.gui.translations.punctuation import listed_apart
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.axis_checks import WORST
from labcal.gui.viewmodels.delays_left import delay_words
from labcal.gui.viewmodels.number_format import decimals_for, format_number, short_number, step_title
from labcal.gui.viewmodels.procedure_groups import calibrates
from labcal.gui.viewmodels.run import RunViewModel
from labcal.gui.viewmodels.run_steps import name_a_turn
from labcal.record.endings import ended_word
from labcal.record.stream import Measurement

ENDS = {"stopped": ("■", "warning"), "interrupted": ("▲", "warning"), "failed": ("✕", "bad")}
NEXT = {
    "PASS": QT_TRANSLATE_NOOP("Words", "Fit, Loop, Certificate: Next leads there."),
    "one axis": QT_TRANSLATE_NOOP(
        "Words", "One axis: not enough for a calibration by itself. Measure the others too, or a preflight."
    ),
    "no calibration": QT_TRANSLATE_NOOP("Words", "No calibration of a DUT comes of this procedure. Next leads on."),
    "MARGINAL": QT_TRANSLATE_NOOP("Words", "Within U of its limit: measure that part again, or Fit and see."),
    "CANNOT DECIDE": QT_TRANSLATE_NOOP(
        "Words", "Fit, and trace what is left over. Still open then? Measure longer, or with less noise."
    ),
    "FAIL": QT_TRANSLATE_NOOP("Words", "Look at what was measured, mend the cause, and measure again."),
    "": QT_TRANSLATE_NOOP("Words", "Nothing of it had a limit: look at what was measured."),
    "stopped": QT_TRANSLATE_NOOP("Words", "What was measured is kept. To measure again: Close, then Begin."),
    "interrupted": QT_TRANSLATE_NOOP(
        "Words",
        "Finished turns are kept; Go on measures the zero, the axes and the timing again, then what is missing.",
    ),
    "lost": QT_TRANSLATE_NOOP(
        "Words",
        "Mend what is said above, then Go on: finished turns are kept; the zero, the axes, the timing and the step "
        "that broke off are measured again.",
    ),
    "lost, not begun": QT_TRANSLATE_NOOP("Words", "Mend what is said above, then Go on."),
    "interrupted, no turn": QT_TRANSLATE_NOOP(
        "Words", "No turn was finished: Go on begins with the first step again, and uses nothing of what was measured."
    ),
    "lost, no turn": QT_TRANSLATE_NOOP(
        "Words",
        "Mend what is said above, then Go on: no turn was finished, so it begins with the first step again, and uses "
        "nothing of what was measured.",
    ),
    "interrupted, not begun": QT_TRANSLATE_NOOP("Words", "Nothing was measured: Go on begins with the first step."),
    "mended": QT_TRANSLATE_NOOP("Words", "To measure again: Close, then Begin."),
    "failed": QT_TRANSLATE_NOOP("Words", "Mend what is said above, then measure again: Close, then Begin."),
}
TEXTS = (
    QT_TRANSLATE_NOOP(
        "Words",
        "PASS of the measurement: |value| + U (k=2) is within its limit ({0} of {0}).",
    ),
    QT_TRANSLATE_NOOP("Words", "FAIL where |value| − U (k=2) is beyond the limit: {0}."),
    QT_TRANSLATE_NOOP("Words", "MARGINAL where the limit lies within ± U (k=2): {0}."),
    QT_TRANSLATE_NOOP("Words", "CANNOT DECIDE where U (k=2) exceeds half the limit: {0}."),
    QT_TRANSLATE_NOOP("Words", "It did not come to its end, so it has no verdict, and gives no calibration."),
    QT_TRANSLATE_NOOP("Words", "DONE"),
    QT_TRANSLATE_NOOP("Words", "Not measured: {0}."),
    QT_TRANSLATE_NOOP("Words", "{0}, without {1}"),
    QT_TRANSLATE_NOOP("Words", "NOT MEASURED"),
    QT_TRANSLATE_NOOP("Words", "Nothing was measured, so this says nothing of the DUT."),
    QT_TRANSLATE_NOOP(
        "Words", "It cannot be gone on with: a result of {0} is worked out from one recording without a gap."
    ),
)
DELAY = QT_TRANSLATE_NOOP(
    "Words",
    "The delay is how late the DUT reads behind the platform's angle. It comes of turns there and back about one "
    "axis without a break between; after Go on too few of those are left. To get it: sync-check, or a new preflight.",
)
NOT_MEASURED, WITHOUT, NOTHING, NOTHING_OF = 6, 7, 8, 9
JUDGED = QT_TRANSLATE_NOOP("Words", "How good the calibration is, Fit and Loop judge.")
RULES = dict(zip(("PASS", "FAIL", "MARGINAL", "CANNOT DECIDE"), map(str, TEXTS), strict=False))


@dataclass(frozen=True, slots=True)
class RunVerdict:
    """`state` colours the word: good, warning or bad."""

    word: str
    state: str
    rule: str
    next: str


def run_verdict(
    run: RunViewModel, resumable: Collection[str] = (), *, mended: bool = False, elsewhere: str = ""
) -> RunVerdict:
    """Of a run that has ended: the worst of its measurements that have limits; none where it did not finish.

    `resumable`: the procedures that may be gone on with, none before they are listed; of another, that and why is said.
    `mended`: what ended it is gone, and nobody is sent to mend it. `elsewhere`: that another bench is open by now.
    """
    status = run.status.partition(":")[0]
    wanted = run.fault is not None and run.fault.kind == "stopped"  # by Stop or COILS OFF: nothing failed
    if wanted and status == "failed":
        status = "stopped"
    if status != "finished":
        word = "stopped" if wanted else status
        shape, state = ENDS.get(word, ENDS["failed"])
        lost = status == "interrupted" and run.fault is not None and not wanted and not mended
        what = "lost" if lost else "mended" if mended and status == "failed" else status
        if status == "interrupted" and not keeps_a_turn(run):
            what += ", no turn" if run.step is not None else ", not begun"
        rule = " ".join(filter(None, (elsewhere, translated(str(TEXTS[4])))))
        if resumable and run.order is not None and run.order.procedure not in resumable:
            what = "stopped" if wanted else "mended" if mended else "failed"  # nothing offers what cannot be
            rule = f"{rule} {translated(str(TEXTS[-1])).format(run.order.procedure)}"
        said = translated(ended_word(word)).upper()
        if (
            run.step is None and word == "failed" and not run.goes_on
        ):  # below a serial in large letters it would be a verdict on that DUT
            said, rule = translated(str(TEXTS[NOTHING])), translated(str(TEXTS[NOTHING_OF]))
        timing = delay_words(run) if what in ("interrupted", "lost") else ""
        return RunVerdict(f"{shape} {said}", state, rule, f"{_next(what)} {timing}".strip())
    worst = max((m.verdict for m in run.measurements.values()), key=WORST.index, default="")
    missing = run.left_out()
    word, state = result_word(worst, missing)
    if not worst:
        return RunVerdict(word, state, "", _next(""))
    about = [one for one in run.measurements.values() if one.verdict == worst]
    said = str(len(about)) if worst == "PASS" else listed(about)
    rule, fitted = translated(RULES[worst]).format(said), run.order is None or calibrates(run.order.procedure)
    if worst == "PASS" and fitted:
        rule = f"{rule} {translated(str(JUDGED))}"
    if missing:
        rule = f"{rule} {translated(str(TEXTS[NOT_MEASURED])).format(', '.join(map(step_title, missing)))}"
        rule = f"{rule} {translated(str(DELAY))}" if any(one.startswith("delay ") for one in missing) else rule
    return RunVerdict(word, state, rule, _next(worst if fitted or worst != "PASS" else _without(run)))


def ended_for_another(run: RunViewModel, serial: str) -> bool:
    """Whether a run has ended that was of another DUT than `serial`; one without a DUT was of what the bench holds."""
    return run.state == "ended" and run.order is not None and run.order.dut not in ("", serial)


def to_be_fitted(run: RunViewModel) -> bool:
    """Whether a calibration is the next thing to make of a run that has ended."""
    return run.status == "finished" and run.order is not None and calibrates(run.order.procedure)


def _without(run: RunViewModel) -> str:
    """What comes next of a good run of which no calibration can be made."""
    return "one axis" if run.order is not None and run.order.procedure == "rotate-axis" else "no calibration"


def result_word(worst: str, missing: Collection[str] = ()) -> tuple[str, str]:
    """What a finished run came to, in a word with its shape, and the colour: by its worst verdict and what it lacks."""
    if not worst:
        return f"✓ {translated('DONE')}", ""
    shape, state = STATES[worst]
    if missing and worst == "PASS":
        lacks = ", ".join(map(step_title, missing))
        return translated(str(TEXTS[WITHOUT])).format(f"▲ {translated(worst)}", lacks), "warning"
    return f"{shape} {translated(worst)}", state


def end_result(status: str, *, stopped: bool = False, by_off: bool = False) -> tuple[str, str]:
    """How a run ended that did not finish, likewise: in the words of the card of its end; `stopped` by a person."""
    shape, state = ENDS.get(ended_word(status, stopped=stopped)) or ENDS.get(status.partition(":")[0], ("", ""))
    said = translated(ended_word(status, stopped=stopped, by_off=by_off))
    return (f"{shape} {said.upper()}", state) if shape else (said, "")


def keeps_a_turn(run: RunViewModel) -> bool:
    """Whether there is one that is not measured again where the run is gone on with."""
    return any(mark == "done" and name_a_turn((name,)) for name, mark in run.steps())


def _next(key: str) -> str:
    return translated(str(NEXT.get(key) or NEXT.get(key.partition(",")[0], NEXT["failed"])))


def listed(measured: Iterable[Measurement], most: int = 2) -> str:
    """The first of them with value, U and limit; the others are counted."""
    words = []
    for one in measured:
        decimals = decimals_for(2 * one.u, one.value)
        value, U = format_number(one.value, decimals), format_number(2 * one.u, decimals, signed=False)
        words.append(f"{step_title(one.name)} {value} ± {U} {one.unit} ({short_number(one.limit)})")
    more = f" (+ {len(words) - most})" if len(words) > most else ""
    return listed_apart(words[:most]) + more
