"""Fit, loop, certificate, history, bench and start on a run that was made once, through the real workers."""

from datetime import UTC, datetime
from pathlib import Path

import pytest
from PySide6.QtCore import QSettings, Qt

LONG_MS = 90_000
BENCH = Path(__file__).parents[2] / "examples" / "simulated.toml"
SHORT = {"axes": "x,y,z", "magnitudes_nT": "20000", "reverse": "no", "modes": "nominal", "rate_deg_per_s": "20"}


@pytest.fixture(scope="module")
def lab(tmp_path_factory, qapp):
    """A window whose store has one short preflight; the tests below go on from one another's work."""
    from labcal import session
    from labcal.bench.clock import VirtualClock
    from labcal.gui.desk import Desk
    from labcal.gui.theme import LIGHT
    from labcal.gui.window import Window

    home = tmp_path_factory.mktemp("home")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("LABCAL_HOME", str(home))
        clock = VirtualClock(datetime(2026, 1, 5, tzinfo=UTC))
        session.run("preflight", BENCH, SHORT | {"zero_s": "3"}, dut="EM-07", operator="J. Doe", clock=clock, seed=3)
        window = Window(Desk(QSettings(str(home / "w.ini"), QSettings.Format.IniFormat)), LIGHT)
        window.show()
        window.desk.open_bench(str(BENCH))
        window.desk.who(dut="EM-07", operator="J. Doe")
        window.home = str(home)
        yield window
        window.close()


@pytest.fixture(autouse=True)
def in_its_home(lab, monkeypatch):
    """Every test is in the lab's home, not in one of its own."""
    monkeypatch.setenv("LABCAL_HOME", lab.home)


def test_the_start_page_says_what_holds(qtbot, lab):
    lab.open_page("Start")
    page = lab.page("Start")
    qtbot.waitUntil(lambda: "PASS" in page.facts["closing"][0].text(), timeout=LONG_MS)
    assert "closure" in page.facts["closing"][1].text()
    assert "1 in the store" in page.facts["runs"][0].text()
    assert page.interrupted.isHidden()
    qtbot.waitUntil(page.morning.isEnabled, timeout=LONG_MS)


def test_morning_check_opens_its_form(qtbot, lab):
    qtbot.mouseClick(lab.page("Start").morning, Qt.MouseButton.LeftButton)
    choose = lab.page("Run").choose
    qtbot.waitUntil(lambda: choose.form is not None, timeout=LONG_MS)
    assert choose.list.currentItem().text() == "axes-check"


def test_every_instrument_answers_on_the_bench_page(qtbot, lab):
    lab.open_page("Bench")
    page = lab.page("Bench")
    qtbot.waitUntil(page.check.isEnabled, timeout=LONG_MS)
    qtbot.mouseClick(page.check, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: page.table.item(0, 5).text() == "✓ answers", timeout=LONG_MS)
    assert [page.table.item(row, 5).text() for row in range(7)] == ["✓ answers"] * 7
    assert "THURLBY" in page.table.item(0, 4).text().upper()
    assert all(light == "ok" for _, light, _ in lab.desk.lab.state.lights)


def test_a_run_is_opened_from_the_history_and_fitted(qtbot, lab):
    lab.open_page("History")
    history = lab.page("History")
    qtbot.waitUntil(lambda: history.table.rowCount() == 1, timeout=LONG_MS)
    history.search.setText("another")
    assert history.table.rowCount() == 0
    history.search.setText("em-07 preflight")
    history.table.selectRow(0)
    qtbot.mouseClick(history.open, Qt.MouseButton.LeftButton)
    page = lab.page("Fit")
    qtbot.waitUntil(page.fit.isEnabled, timeout=LONG_MS)
    qtbot.mouseClick(page.fit, Qt.MouseButton.LeftButton)
    study = lab.desk.study_vm
    qtbot.waitUntil(lambda: "ml" in study.fits or study.fault is not None, timeout=LONG_MS)
    assert study.fault is None
    fit = lab.desk.study_vm.fits["ml"]["fit"]
    assert fit["ok"]
    assert page.table.item(0, 0).text() == "ml"
    assert page.table.item(0, 10).text() == "known"
    assert page.against.count() > 5


def test_the_loop_tells_its_story_and_leaves_a_draft(qtbot, lab):
    qtbot.mouseClick(lab.page("Fit").trace, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: lab.desk.study_vm.loop is not None, timeout=LONG_MS)
    page, loop = lab.page("Loop"), lab.desk.study_vm.loop["loop"]
    assert page.story.isVisible()
    assert loop["verdict"].upper().replace("-", " ") in page.verdict.text().replace("-", " ")
    assert page.summary.text() == loop["summary"]
    assert "→" in page.before_after.text()
    assert Path(lab.desk.study_vm.loop["draft"]).is_file()


def test_a_draft_is_approved_signed_and_verified_by_two(qtbot, lab):
    lab.open_page("Certificate")
    page = lab.page("Certificate")
    qtbot.waitUntil(lambda: page.list.count() == 1, timeout=LONG_MS)
    page.approver.setText("A. Smith")
    qtbot.mouseClick(page.approve, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: "A. Smith" in page.standing.text(), timeout=LONG_MS)
    page.signer.setCurrentText("jdoe@lab")
    page.passphrase.setText("a long passphrase")
    qtbot.mouseClick(page.new_key, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(page.sign.isEnabled, timeout=LONG_MS)
    qtbot.mouseClick(page.sign, Qt.MouseButton.LeftButton)
    assert page.passphrase.text() == ""
    qtbot.waitUntil(lambda: "VALID: signed by jdoe@lab" in page.standing.text(), timeout=LONG_MS)
    assert "PROVISIONAL" in page.standing.text()
    assert not page.approve.isEnabled()
    page.verify(page.chosen()["path"])
    qtbot.waitUntil(lambda: page.drop.words.text().startswith("✓"), timeout=LONG_MS)


def test_a_changed_file_that_is_dropped_is_not_valid(qtbot, lab, tmp_path):
    page = lab.page("Certificate")
    path = Path(page.chosen()["path"])
    copy = tmp_path / path.name
    copy.write_bytes(path.read_bytes().replace(b"J. Doe", b"J. Dot"))
    copy.with_name(copy.name + ".sshsig").write_bytes(path.with_name(path.name + ".sshsig").read_bytes())
    page.verify(str(copy))
    qtbot.waitUntil(lambda: page.drop.words.text().startswith("✕"), timeout=LONG_MS)


def test_a_wrong_passphrase_is_a_card_with_words(qtbot, lab):
    page = lab.page("Certificate")
    page.signer.setCurrentText("jdoe@lab")
    page.passphrase.setText("wrong")
    qtbot.mouseClick(page.sign, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(page.fault.isVisible, timeout=LONG_MS)
    assert "Traceback" not in page.fault.text.text()


def test_the_trend_of_a_dut_is_drawn(qtbot, lab):
    lab.open_page("History")
    history = lab.page("History")
    qtbot.waitUntil(history.plot.isVisible, timeout=LONG_MS)
    assert "EM-07" in history.trend_heading.text()
    assert history._runs[0]["verdict"]


def test_another_theme_and_the_wall_size_keep_what_is_known(qtbot, lab):
    from labcal.gui.theme import DARK

    lab.open_page("Fit")
    lab.set_theme(DARK)
    assert lab.page("Fit").table.item(0, 0).text() == "ml"
    before = lab.rail.width()
    lab.toggle_wall()
    assert lab.rail.width() > 1.5 * before


@pytest.mark.parametrize("name", ["Start", "Bench", "Run", "Fit", "Loop", "Certificate", "History"])
def test_f12_is_heard_on_every_page(qtbot, lab, name):
    lab.open_page(name)
    with qtbot.waitSignal(lab.coils_off, timeout=2000):
        qtbot.keyClick(lab.later[name], Qt.Key.Key_F12)
