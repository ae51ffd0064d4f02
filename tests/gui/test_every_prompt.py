"""Every question that any procedure can ask is shown by the window, and answered by a click or by its own key alone.

The procedures are run on the simulated lab, as short as their own limits allow; what they asked is asked again here.
"""

import ast
import inspect
import pkgutil
from contextlib import closing
from datetime import UTC, datetime
from importlib import import_module
from importlib.metadata import entry_points
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QFontMetrics
from scalar_lab import SCALAR, sensor

import procedures
from labcal.bench import steps
from labcal.bench.clock import VirtualClock
from labcal.bench.opening import open_bench
from labcal.errors import Stopped
from labcal.gui.ipc.messages import Answer, RunProcedure
from labcal.gui.translations.sentences import form_of, of_this_bench
from labcal.gui.viewmodels.failed_step import asked_text
from labcal.gui.viewmodels.may_answer import acting
from labcal.gui.widgets.answer_words import WORDS
from labcal.gui.widgets.hold_button import HOLD_MS, HoldButton, heard_ms
from labcal.record.stream import FAULT, Prompt
from labcal.runner import find, run_procedure
from labcal.runner.prompts import first_choice
from labcal.store import Store

EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"
INSTALLED = sorted(e.name for e in entry_points(group="labcal.procedures") if e.value.startswith("procedures."))
BESIDE = (
    "preflight, redone",
    "preflight, resumed",
    "preflight, wrong axes",
    "rotate-axis, by hand",
    "configuration, no such file",
    "a fault",
)
BESIDE += ("rotate-axis, another serial",)
DEAR = ("dut-moment",)  # a fifth of the time of all
MODULES = [steps, *(import_module(f"procedures.{one.name}") for one in pkgutil.iter_modules(procedures.__path__))]
PICTURED = {"body_from_cage", "axis_cage", "angle_deg", "file"}  # the card draws these, or offers a button for them
# Of these the texts say it all.
SAID_IN_WORDS = {
    "again",
    "what",
    "remedy",
    "no_answer",
    "mode",
    "load",
    "on",
    "reference_m",
    "reference_turned",
    "dut_away",
    "half",
    "reversed",
    "serial",
    FAULT,
}
IN_WORDS = ("turn-", "serial-", "photo-", "skip-", "redo-")  # keys of what is answered by a number or in words
A_FAULT = """
from labcal.bench.steps import attempt
from labcal.errors import InstrumentError

def fails(bench):
    yield from ()
    still = "Still lost: stage (stuck). Put that right first: a step begun now fails again."
    bench.still_wrong = lambda: still
    raise InstrumentError("stage is stuck.", fault="stuck", remedy="Free it.")

def a_fault(bench):
    yield from attempt(bench, "turn", lambda: fails(bench))
"""


def quick(found):
    """The shortest times and the fewest repeats that a procedure's own limits allow."""
    given = {"preflight": {"axes": "x,y", "magnitudes_nT": "20000", "reverse": "no", "modes": "nominal"}}.get(
        found.name, {}
    )
    for spec in found.parameters:
        if spec.limits is None or spec.many or spec.name in given or spec.name.startswith("u_"):
            continue
        if spec.unit == "s" or spec.kind == "integer":
            given[spec.name] = f"{max(spec.limits.lo, 1):g}"
        elif spec.unit == "deg/s":
            given[spec.name] = "10"
    return given


class Questions:
    """Runs a procedure once and keeps what it asked, and in which lines of which file the questions stand."""

    def __init__(self, folder):
        self.folder, self.asked, self.stood, self.lines, self.typed = folder, {}, {}, set(), set()

    def of(self, case):
        if case not in self.asked:
            self.asked[case] = self._run(case)
        return self.asked[case]

    def is_new(self, prompt):
        kind = self.stood[prompt.text], prompt.choices, prompt.acts
        new = kind not in self.typed
        self.typed.add(kind)
        return new

    def prompt(self, *args, **kwargs):
        caller = inspect.currentframe().f_back
        made = Prompt(*args, **kwargs)
        self.stood[made.text] = Path(caller.f_code.co_filename).name, caller.f_lineno
        self.lines.add(self.stood[made.text])
        return made

    def _run(self, case):
        name, _, way = case.partition(", ")
        bench, filled, answers, until = EXAMPLE, {}, {}, None
        if way == "redone":
            answers, until = {"mount-y": "redo x"}, "redo-x"
        elif way == "resumed":
            filled, until = {"resume": steps.Resume(frozenset({"zero", "axes-check"}), {})}, "mounting-stands"
        elif way == "wrong axes":
            bench, until = self.folder / "wrong-axes.toml", "opening-failed"
            text = EXAMPLE.read_text(encoding="utf-8")
            bench.write_text(text.replace("angle_sign = 1", "angle_sign = -1"), encoding="utf-8")
        elif way == "no such file":
            answers, until = {"photo-covers": "none.jpg"}, "batteries"
        elif way == "by hand":
            bench = self.folder / "by-hand.toml"
            bench.write_text(EXAMPLE.read_text(encoding="utf-8").replace('"zaber"', '"manual"'), encoding="utf-8")
        elif way == "another serial":
            bench, answers = self.folder / "serials.toml", {"serial-mount-z": "EM-08"}
            text = EXAMPLE.read_text(encoding="utf-8")
            bench.write_text(text.replace("[dut]\n", "[dut]\nserial_at_mounting = true\n"), encoding="utf-8")
        elif name == "scalar-cage":
            bench, text = self.folder / "scalar.toml", EXAMPLE.read_text(encoding="utf-8")
            for old, new in [("surprise = true", sensor(0)), *SCALAR]:
                text = text.replace(old, new)
            bench.write_text(text, encoding="utf-8")
        elif name == "a fault":
            (self.folder / "a_fault.py").write_text(A_FAULT, encoding="utf-8")
            name, answers = str(self.folder / "a_fault.py"), {"failed-turn": ["retry", "skip"]}
        return self._drive(find(name), bench, filled, answers, until)

    def _drive(self, found, bench, filled, answers, until):
        asked = []

        def answer(prompt):
            asked.append(prompt)
            if prompt.key == until:
                raise Stopped("seen")
            said = answers.pop(prompt.key, first_choice(prompt))
            if isinstance(said, list):
                answers[prompt.key] = said[1] if len(said) == 2 else said[1:]
                return said[0]
            return said

        clock = VirtualClock(datetime(2026, 1, 5, tzinfo=UTC))
        with pytest.MonkeyPatch.context() as patch, closing(open_bench(bench, clock=clock, seed=3)) as lab:
            for module in MODULES:
                if hasattr(module, "Prompt"):
                    patch.setattr(module, "Prompt", self.prompt)
            with Store.open(self.folder / "runs.sqlite") as store:
                ended = run_procedure(lab, found, quick(found), filled=filled, store=store, answer=answer)
        assert ended.status in (("interrupted", "stopped") if until else ("finished",)), ended.fault
        return list({(self.stood[p.text], p.choices, p.acts): p for p in asked}.values())


@pytest.fixture(scope="module")
def questions(tmp_path_factory):
    return Questions(tmp_path_factory.mktemp("questions"))


class Asked:
    """The card of one question in the real window, and what the worker was told."""

    def __init__(self, window, prompt, qtbot):
        self.window, self.prompt, self.bot = window, prompt, qtbot
        self.worker, self.card = window.app_state.bench_worker, window.page("Run").live.prompt
        self.ask()

    def ask(self):
        self.worker.said = []
        self.worker.items.emit((self.prompt,))
        self.bot.waitUntil(lambda: self.card.alive, timeout=180_000)
        assert self.window.app_state.run.state == "asking"

    def told(self):
        return [word.text for word in self.worker.said if isinstance(word, Answer)]

    def strike(self, widget, *keys):
        widget.setFocus()
        for key in keys:
            self.bot.keyClick(widget, key)
            self.window.scanner.flush()

    def scan(self, widget):
        """A burst: every key within one instant, Enter at its end."""
        scanner = self.window.scanner
        now, scanner.now = scanner.now, lambda: 1e9
        widget.setFocus()
        self.bot.keyClicks(widget, "EM-99")
        self.bot.keyClick(widget, Qt.Key.Key_Return)
        scanner.flush()
        scanner.now = now

    def hold(self, button):
        """The button's own key, held, with the focus elsewhere; the 0.7 s are counted, not waited for."""
        assert button.held.interval() == HOLD_MS
        button.held.setInterval(0)
        heard_ms.clear()
        self.window.sidebar.setFocus()
        self.bot.keyPress(self.window, button.key)
        self.bot.waitUntil(lambda: bool(self.worker.said), timeout=180_000)
        self.bot.keyRelease(self.window, button.key)

    def is_shown(self):
        card, prompt = self.card, self.prompt
        words = of_this_bench(asked_text(prompt))
        assert card.isVisible()
        shown = f"{card.text.text()} {card.details.text()}".replace("\N{NO-BREAK SPACE}", " ").replace("−", "-").strip()
        if prompt.key == "ready" and shown.startswith("Next: "):
            shown = shown.removeprefix("Next: ")
            shown = shown[0].upper() + shown[1:]  # it is small after the colon
        assert shown.startswith(words)  # of a step that failed its advice stands below, with the button to press
        assert form_of(prompt.text) or prompt.key == "failed-turn", f"not in other languages: {prompt.text}"
        room = QFontMetrics(card.text.font()).boundingRect(card.text.contentsRect(), Qt.TextFlag.TextWordWrap, words)
        assert card.text.contentsRect().contains(room), f"{prompt.text} is cut off"
        lights = self.window.page("Run").live.lights
        squeezed = lights.isVisible() and lights.height() < lights.minimumSizeHint().height()
        assert not squeezed, "the lights of the axes are squeezed"
        assert set(prompt.drawing) <= PICTURED | SAID_IN_WORDS, f"nobody shows {dict(prompt.drawing)}"
        assert card.drawing.isVisible() == bool({"body_from_cage", "angle_deg"} & set(prompt.drawing))
        assert card.entry.isVisible() == (not prompt.choices)
        asks = "?" in words
        if prompt.choices:
            assert ("yes" in prompt.choices or prompt.key == "ready") == asks, f"{words} {prompt.choices}"
        else:
            assert prompt.key.startswith(IN_WORDS), f"{words}: nothing is to be written"

    def buttons(self):
        """What answers the question, and with what words."""
        if not self.prompt.choices:
            return {"45.0": self.card.send}
        for choice in self.prompt.choices:
            assert choice in WORDS or choice.startswith("redo "), f"the button {choice!r} has no words"
            assert not self.card.choices[choice].text().startswith("Done"), (
                f"{self.prompt.text} is not answered by Done"
            )
        return self.card.choices

    def ready(self):
        """Asked once more, its words written where it wants words; the buttons."""
        self.ask()
        self.card.entry.setText("" if self.prompt.choices else "45.0")
        return self.buttons()


@pytest.mark.parametrize(
    "case", [pytest.param(one, marks=pytest.mark.slow) if one in DEAR else one for one in (*INSTALLED, *BESIDE)]
)
def test_every_question_of_a_procedure_is_shown_and_answered_as_it_may_be(qtbot, by_mouse, still, questions, case):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    still.scanner.now = float  # the time stands still: whatever is struck until it is looked at is one burst
    still.scanner.wait.setInterval(3_600_000)
    for prompt in questions.of(case):
        asked = Asked(still, prompt, qtbot)
        asked.is_shown()
        held = [b.key for b in asked.buttons().values() if isinstance(b, HoldButton)]
        assert len(set(held)) == len(held), "two answers by one key"
        first = questions.is_new(prompt)  # a question that many procedures ask is typed at once, and clicked in all
        for words in asked.buttons():
            by_hand(asked, words, by_mouse)
            if first:
                by_keyboard(asked, words)


def by_hand(asked, words, by_mouse):
    button = asked.ready()[words]
    assert button.isVisible()
    assert button.isEnabled()
    if "serial" in asked.prompt.drawing:
        asked.scan(button)
        assert asked.told() == ["EM-99"]
        button = asked.ready()[words]
    else:
        asked.scan(button)
        if not asked.prompt.choices:
            asked.scan(asked.card.entry)  # what comes fast into it was typed there; its Enter answers nothing
            asked.card.entry.setText("45.0")
        assert asked.told() == []
        assert "EM-99" in asked.window.app_state.lab.state.message
    by_mouse(button)
    assert asked.told() == [words]


def by_keyboard(asked, words):
    button = asked.ready()[words]
    acts = acting(asked.prompt, words)
    assert isinstance(button, HoldButton) == acts
    entry = () if asked.prompt.choices else (asked.card.entry,)
    if "serial" in asked.prompt.drawing:
        asked.strike(asked.card.entry, Qt.Key.Key_Return)
    elif acts:
        for widget in (button, *entry):
            asked.strike(widget, Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space)
        assert asked.told() == []
        asked.hold(button)
    elif entry:
        asked.strike(asked.card.entry, Qt.Key.Key_Return)
    else:
        asked.strike(button, Qt.Key.Key_Space)
    assert [told.strip() for told in asked.told()] == [words]


def test_a_photograph_that_is_not_wanted_is_answered_too(qtbot, by_mouse, still, questions):
    still.app_state.run.start(RunProcedure("configuration", "bench.toml"))
    photo = next(p for p in questions.of("configuration") if p.key.startswith("photo-"))
    asked = Asked(still, photo, qtbot)
    by_mouse(asked.card.choices[""])
    assert asked.told() == [""]


def test_no_question_that_stands_in_the_source_was_left_out(questions):
    for case in (*INSTALLED, *BESIDE):
        questions.of(case)
    missed = []
    for module in MODULES:
        for node in ast.walk(ast.parse(inspect.getsource(module))):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "Prompt":
                lines = {(Path(module.__file__).name, n) for n in range(node.lineno, node.end_lineno + 1)}
                missed += [] if lines & questions.lines else [sorted(lines)[0]]
    assert missed == [], "these questions are asked by no run above: add the way that leads to them"
