"""Questions and what is said of the coils, in the language of the window; the record and the rules keep the English."""

import ast
import re
from pathlib import Path

import pytest
from PySide6.QtCore import QLocale

from labcal.bench.coils.state import (
    AT_ZERO,
    BY_SUPPLIES,
    BY_WORD,
    MAY_TURN,
    NOT_BY_REFERENCE,
    NOT_CONFIRMED,
    NOT_SINCE,
    NOT_YET,
    ON,
    CoilReading,
    LabState,
    PlatformReading,
    Witness,
)
from labcal.gui.ipc.bench_commands import procedures
from labcal.gui.ipc.messages import Answer, ListProcedures, RunProcedure
from labcal.gui.translations import translate
from labcal.gui.translations.faults import FAULTS
from labcal.gui.translations.lab_faults import LAB_FAULTS
from labcal.gui.translations.sentences import COILS, FORMS, NAME_FORMS, form_of, in_words
from labcal.gui.viewmodels.hands_now import reasons
from labcal.gui.viewmodels.lab_now import LabNow
from labcal.gui.viewmodels.loop_words import without_evidence
from labcal.gui.viewmodels.number_format import short_number
from labcal.gui.widgets.parameter_form import title_of
from labcal.record.stream import Prompt, Step

ROOT = Path(__file__).parents[2]
ROOMS = ("labcal", "drivers", "procedures")
MOUNT = (
    "Mount the DUT with body X up along the platform axis, body Y towards the cage's Y, at platform angle 0.",
    "Den Prüfling mit Körperachse X nach oben",
)


@pytest.fixture
def german(qapp):
    translate.install_translator(qapp, QLocale("de"))
    yield
    translate.install_translator(qapp, QLocale("en"))


def test_nothing_is_said_of_the_coils_here_that_the_bench_does_not_say():
    files = (ROOT / "labcal" / "bench" / "coils").rglob("*.py")
    nodes = (node for file in files for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))))
    said = "\n".join(node.value for node in nodes if isinstance(node, ast.Constant) and isinstance(node.value, str))
    pieces = {piece.strip(" .;:,") for form in COILS for piece in re.split(r"\{\d\}", str(form))}
    assert {piece for piece in pieces if piece not in said} == set()


def test_no_form_is_hidden_by_a_shorter_one_before_it():
    """The question whether another DUT is measured all the same was half in German: the first form that fits counts."""
    hidden = []
    for form in FORMS:
        names = (f"Q{letter}7" for letter in "ABCDEFGHIJ")
        found = form_of(re.sub(r"\{\d\}", lambda _, names=names: next(names), form))
        hidden += [(form, found)] if found is None or found[0] != form else []
    assert hidden == []


def test_every_sentence_about_the_coils_has_a_form():
    def coils(*amperes, fault=""):
        return tuple(CoilReading(a, None, i, i == 0.0, True, 10.0, fault) for a, i in zip("xyz", amperes, strict=True))

    agrees = Witness("agrees", "", (0.0,) * 3, (0.0,) * 3, 1.0, 2.0, 10.0)
    disagrees = Witness("disagrees", "", (9.0,) * 3, (0.0,) * 3, 9e3, 2e3, 10.0)
    still, on, unread = coils(0.0, 0.0, 0.0), coils(1.52, 0.0, -0.4), coils(None, 0.0, 0.0, fault="x: silent")
    states = [LabState(one, witness) for one in (still, on, unread) for witness in (agrees, disagrees, Witness())]
    for one in [*states, LabState(coils(None, 0.0, 0.0))]:
        for now_s in (10.0, 40.0):
            said = one.sentence(now_s).replace(f"{BY_WORD}: ", f"{BY_SUPPLIES}; ")  # as the window words it
            assert in_words(one.sentence(now_s)) == said.replace(" -", " −")
            form, filled = form_of(said.partition("; no reference")[0])
            assert form != "coils on: {0}" or "read back" not in filled[0]


def test_why_hands_are_kept_out_has_a_form_in_short(german):
    """The largest red words were half in English: what is cut off for them has forms of its own."""
    turning = PlatformReading(220.0, True, 10.0)
    short = [*reasons(NOT_YET, turning.sentence(10.0)), *reasons(AT_ZERO, turning.sentence(40.0))]
    assert short == [
        "Spulen vielleicht an",
        "Tisch dreht",
        "Stillstand des Tisches NICHT bestätigt: bei 220° drehte er",
    ]
    whole = (NOT_CONFIRMED, NOT_BY_REFERENCE, NOT_SINCE, f"{ON}: x +0.161 A, read back 1 s ago", MAY_TURN)
    cut = [one for coils in whole[:-1] for one in reasons(coils, whole[-1])]
    assert [said for said in cut if "NOT" in said or "coil" in said or "platform" in said] == []


def test_all_that_procedures_say_of_themselves_has_a_form():
    found = procedures(None, ListProcedures()).found  # with the settings that are files
    settings = [one for procedure in found for one in procedure.parameters]
    said = {text for procedure in found for text in (procedure.title, procedure.needs)}
    said |= {text for one in settings for text in (one.help, one.expected, title_of(one))}
    assert {text for text in said - {""} if form_of(text) is None} == set()


def test_no_fault_has_a_form_here_that_nobody_says():
    files = (file for room in ROOMS for file in (ROOT / room).rglob("*.py") if "gui" not in file.parts)
    nodes = (node for file in files for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))))
    said = "\n".join(node.value for node in nodes if isinstance(node, ast.Constant) and isinstance(node.value, str))
    pieces = {piece.strip(" .;:,'()`") for form in (*FAULTS, *LAB_FAULTS) for piece in re.split(r"\{\d\}", str(form))}
    assert {piece for piece in pieces if piece not in said} == set()


BETWEEN_PROGRAMS = (  # what no technician's click can bring about
    "is not for the session to ask", "is not for the session to address", "is no order", "drives Q", "makes room",
    "first; `labcal bench off` sets", "in the folder of [safety]", "goes on trying", "Q Q", "Q: Q.",
)  # fmt: skip


def test_what_coils_and_guardian_raise_has_a_form():
    """As after F12: it stands in the red card, and in the line at the bottom."""
    files = (file for room in ("coils", "guardian") for file in (ROOT / "labcal" / "bench" / room).rglob("*.py"))
    nodes = (node for file in files for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))))
    calls = (node for node in nodes if isinstance(node, ast.Call) and getattr(node.func, "id", "") in RAISED)
    said = [text for call in calls for text in map(_raised, [*call.args[:1], *_remedies(call)]) if " " in text]
    unknown = {text for text in said if not any(one in text for one in BETWEEN_PROGRAMS)}
    assert len(unknown) > 20
    assert {text for text in unknown if form_of(text) is None and form_of(text.rstrip(".")) is None} == set()


RAISED = ("InstrumentError", "LimitError")


def _remedies(call):
    return [one.value for one in call.keywords if one.arg == "remedy"]


def _raised(node):
    """A literal with a Q for what is filled in; "" where it is none."""
    if isinstance(node, ast.JoinedStr):
        return "".join(part.value if isinstance(part, ast.Constant) else "Q" for part in node.values)
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else ""


def test_the_end_of_a_run_is_said_in_german(german):
    assert in_words("broken off: dut: the link was lost.").startswith("unterbrochen: dut: ")
    assert in_words("coil x: zero has not been read back.") == "Spule x: null wurde nicht zurückgelesen."
    whole = in_words(
        "zero, open; before that: coil x: 0.5 A still flows 2.0 s after zero was set (zero is below 0.01 A)"
    )
    assert whole.startswith("null, offen; davor: Spule x: 0,5 A fließen noch 2,0 s")  # its end was lost on the way
    assert in_words("broken off: dut: no reply in 0.5 s, nothing came").endswith("keine Antwort in 0,5 s, nichts kam")
    assert in_words("The work was ended by this window.") == "Die Arbeit wurde von diesem Fenster beendet."


NOT_SHOWN = {  # of the loop, the estimators and the procedures
    "policy.py": "judgements with their reasons: docs/closed-loop.md",
    "confounded.py": "what cannot be told apart stands in the report",
    "registry.py": "faults of another package's estimator",
    "__init__.py": "faults of a program",
}
KEYS = {  # by which the program itself goes; tests that pass are not listed
    "rounds exhausted", "one too many", "not first", "equally likely", "initial state", "smooth in each channel",
    "own secant",
    "base grams", "null model", "move device", "turn reference", "move reference", "repeated conditions",
    "white from row to row", "no lack of fit against repeats", "[reference] position_m = [",
    "looks at all readings at once", "look at one after another", "angle zeros",
}  # fmt: skip


def test_all_that_loop_estimators_and_procedures_say_has_a_form():
    forms, left = "\n".join((*FORMS, *NAME_FORMS)), set()
    for file in (file for room in ("labcal/loop", "labcal/fit", "procedures") for file in (ROOT / room).rglob("*.py")):
        nodes = [*ast.walk(ast.parse(file.read_text(encoding="utf-8")))]
        documented = {id(node.value) for node in nodes if isinstance(node, ast.Expr)}
        for node in nodes:
            if not (isinstance(node, ast.Constant) and isinstance(node.value, str)) or id(node) in documented:
                continue
            for piece in re.split(r"(?<=\.) ", node.value.strip(" .;:,–±'()`?\"")):
                words = re.search(r"[A-Za-z]{2}.* [a-z]{2}", piece) and file.name not in NOT_SHOWN
                if words and piece not in forms and form_of(piece) is None and piece not in KEYS:
                    left.add((file.name, piece))
    assert left == set()


@pytest.mark.parametrize(
    ("fault", "german_words"),
    [
        ("reference: no sample for 2.1 s.", "reference: seit 2,1 s kein Wert."),
        pytest.param(
            "supply_x (tcp://10.0.0.7:5): the link was lost (reset).",
            "Die Verbindung ging verloren (reset).",
            marks=pytest.mark.slow,
        ),
        pytest.param(
            "x: the link was lost. Plug it in, see that nobody else has opened it, then try again.",
            "x: Die Verbindung ging verloren. Einstecken, nachsehen, dass es niemand sonst geöffnet hat, dann "
            "noch einmal.",
            marks=pytest.mark.slow,
        ),
        ("a number from 0 to 60 deg/s", "eine Zahl von 0 bis 60 deg/s"),
        pytest.param("VALID: signed by jdoe@lab.", "GÜLTIG: signiert von jdoe@lab.", marks=pytest.mark.slow),
        pytest.param("stopped by the operator", "vom Bediener gestoppt", marks=pytest.mark.slow),
    ],
)
def test_what_people_meet_most_is_said_in_german(german, fault, german_words):
    assert in_words(fault).endswith(german_words)


def test_what_has_no_form_is_shown_as_it_came(german):
    assert in_words("Begin {now}?") == "Begin {now}?"
    assert in_words("stage is stuck.") == "stage is stuck."


def test_a_question_and_the_coils_are_told_in_german_and_answered_in_english(new_window, german):
    run, card = new_window.app_state.run, new_window.page("Run").live.prompt
    run.start(RunProcedure("preflight", "bench.toml"))
    new_window.app_state.grow_old()
    new_window.app_state.bench_worker.items.emit((Prompt(1.0, "mount-x", MOUNT[0], ("done",), True),))
    assert card.text.text().startswith(MOUNT[1])
    assert "Y" in card.text.text()
    assert new_window.message.text().startswith(MOUNT[1])
    new_window.show_state(new_window.app_state.lab.state)
    card.say_lab(LabNow(coil_words=AT_ZERO))
    assert card.lab.text() == "✓ Spulen auf null"
    assert card.lab.property("state") == "good"
    card.say_lab(LabNow(coil_words=AT_ZERO, platform_words="platform NOT confirmed at a standstill"))
    assert card.lab.text() == "✓ Spulen auf null"
    assert card.stands.text() == "✕ Stillstand des Tisches NICHT bestätigt"
    assert card.stands.property("state") == "bad"
    run.answer("done")
    assert Answer("mount-x", "done") in new_window.app_state.bench_worker.said
    assert "Feld" in in_words("The coils go up to 115 µT, then the field rotates. Hands off?")


def test_what_a_person_notes_is_no_step_and_no_measurement(new_window, german):
    for words in ("noise from the lift", "zero again at 9", "closing the door"):
        new_window.app_state.lab.update(message=words)
        assert new_window.message.text() == words
    new_window.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    new_window.app_state.bench_worker.items.emit((Step(1.0, 1, 2, "closing", 60.0, ("zero", "closing")),))
    assert new_window.message.text() == "Abschluss"


def test_limits_and_readings_in_sentences_have_the_decimal_mark_of_the_language(german):
    assert short_number(0.5) == "0,5"
    assert short_number(None) == "–"
    assert in_words("coils on: x +0.1060 A") == "Spulen an: x +0,1060 A"
    assert in_words("offset x") == "Nullpunkt x"
    assert in_words("tcp://127.0.0.1:4002") == "tcp://127.0.0.1:4002"


def test_a_reason_without_its_evidence_has_a_form_as_well(german):
    for said in ("no better than chance or a slow wander", "too little evidence"):
        assert without_evidence(f"{said}: evidence −3.1 nats, 5 needed") == said
        assert in_words(said) != said
