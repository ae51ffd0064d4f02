"""Every page in its states at six sizes: no text is cut, and nothing lies over anything else, by geometry."""

import time
from dataclasses import replace

import numpy as np
import pytest
from geometry import faults, run_over
from lab_states import told
from PySide6.QtCore import QLocale
from PySide6.QtWidgets import QApplication, QLabel, QVBoxLayout, QWidget
from test_calibration_views import FOUND
from test_choose import told_by_the_loop
from test_compare import side
from test_path import RUN, calibration

from labcal.bench.coils.state import FieldReading, Heard, PlatformReading
from labcal.errors import OutOfControl
from labcal.gui.ipc.answers import Checked, Comparison, Ended, FitFigures, Fitted, Look
from labcal.gui.ipc.messages import (
    CloseLoop,
    CompareRuns,
    FitRun,
    LastCageCheck,
    LastClosingCheck,
    ListCalibrations,
    ListKeys,
    ListRuns,
    LookAt,
    RunProcedure,
)
from labcal.gui.ipc.wire import Fault, fault_of
from labcal.gui.translations import translate
from labcal.gui.widgets.common import Card
from labcal.record import Segment
from labcal.record.stream import Block, Measurement, Prompt, SegmentOpened, Step

SIZES = {
    "1024 x 700": ((1024, 700), False),
    "1366 x 768": ((1366, 768), False),
    "1920 x 1080, and 4K at scale 2": ((1920, 1080), False),
    "4K at scale 1": ((3840, 2160), False),
    "1920 x 1080, F11": ((1920, 1080), True),
    "4K, F11": ((3840, 2160), True),
}
LARGE = {  # letters to be read from two metres, on the screens that there are
    "1024 x 700, F11": ((1024, 700), True),
    "1360 x 860, F11": ((1360, 860), True),
    "1440 x 900, F11": ((1440, 900), True),
}
STEPS = ("zero", "axes-check", "x+20uT-nominal", "x-50uT-full", "closing")
MOUNT = "Mount the DUT with body Y up along the platform axis, body X towards the cage's X, at platform angle 0."
TURNED = Prompt(1.0, "mount-y", MOUNT, ("done", "redo x"), True, {"body_from_cage": np.eye(3).tolist()})
ANOTHER = "EM-10: that is not the DUT of this run. Mount EM-09, then scan its serial again."
SCANNED = Prompt(1.0, "serial-mount-y", ANOTHER, (), True, {"serial": "EM-09"})
SILENT = Fault("instrument", "reference: no sample for 3.1 s.", "Look at its power and at its cable.", "trace")
WORST = Measurement(9.0, "closure x", 12.0, 3.0, "nT", 500.0)
NAMED_AT_LENGTH = Measurement(9.0, "mount-z: DUT less reference, first position", 2.0, 1.0, "nT")


def send(window, *items):
    window.app_state.bench_worker.items.emit(items)


def stored(window, *runs):
    for page in ("Start", "History"):
        window.open_page(page)
    answer = window.app_state.quick_worker.answer
    answer(ListRuns, runs)
    answer(LastClosingCheck, Checked(RUN, WORST, "PASS"))
    answer(LastCageCheck, Checked(RUN, WORST, "PASS"))


def interrupted(window):
    one = replace(RUN, status="interrupted", bench="Helmholtz cage of the magnetics laboratory, hall 2")
    stored(window, *(replace(one, run_id=f"r{n}", dut_serial=f"EM-{n}") for n in range(5)))
    return "Start"


def doubted(window):
    """What is said of the coils at its longest, and every value old."""
    begun(window)
    seen = FieldReading(None, (-43_695.6, 20_366.7, 1_135.6), time.monotonic() - 125.0)
    told(window, (None, 0.0, 0.0), verdict="disagrees", age_s=125.0)
    lab = window.app_state.run.lab
    names = [*window.app_state.facts.instruments, "guardian"]
    heard = tuple(Heard(name, time.monotonic() - 125.0) for name in names[:-1])
    window.app_state.bench_worker.states.emit(replace(lab, field=seen, instruments=heard, guardian=True))
    return "Start"


def history(window):
    stored(window, RUN, replace(RUN, run_id="r2", status="failed: dut is silent", simulated=True, verdict="explained"))
    window.page("History").faces.setCurrentIndex(0)
    window.page("History").table.selectRow(0)
    return "History"


def compared(window):
    history(window)
    page = window.page("History")
    page.table.selectAll()
    page.compare.click()
    window.app_state.fit_worker.answer(CompareRuns, Comparison(side("r1", "r1.json"), side("r2"), FOUND))
    return "History"


def begun(window, *items):
    window.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    told(window, (1.52, 0.0, -0.4))
    send(window, Step(0.0, 3, 5, STEPS[2], 2460.0, STEPS, 20.0), WORST, NAMED_AT_LENGTH, *items)
    window.page("Run").live.draw()
    return "Run"


def watched(window):
    """The camera is none, and says so."""
    window.page("Run").live.prompt.camera.source = "nowhere"
    return begun(window, TURNED)


def measuring(window):
    t = np.arange(50.0)
    samples = Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), t, np.outer(t, (1.0, 2.0, 3.0)))
    return begun(window, SegmentOpened(0.5, Segment(STEPS[2], "rotation")), samples)


def ended(window, status, fault=None, details=False):
    begun(window)
    window.app_state.bench_worker.answer(RunProcedure, Ended("r1", status, fault))
    if details:
        window.page("Run").live.verdict.details.click()
    return "Run"


def scanned(window):
    window.app_state.scan("EM-19")
    return "Run"


def refused(window):
    window.open_page("Run")
    form = window.page("Run").choose.form
    for name in ("inclination_deg", "magnitudes_nT"):
        form.set_text(name, "20 000")
    window.app_state.set_identity(dut="EM 07/!?<b>")
    return "Run"


def broken(window):
    window.app_state.fault.emit(SILENT)
    return "Bench"


def studied(window, page, *methods):
    window.open_page(page)
    stored(window, RUN)
    study, worker = window.app_state.study_vm, window.app_state.fit_worker
    study.open("r1")
    worker.answer(LookAt, Look("r1", "EM-07", 50, np.ones((50, 3)), {"time  s": np.arange(50.0)}))
    study.fit(*methods)
    K, k_nT = ((1.0, 0.001, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)), (120.0, -30.0, 5.0)
    done = FitFigures(True, None, K, k_nT, tuple(map(tuple, np.eye(12).tolist())), True, 12.3, (0.1, 0.2), 0.5)
    worker.answer(FitRun, Fitted(done, 20.0, np.zeros(50), np.ones((50, 3))))
    return page


def fitted(window):
    return studied(window, "Fit", "ml", "twostep", "ekf")


def traced(window):
    studied(window, "Loop")
    window.app_state.study_vm.close_loop()
    window.app_state.fit_worker.answer(CloseLoop, told_by_the_loop("reverse"))
    return "Loop"


def kept_from_beginning(window):
    window.open_page("Run")
    window.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    words = "the check standard CS-1 is out of control (offset x: a point beyond 3 sigma)"
    window.app_state.bench_worker.asked[-1].failed(fault_of(OutOfControl(words, "", file="/a/bench.toml")))
    window.app_state.quick_worker.answer(ListKeys, ("roe", "jdoe@lab"))
    window.page("Run").live.answer_for.key.setCurrentIndex(1)
    return "Run"


def certificate(window, keys=("jdoe@lab",), **standing):
    window.open_page("Certificate")
    window.app_state.quick_worker.answer(ListCalibrations, (calibration(**standing),))
    window.app_state.quick_worker.answer(ListKeys, keys)
    return "Certificate"


def reported(window):
    page = certificate(window)
    paper = window.page(page).paper
    paper.said.setText("Written: /home/jdoe/calibrations/2026-01-05-EM-07-report.html")
    paper.folder.show_folder("/home/jdoe/calibrations/2026-01-05-EM-07-report.html")
    return page


STATES = {
    "Start": lambda window: (stored(window, RUN), "Start")[1],
    "Start, interrupted runs": interrupted,
    "Start, coils in doubt": doubted,
    "Bench": lambda window: "Bench",
    "Bench, a fault": broken,
    "Run, kept from beginning": kept_from_beginning,
    "Run, to choose": lambda window: "Run",
    "Run, a scan": scanned,
    "Run, refused settings": refused,
    "Run, a question": lambda window: begun(window, TURNED),
    "Run, a question with a camera": watched,
    "Run, which serial": lambda window: begun(window, SCANNED),
    "Run, measuring": measuring,
    "Run, finished": lambda window: ended(window, "finished"),
    "Run, finished, details": lambda window: ended(window, "finished", details=True),
    "Run, stopped": lambda window: ended(window, "stopped", Fault("stopped", "stopped by the operator")),
    "Run, failed": lambda window: ended(window, "failed: reference is silent", SILENT),
    "Fit, empty": lambda window: "Fit",
    "Fit": fitted,
    "Loop, empty": lambda window: "Loop",
    "Loop": traced,
    "Certificate, empty": lambda window: "Certificate",
    "Certificate, a draft": lambda window: certificate(window, signed=False),
    "Certificate, no key": lambda window: certificate(window, (), signed=False),
    "Certificate, signed": lambda window: certificate(window),
    "Certificate, a report written": reported,
    "History": history,
    "History, two runs compared": compared,
}

ALWAYS = (  # of each page what fills it most
    "Start, coils in doubt", "Bench, a fault", "Run, kept from beginning", "Run, refused settings",
    "Run, a question with a camera", "Run, finished, details", "Fit", "Loop", "Certificate, a draft",
    "Certificate, a report written", "History, two runs compared",
)  # fmt: skip
SHORT = [state if state in ALWAYS else pytest.param(state, marks=pytest.mark.slow) for state in STATES]


@pytest.fixture(scope="module")
def large(deaf_window):
    """The window, to be brought to a size, and left in it by one test for the next; after all of them as it was."""
    before = deaf_window.size().toTuple()

    def bring(size, wall):
        if deaf_window.wall != wall:
            deaf_window.toggle_wall()
        deaf_window.style_queue.finish()
        deaf_window.resize(*size)

    yield bring
    bring(before, False)


@pytest.fixture
def sized(still, large):
    """The same; after each test as it was."""
    before = still.size().toTuple()
    yield large
    large(before, False)


def settle(window):
    """Layouts and what is put off to idle moments are done."""
    for _ in range(6):
        QApplication.processEvents()
        window.style_queue.finish()


def faults_at(window, bring, page, words, sizes=SIZES):
    """What is wrong with this page at the size that is called so."""
    size, wall = sizes[words]
    for _ in range(2):  # a narrow window has a narrow frame, and then room for less
        bring(size, wall)
        settle(window)
    if window.lazy_pages[page].area.horizontalScrollBar().isVisible():
        yield f"{words}: the page is wider than its place: {window.page(page).minimumSizeHint()}"
    if (window.width(), window.height()) != size:
        yield f"{words}: the window needs {window.width()} x {window.height()}"
    yield from (f"{words}: {what}" for what in faults(window))


def shown(window, state):
    """The page of this state, which the window then shows."""
    for page in window.lazy_pages:
        window.page(page)
    page = STATES[state](window)
    window.open_page(page)
    return page


@pytest.mark.parametrize("state", SHORT)
def test_no_text_is_cut_and_nothing_lies_over_anything_else(still, sized, state):
    page = shown(still, state)
    found = [fault for words in SIZES for fault in faults_at(still, sized, page, words)]
    assert not found, f"{len(found)} faults:\n" + "\n".join(found)


def by_word(window, *items):
    """What is said of coils and platform at its longest, in a run."""
    begun(window)
    told(window, (0.0, 0.0, 0.0), verdict="not known")
    lab = window.app_state.run.lab
    why = "the reference has no ambient field to compare with yet"
    lab = replace(
        lab, reference=replace(lab.reference, why=why), platform=PlatformReading(0.0, False, time.monotonic())
    )
    window.app_state.bench_worker.states.emit(lab)
    send(window, *items)
    return "Run"


READY = Prompt(1.0, "ready", "The coils go to 50 µT and the platform turns. Hands off?", ("done",), True)
LONG = {
    "to mount": lambda window: by_word(window, TURNED),
    "hands off": lambda window: by_word(window, READY),
    "to switch": lambda window: by_word(
        window,
        Prompt(1.0, "mode-nominal", "Switch the DUT to power mode nominal.", ("done",), True, {"mode": "nominal"}),
    ),
    "measuring": measuring,
    "a pause asked for": lambda window: (measuring(window), window.app_state.run.pause(), "Run")[2],
    "finished": lambda window: ended(window, "finished"),
}
ALIKE = ("hands off", "to switch", "a pause asked for")  # nearly as full as others


@pytest.mark.parametrize("state", [pytest.param(one, marks=[pytest.mark.slow] * (one in ALIKE)) for one in LONG])
def test_a_run_in_large_letters_is_whole_on_a_usual_screen(still, large, state):
    page = LONG[state](still)
    still.open_page(page)
    found = [fault for words in LARGE for fault in faults_at(still, large, page, words, LARGE)]
    assert not found, f"{len(found)} faults:\n" + "\n".join(found)


@pytest.mark.parametrize("state", SHORT)
def test_every_page_in_large_letters_is_whole_on_a_usual_screen(still, large, state):
    page = shown(still, state)
    found = list(faults_at(still, large, page, "1440 x 900, F11", LARGE))
    found += [f"{type(one).__name__} runs over its card" for one in run_over(still.page(page))]
    assert not found, f"{len(found)} faults:\n" + "\n".join(found)


def test_what_runs_over_its_card_is_found(qtbot):
    holder, card, inside = QWidget(), Card("A title"), QLabel("inside")
    qtbot.addWidget(holder)
    QVBoxLayout(holder).addWidget(card)
    card.body.addWidget(inside)
    holder.resize(300, 200)
    holder.show()
    assert run_over(holder) == []
    inside.setGeometry(10, 100, 100, 300)
    assert run_over(holder) == [inside]


@pytest.fixture
def other_language(qapp, request):
    translate.install_translator(qapp, QLocale(request.param))
    yield request.param
    translate.install_translator(qapp, QLocale("en"))


@pytest.mark.parametrize(
    ("other_language", "states"),
    [("de", ALWAYS), *(pytest.param(name, STATES, marks=pytest.mark.slow) for name in ("de", "fr"))],
    indirect=["other_language"],
    ids=["de", "de, all", "fr, all"],
)
def test_longer_words_of_another_language_are_not_cut_where_room_is_least(other_language, new_window, rest, states):
    found = list[str]()
    for state in states:
        page = shown(rest(new_window), state)
        faulty = faults_at(new_window, lambda size, wall: new_window.resize(*size), page, next(iter(SIZES)))
        found += [f"{state}, {fault}" for fault in faulty]
    assert not found, f"{len(found)} faults:\n" + "\n".join(found)


@pytest.mark.parametrize("state", LONG)
def test_a_run_is_whole_on_a_small_screen(still, sized, state):
    page = LONG[state](still)
    still.open_page(page)
    assert not (found := list(faults_at(still, sized, page, "1024 x 700"))), "\n".join(found)


@pytest.mark.parametrize("moving", [False, True])
def test_a_question_with_all_that_can_be_said_below_it_rolls_on_a_small_screen_and_is_whole(fixed, sized, moving):
    fixed.open_page(by_word(fixed, replace(TURNED, text=f"{MOUNT} The cable comes out towards the door, the lift up.")))
    lab, card = fixed.app_state.run.lab, fixed.page("Run").live.prompt
    fixed.app_state.bench_worker.states.emit(replace(lab, platform=replace(lab.platform, moving=moving)))
    card.say_anew(anew=True)
    card.say_serials((("dut", "says that it is EM-10, and the bench file states EM-09: look which of the two stands"),))
    for _ in range(2):
        sized((1024, 700), False)
        settle(fixed)
    for said in (card.hands, card.stands, card.anew, card.serials, card.text.below if moving else card.text):
        assert said.isVisibleTo(card)
        assert said.height() >= said.heightForWidth(said.width())
