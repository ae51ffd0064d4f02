"""A whole preflight by keys alone: from an empty home to a signed, reported, verified and exported run."""

from functools import partial

import pytest
from PySide6.QtCore import QSettings, Qt, QTimer
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QApplication, QFileDialog, QLineEdit
from shiboken6 import isValid

from labcal.gui.theming.theme import LIGHT
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.widgets.hold_button import LET_GO_MS
from labcal.gui.window import Window

SHORT = {"magnitudes_nT": "20000", "modes": "nominal", "rate_deg_per_s": "20", "zero_s": "3"}
MOST = 150


class Hands:
    """Ten fingers, and eyes: whatever is struck goes to what has the focus; nothing of the window is called."""

    def __init__(self, window, bot, patience):
        self.window, self.bot, self.patience = window, bot, patience

    def until(self, seen):
        self.bot.waitUntil(seen, timeout=self.patience)

    def strike(self, *keys, modifier=Qt.KeyboardModifier.NoModifier):
        """One key after another, each too late to be of the same burst as the one before."""
        for key in keys:
            self.bot.keyClick(QApplication.focusWidget() or self.window, key, modifier)
            self.window.scanner.flush()

    def write(self, text):
        """Over whatever stands there."""
        self.strike(Qt.Key.Key_A, modifier=Qt.KeyboardModifier.ControlModifier)
        self.strike(*text)

    def to(self, wanted):
        """Tab until `wanted`, which may be pressed or written into, has the focus."""
        self.until(lambda: wanted.isVisible() and wanted.isEnabled())
        for _ in range(MOST):
            if QApplication.focusWidget() is wanted:
                return
            self.strike(Qt.Key.Key_Tab)
        raise AssertionError(f"Tab never comes to {wanted.objectName() or wanted}")

    def press(self, button):
        self.to(button)
        self.strike(Qt.Key.Key_Space)

    def enter(self, field, text):
        self.to(field)
        self.write(text)

    def page(self, number):
        self.strike(Qt.Key(Qt.Key.Key_0 + number), modifier=Qt.KeyboardModifier.ControlModifier)

    def choose(self, row, of):
        """In a list or a chooser, by Home and Down."""
        self.to(of)
        self.strike(Qt.Key.Key_Home, *[Qt.Key.Key_Down] * row)

    def name_a_file(self, button, path):
        """Press what asks for a file, and write its name into what comes up."""
        named = []

        def write():
            box = QApplication.activeModalWidget()
            if not isinstance(box, QFileDialog) or not box.isAncestorOf(QApplication.focusWidget() or self.window):
                return QTimer.singleShot(20, write)
            named.append(type(QApplication.focusWidget()))
            QApplication.clipboard().setText(str(path))  # typed, it would bring up Qt's list of names like it
            for key in (Qt.Key.Key_A, Qt.Key.Key_V):
                self.strike(key, modifier=Qt.KeyboardModifier.ControlModifier)
            return self.confirm(box)

        QTimer.singleShot(0, write)
        self.press(button)
        self.until(lambda: bool(named) and QApplication.activeModalWidget() is None)
        assert named == [QLineEdit]
        self.window.activateWindow()  # as every desktop does, where there is one
        self.until(lambda: QApplication.focusWidget() is not None)

    def confirm(self, box, times=100):
        """Return, again where the box was still reading the folder; one that takes no name is put away."""
        self.strike(Qt.Key.Key_Return)
        if isValid(box) and box.isVisible():
            QTimer.singleShot(50, partial(self.confirm, box, times - 1) if times else box.reject)

    def answer(self, run):
        """The first answer of every question by its own key, held, until the run has ended."""
        while True:
            self.until(lambda: run.state in ("asking", "ended"))
            if run.state == "ended":
                return
            asked = run.prompt
            answer = self.window.page("Run").live.prompt.choices[asked.choices[0]]
            self.until(answer.isEnabled)
            self.bot.wait(LET_GO_MS)  # else the key counts as held since the question before
            self.bot.keyPress(QApplication.focusWidget() or self.window, Qt.Key.Key_F8)
            self.until(lambda before=asked: run.prompt is not before)
            self.bot.keyRelease(QApplication.focusWidget() or self.window, Qt.Key.Key_F8)


@pytest.fixture
def hands(qtbot, tmp_path, monkeypatch, patience, windows):
    monkeypatch.setenv("LABCAL_HOME", str(tmp_path / "home"))  # nothing is written into it but by labcal itself
    window = Window(AppState(QSettings(str(tmp_path / "w.ini"), QSettings.Format.IniFormat)), LIGHT)
    windows.append(window)
    window.show()
    window.activateWindow()
    yield Hands(window, qtbot, patience)
    window.leave()


@pytest.mark.slow
def test_a_preflight_from_the_box_to_the_verified_file_without_a_mouse(hands, tmp_path, monkeypatch):
    opened = []
    monkeypatch.setattr(QDesktopServices, "openUrl", lambda url: opened.append(url.toLocalFile()))
    measured(hands)
    fitted_and_traced(hands)
    signed(hands)
    page = hands.window.page("Certificate")
    hands.name_a_file(page.paper.report, tmp_path / "report.html")
    hands.until(lambda: opened == [str(tmp_path / "report.html")])
    assert "EM-07" in (tmp_path / "report.html").read_text(encoding="utf-8")
    hands.name_a_file(page.drop.choose, page.chosen().path)
    hands.until(lambda: page.drop.name.text().startswith("✓"))
    assert "VALID: signed by a.smith, jdoe@lab." in page.drop.words.text()
    hands.page(7)
    history = hands.window.page("History")
    hands.until(lambda: history.table.rowCount() == 1)
    hands.to(history.table)
    hands.strike(Qt.Key.Key_Space)
    hands.name_a_file(history.export, tmp_path / "run.zip")
    hands.until(lambda: bool(history.said.text()) or history.fault.isVisible())
    assert not history.fault.isVisible(), history.fault.text.text()
    assert (tmp_path / "run.zip").is_file()


def measured(hands):
    """Serial, operator, bench, procedure, form, Start, and every question."""
    window, start = hands.window, hands.window.page("Start")
    hands.press(start.simulated)
    hands.until(lambda: bool(window.app_state.facts))
    hands.enter(window.top.dut, "EM-07")
    hands.strike(Qt.Key.Key_Return)
    hands.write("J. Doe")
    assert (window.app_state.lab.state.dut_serial, window.app_state.lab.state.operator) == ("EM-07", "J. Doe")
    hands.page(3)
    choose = window.page("Run").choose
    hands.until(lambda: choose.list.count() > 0)
    items = [choose.list.item(row) for row in range(choose.list.count())]
    names = [one.text() for one in items if one.flags() & Qt.ItemFlag.ItemIsSelectable]
    hands.choose(names.index("preflight"), choose.list)
    hands.press(choose.form.more)
    for name, text in SHORT.items():
        hands.enter(choose.form.fields[name], text)
    hands.press(choose.form.fields["reverse"])
    assert choose.form.given() == SHORT | {"reverse": "no"}
    hands.choose(3, choose.pace)
    assert choose.pace.currentData() == "at once"
    hands.press(choose.start)
    hands.answer(window.app_state.run)
    assert window.app_state.run.status == "finished", window.app_state.run.fault


def fitted_and_traced(hands):
    """Fit, another view of it, the loop, and one of its causes picked."""
    window, study = hands.window, hands.window.app_state.study_vm
    hands.press(window.page("Run").live.fit)
    hands.until(lambda: "ml" in study.fits and not study.busy)
    fit = window.page("Fit")
    hands.choose(1, fit.views.view)
    assert fit.views.shown() == "residual"
    hands.press(fit.trace)
    hands.until(lambda: study.loop is not None or study.fault is not None)
    assert study.fault is None
    loop = window.page("Loop")
    hands.until(lambda: loop.others.rowCount() > 0)
    hands.choose(1, loop.others)
    hands.until(lambda: loop.picked() is not None)
    hands.until(lambda: not study.busy)
    hands.press(loop.sign)


def signed(hands):
    """Approved by another person, then signed by both, each under a new key."""
    page = hands.window.page("Certificate")
    hands.until(lambda: page.list.count() == 1)
    steps = page.steps
    for name in ("a.smith", "jdoe@lab"):
        hands.enter(steps.key_name, name)
        for entry in (steps.new_words, steps.again):
            hands.enter(entry, f"sixteen reasons of {name}")
        hands.press(steps.new_key)
        hands.until(lambda n=name: n in steps.key.done.text())
    hands.enter(steps.approver, "j.doe")
    assert "is the operator" in steps.approval.wrong.text()
    hands.enter(steps.approver, "a.smith")
    hands.press(steps.approve)
    hands.until(lambda: "approved by a.smith" in page.standing.text())
    for name in ("a.smith", "jdoe@lab"):
        hands.until(lambda n=name: n in [steps.signer.itemText(row) for row in range(steps.signer.count())])
        if steps.signature.folded:  # one signature makes it valid: nothing is to be done any more, but it may be
            hands.press(steps.signature.unfold)
        hands.choose(steps.signer.findText(name), steps.signer)
        hands.enter(steps.passphrase, f"sixteen reasons of {name}")
        hands.press(steps.sign)
        if not page.chosen().standing.signatures:
            assert "names no laboratory and no customer" in steps.signature.asked.text()
            hands.press(steps.sign)
        hands.until(lambda n=name: page.chosen() is not None and n in page.chosen().standing.signers)
    assert "PROVISIONAL" not in page.standing.text()
