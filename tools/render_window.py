"""Renders every page of the window, in both themes, with real data of a simulated lab, into docs/images.

    xvfb-run -a python tools/render_window.py [--home DIR] [--only run-prompt,fit] [--pace "at once"] [--out DIR]

A preflight is run through the real worker, fitted, traced and signed; `--home` keeps that lab for the next time.
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
import time
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QSettings, Qt
from PySide6.QtGui import QColor, QImage, QPainter
from PySide6.QtWidgets import QApplication

if TYPE_CHECKING:
    from labcal.gui.theming.theme import Theme

ROOT = Path(__file__).parents[1]
WORDS = "four words for pictures"  # of a key that is thrown away
SIZE, WALL = (1360, 860), (1920, 1080)
SHEETS = {"small": ((1024, 700), False), "desk": ((1920, 1080), False), "4k": ((3840, 2160), True)}  # and F11
PAGES = ("Start", "Bench", "Run", "Fit", "Loop", "Certificate", "History")
SHEET_PX, ACROSS, GAP_PX = 620, 2, 8  # of one page on a sheet, how many stand beside each other, and between them
PULLED = {
    "axes": "z",
    "modes": "nominal",
    "magnitudes_nT": "20000",
    "rate_deg_per_s": "20",
    "zero_s": "2",
    "dwell_s": "1",
}
METHODS = ("ml", "centered", "twostep", "ekf", "foster-elkaim")
NAMES = (
    "start",
    "bench",
    "run-choose",
    "run-prompt",
    "run-prompt-wall",
    "run-live",
    "run-over",
    "fault",
    "fit",
    "loop",
    "certificate",
    "history",
    "pages",
)


def small(image: QImage, kept: list[int]) -> QImage:
    """The same picture in 256 colours, a third of the file: those `kept` and its own most frequent ones."""
    whole = image.convertToFormat(QImage.Format.Format_RGB32)
    pixels = np.frombuffer(whole.constBits(), np.uint32).reshape(whole.height(), -1)
    colours, counts = np.unique(pixels, return_counts=True)
    frequent = [int(colour) for colour in colours[np.argsort(counts)[::-1]]]
    table = list(dict.fromkeys(kept + frequent))[:256]
    return whole.convertToFormat(QImage.Format.Format_Indexed8, table, Qt.ImageConversionFlag.ThresholdDither)


class Studio:
    """One window, and the patience to wait for it."""

    def __init__(self, home: Path, out: Path, only: tuple[str, ...], pace: str) -> None:
        from labcal.gui.theming.theme import DARK, LIGHT
        from labcal.gui.viewmodels.app_state import AppState
        from labcal.gui.window import Window

        self.themes, self.out, self.only = (LIGHT, DARK), out, only
        settings = QSettings(str(home / "render.ini"), QSettings.Format.IniFormat)
        settings.clear()
        settings.setValue("pace", pace)
        settings.setValue("seed", 3)
        self.app_state = AppState(settings)
        self.window = Window(self.app_state, LIGHT)
        self.window.resize(*SIZE)
        self.window.show()
        self.app_state.set_identity(operator="J. Doe", dut="EM-07")
        self.app_state.open_bench(str(ROOT / "examples" / "simulated.toml"))
        self.wait(lambda: bool(self.app_state.facts))

    def wait(self, until: Callable[[], bool], seconds: float = 3600) -> None:
        """Let the window live until something is so."""
        end = time.monotonic() + seconds
        while not until():
            if time.monotonic() > end:
                sys.exit("waited too long")
            QApplication.processEvents()
            time.sleep(0.005)

    def live(self, seconds: float) -> None:
        """Let the window live for a moment."""
        end = time.monotonic() + seconds
        self.wait(lambda: time.monotonic() > end)

    def shoot(self, name: str, page: str, size: tuple[int, int] = SIZE) -> None:
        """One picture in each theme."""
        if self.only and name not in self.only:
            return
        for theme in self.themes:
            self.window.resize(*size)
            self.window.set_theme(theme)
            self.window.open_page(page)
            self.window.style_queue.finish()
            self.window.sidebar.setFocus()
            self.live(1.5 if self.app_state.run.state == "asking" else 0.5)  # its buttons are grey for a second
            self.wait(lambda: not self.app_state.quick_worker.busy)
            self.live(0.7)
            if (self.window.width(), self.window.height()) != size:
                print(f"{name}: {self.window.width()} x {self.window.height()}, wider or higher than {size}")
            self.keep(self.window.grab().toImage(), theme, self.out / f"{name}-{theme.name}.png")

    def sheets(self) -> None:
        """Every page at three sizes, those of one size on one sheet."""
        for name, (size, wall) in SHEETS.items():
            if wall != self.window.wall:
                self.window.toggle_wall()
            seen = [self.small_page(page, size) for page in PAGES]
            high = max(one.height() for one in seen) + GAP_PX
            rows = -(-len(seen) // ACROSS)
            sheet = QImage((SHEET_PX + GAP_PX) * ACROSS, high * rows, QImage.Format.Format_RGB32)
            sheet.fill(QColor(self.themes[0].line))
            with QPainter(sheet) as painter:
                for n, one in enumerate(seen):
                    painter.drawImage((n % ACROSS) * (SHEET_PX + GAP_PX), (n // ACROSS) * high, one)
            self.keep(sheet, self.themes[0], self.out / f"pages-{name}.png")
        self.window.toggle_wall()
        self.window.style_queue.finish()
        self.live(1.0)

    def small_page(self, page: str, size: tuple[int, int]) -> QImage:
        """One page at a size, made small for a sheet."""
        self.window.resize(*size)
        self.window.set_theme(self.themes[0])
        self.window.open_page(page)
        self.live(1.0)
        self.wait(lambda: not self.app_state.quick_worker.busy)
        self.window.style_queue.finish()
        self.live(0.7)
        image = self.window.grab().toImage()
        return image.scaledToWidth(SHEET_PX, Qt.TransformationMode.SmoothTransformation)

    def keep(self, image: QImage, theme: Theme, file: Path) -> None:
        """Write a picture, as small as it may be."""
        kept = [QColor(getattr(theme, name)).rgb() for name in theme.__dataclass_fields__ if name != "name"]
        small(image, kept).save(str(file))
        print(file.relative_to(ROOT) if file.is_relative_to(ROOT) else file, file.stat().st_size // 1024, "kB")

    def wants(self, *names: str) -> bool:
        """Whether any of these pictures is asked for."""
        return not self.only or bool(set(names) & set(self.only))

    def preflight(self) -> str:
        """A whole preflight, with pictures on the way; returns its run id."""
        run = self.app_state.run
        self.app_state.start("preflight", {})
        live = False
        while True:
            self.wait(lambda: run.state in ("asking", "ended") or self.in_the_middle_of("z"))
            if run.state == "ended":
                return run.run_id
            if run.prompt is not None and run.state == "asking":
                if run.prompt.key == "mount-y":
                    self.shoot("run-prompt", "Run")
                    self.window.toggle_wall()
                    self.shoot("run-prompt-wall", "Run", WALL)
                    self.window.toggle_wall()
                run.answer(run.prompt.choices[0])
            elif not live:
                self.shoot("run-live", "Run")
                live = True
            else:
                self.live(0.1)

    def in_the_middle_of(self, axis: str) -> bool:
        """Whether a turn about this body axis is more than half done."""
        run = self.app_state.run
        return run.segment is not None and run.segment.startswith(axis) and run.coverage() > 0.6

    def study(self, run: str) -> None:
        """Fits and the loop, drawn."""
        study = self.app_state.study_vm
        study.open(run)
        self.wait(lambda: not study.busy)
        if self.wants("fit", "pages"):
            study.fit(*METHODS)
            self.wait(lambda: not study.busy)
            self.shoot("fit", "Fit")
        if self.wants("loop", "pages"):
            study.close_loop()
            self.wait(lambda: not study.busy)
            self.shoot("loop", "Loop")

    def sign(self) -> None:
        """Two keys, one approval, one signature."""
        from labcal.gui.ipc.messages import Approve, ListCalibrations, NewKey, Sign

        done: list[object] = []
        self.app_state.request(ListCalibrations(), done.append)
        self.wait(lambda: bool(done))
        files = done[0]
        assert isinstance(files, tuple)
        if files and not files[0].standing.signatures:
            path = files[0].path
            worker = self.app_state.quick_worker
            worker.request(NewKey("jdoe@lab", WORDS), done.append, done.append)
            worker.request(Approve(path, "A. Smith"), done.append, done.append)
            worker.request(Sign(path, "jdoe@lab", WORDS), done.append, done.append)
            self.wait(lambda: len(done) == 4)


def main() -> None:
    """Render what is asked for."""
    from labcal.gui.theming.font import interface_font

    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--home", type=Path, help="where the rendered lab lives (default: a temporary folder)")
    parser.add_argument("--only", default="", help=f"some of {','.join(NAMES)}")
    parser.add_argument("--out", type=Path, default=ROOT / "docs" / "images")
    parser.add_argument("--pace", default="100 times", help="of the simulated lab; at once, there is no run-live")
    given = parser.parse_args()
    home = given.home or Path(tempfile.mkdtemp(prefix="labcal-render-"))
    given.out.mkdir(parents=True, exist_ok=True)
    os.environ["LABCAL_HOME"] = str(home)
    application = QApplication(sys.argv[:1])
    application.setFont(interface_font(application.font()))
    studio = Studio(home, given.out, tuple(name for name in given.only.split(",") if name), given.pace)
    render(studio)
    studio.window.close()
    application.quit()


def render(studio: Studio) -> None:
    """What is asked for."""
    if studio.wants(*(name for name in NAMES if name != "fault")):
        the_work(studio)
    if studio.wants("fault"):
        with_a_plug_pulled(studio)


def the_work(studio: Studio) -> None:
    """All pages in the order of the work."""
    from labcal.gui.ipc.answers import RunLine
    from labcal.gui.ipc.messages import ListRuns
    from labcal.gui.pages.bench import BenchPage

    app_state = studio.app_state
    studio.shoot("run-choose", "Run")
    if studio.wants("bench"):
        bench = studio.window.page("Bench")
        assert isinstance(bench, BenchPage)
        bench.check_all()
        studio.live(8)
    runs: list[tuple[RunLine, ...]] = []
    app_state.request(ListRuns(), runs.append)
    studio.wait(lambda: bool(runs))
    finished = [one.run_id for one in runs[0] if one.status == "finished"]
    run = (
        finished[0]
        if finished and not studio.wants("run-prompt", "run-prompt-wall", "run-live", "run-over")
        else studio.preflight()
    )
    studio.shoot("run-over", "Run")
    studio.shoot("start", "Start")
    studio.shoot("bench", "Bench")
    if studio.wants("fit", "loop", "pages"):
        studio.study(run)
    if studio.wants("certificate", "history", "pages"):
        studio.sign()
        studio.shoot("certificate", "Certificate")
        studio.shoot("history", "History")
    if studio.wants("pages"):
        studio.sheets()


def with_a_plug_pulled(studio: Studio) -> None:
    """A run on the same lab, served on ports of this computer: the reference's plug is pulled in a turn."""
    sys.path.insert(0, str(ROOT / "tests" / "campaign"))
    sys.path.insert(0, str(ROOT / "tests" / "runner"))
    bench = import_module("benches").Bench("tti", served=True)
    app_state, run = studio.app_state, studio.app_state.run
    try:
        app_state.open_bench(str(bench.file))
        studio.wait(lambda: app_state.bench == str(bench.file) and app_state.facts is not None)
        app_state.start("preflight", PULLED)
        while not studio.in_the_middle_of("z"):
            studio.live(0.1)
            if run.state == "asking" and run.prompt is not None:
                run.answer(run.prompt.choices[0])
        bench.ask("unplug", name="reference")
        studio.wait(lambda: run.state == "asking", 60)
        studio.shoot("fault", "Run")
        run.answer("stop")
        studio.wait(lambda: run.state == "ended", 60)
    finally:
        bench.close()


if __name__ == "__main__":
    main()
