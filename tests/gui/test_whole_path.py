"""A person who has never seen the window: from an empty home to a signed file, by what is there to be clicked."""

import pytest
from PySide6.QtCore import QSettings, Qt
from PySide6.QtWidgets import QPushButton

from labcal.gui.theming.theme import LIGHT
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.window import Window

SHORT = {"magnitudes_nT": "20000", "reverse": "no", "modes": "nominal", "rate_deg_per_s": "20", "zero_s": "3"}


@pytest.mark.slow
def test_from_an_empty_home_to_a_signed_file(qtbot, by_mouse, tmp_path, monkeypatch, patience, windows):
    monkeypatch.setenv("LABCAL_HOME", str(tmp_path))
    window = Window(AppState(QSettings(str(tmp_path / "w.ini"), QSettings.Format.IniFormat)), LIGHT)
    windows.append(window)
    window.show()

    def click(widget):
        qtbot.waitUntil(lambda: widget.isEnabled() and not widget.visibleRegion().isEmpty(), timeout=patience)
        qtbot.mouseClick(widget, Qt.MouseButton.LeftButton)

    def primary(page):
        """The one thing to do on a page."""
        found = [b for b in page.findChildren(QPushButton) if b.objectName() == "primary" and b.isVisible()]
        assert len(found) == 1, [b.text() for b in found]
        return found[0]

    try:
        start = window.page("Start")
        assert start.open.isVisible()
        assert not start.calibrate.isVisible()
        click(start.simulated)
        qtbot.waitUntil(lambda: bool(window.app_state.facts), timeout=patience)
        qtbot.keyClicks(window.top.operator, "J", delay=60)
        qtbot.waitUntil(lambda: window.app_state.lab.state.operator == "J", timeout=patience)
        click(start.calibrate)
        run, live = window.page("Run").choose, window.page("Run").live
        qtbot.waitUntil(lambda: run.form is not None, timeout=patience)
        for name, text in SHORT.items():
            run.form.set_text(name, text)
        run.pace.setCurrentText("at once")
        click(run.start)
        vm = window.app_state.run
        while True:
            qtbot.waitUntil(lambda: vm.state in ("asking", "ended"), timeout=patience)
            if vm.state == "ended":
                break
            by_mouse(live.prompt.choices[vm.prompt.choices[0]])
        assert vm.status == "finished", vm.fault
        click(live.fit)
        study, fit = window.app_state.study_vm, window.page("Fit")
        qtbot.waitUntil(lambda: "ml" in study.fits and not study.busy, timeout=patience)  # it begins by itself
        assert primary(fit).text() == "Trace the residual"
        click(primary(fit))
        qtbot.waitUntil(lambda: study.loop is not None, timeout=patience)
        click(window.page("Loop").sign)
        page = window.page("Certificate")
        qtbot.waitUntil(lambda: page.list.count() == 1, timeout=patience)
        steps = page.steps
        assert "Nobody has a key here" in steps.key.words.text()
        steps.key_name.setText("jdoe@lab")
        for entry in (steps.new_words, steps.again):
            entry.setText("a long passphrase")
        click(steps.new_key)
        qtbot.waitUntil(lambda: "Sign alone: it is valid, and PROV" in steps.signature.words.text(), timeout=patience)
        steps.passphrase.setText("a long passphrase")
        click(steps.sign)
        assert "names no laboratory and no customer" in steps.signature.asked.text()
        click(steps.sign)
        qtbot.waitUntil(lambda: "VALID: signed by jdoe@lab" in page.standing.text(), timeout=patience)
        assert page.paper.words.text() == "As PROVISIONAL: nobody approved it before it was signed."
        page.verify(page.chosen().path)
        qtbot.waitUntil(lambda: page.drop.name.text().startswith("▲"), timeout=patience)
    finally:
        window.leave()
