"""Bench: every instrument by role with who answered, over which link, and what to do where none did; the cage."""

from __future__ import annotations

from typing import Any

import numpy as np
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QFileDialog, QHBoxLayout, QVBoxLayout, QWidget

from labcal.gui.cage_view import CageView
from labcal.gui.desk import Desk
from labcal.gui.fault_card import FaultCard
from labcal.gui.lab_vm import LabState, Triple
from labcal.gui.measurement_table import Table
from labcal.gui.numbers import number
from labcal.gui.theme import GRID, Theme
from labcal.gui.widgets import Card, button, label
from labcal.gui.wire import Fault

READINGS_MS = 500
ROLES = ("coil-x", "coil-y", "coil-z", "polarity", "platform", "reference", "dut")
HEADINGS = ("role", "instrument", "link", "who answered", "last reading", "state and what to do")


class BenchPage(QWidget):
    """The bench file's instruments, checked at a click; the cage with the field of now."""

    def __init__(self, desk: Desk, theme: Theme) -> None:
        super().__init__()
        self._desk, self._theme = desk, theme
        column = QVBoxLayout(self)
        column.setContentsMargins(2 * GRID, 2 * GRID, 2 * GRID, 2 * GRID)
        column.setSpacing(2 * GRID)
        self.fault = FaultCard()
        self.fault.report_asked.connect(desk.report_asked)
        column.addWidget(self.fault)
        column.addWidget(self._instruments_card(), 3)
        column.addWidget(self._cage_card(), 2)
        desk.bench_changed.connect(self._bench_known)
        desk.lab.changed.connect(self._show_cage)
        self._readings = QTimer(self, interval=READINGS_MS)
        self._readings.timeout.connect(self._show_readings)
        self._bench_known()

    def showEvent(self, event: object) -> None:
        """Readings as they come, while somebody looks."""
        self._readings.start()
        self._show_readings()

    def hideEvent(self, event: object) -> None:
        """Nobody looks."""
        self._readings.stop()

    def _instruments_card(self) -> Card:
        card = Card(self.tr("Instruments"), "")
        self.heading = card.heading
        self.check = button(
            self.tr("Check all"),
            self.tr("Ask every instrument who it is. Nothing is energised or moved."),
            primary=True,
        )
        self.check.clicked.connect(self.check_all)
        self.reconnect = button(
            self.tr("Reconnect"),
            self.tr("Let go of every link, read the bench file again and ask every instrument who it is"),
        )
        self.reconnect.clicked.connect(self._reconnect)
        choose = button(self.tr("Open a bench file …"), self.tr("A bench.toml: what stands in the lab, on which lines"))
        choose.clicked.connect(self._choose)
        simulated = button(self.tr("Simulated lab"), self.tr("A whole lab without hardware"))
        simulated.clicked.connect(lambda: desk_simulated(self._desk))
        self.file = label("", "caption")
        row = QHBoxLayout()
        row.addWidget(self.file, 1)
        for widget in (simulated, choose, self.reconnect, self.check):
            row.addWidget(widget)
        self.table = Table(HEADINGS, stretch=5)
        self.empty = label(self.tr("Open a bench file, or take the simulated lab."), "ask")
        card.body.addWidget(self.empty)
        card.body.addWidget(self.table, 1)
        card.body.addLayout(row)
        return card

    def _cage_card(self) -> Card:
        card = Card(self.tr("The cage"), self.tr("all arrows to one scale"))
        self.cage, self.cage_words = CageView(self._theme), label("", wrap=True)
        row = QHBoxLayout()
        row.addWidget(self.cage, 4)
        row.addWidget(self.cage_words, 1)
        card.body.addLayout(row, 1)
        return card

    def _choose(self) -> None:
        path, _ = QFileDialog.getOpenFileName(self, self.tr("Open a bench file"), "", "*.toml")
        if path:
            self._desk.open_bench(path)

    def check_all(self) -> None:
        """Ask every instrument who it is."""
        if self._desk.run.alive:
            return self.fault.show_fault(
                Fault("input", self.tr("A run goes on and holds the instruments; check them after it."))
            )
        self.check.setEnabled(False)
        self.check.setText(self.tr("Asking …"))
        return self._desk.switch.ask("greet", self._greeted, self._not_greeted, bench=self._desk.bench)

    def _reconnect(self) -> None:
        if not self._desk.run.alive:
            for worker in (self._desk.bench_worker, self._desk.switch):
                worker.hang_up(500)
            self._desk.open_bench(self._desk.bench)
        self.check_all()

    def _greeted(self, answers: list[dict[str, Any]]) -> None:
        self._desk.take_greetings(answers)
        self._checked()

    def _not_greeted(self, fault: Fault) -> None:
        self.fault.show_fault(fault)
        self._checked()

    def _checked(self) -> None:
        self.check.setEnabled(True)
        self.check.setText(self.tr("Check all"))
        self._show()

    def _bench_known(self) -> None:
        self._show()
        self._show_cage(self._desk.lab.state)

    def _show(self) -> None:
        facts = self._desk.facts
        there = sorted(facts.get("instruments", {}).items(), key=lambda one: ROLES.index(one[1]["role"]))
        self.heading.setText(self.tr("Instruments of {0}").format(facts["name"]) if facts else self.tr("Instruments"))
        self.file.setText(self._desk.bench)
        self.empty.setVisible(not there)
        self.table.setVisible(bool(there))
        for widget in (self.check, self.reconnect):
            widget.setEnabled(bool(there))
        self.table.setRowCount(len(there))
        for row, (name, one) in enumerate(there):
            self._show_row(row, name, one)

    def _show_row(self, row: int, name: str, one: dict[str, Any]) -> None:
        answered = self._desk.answered.get(name)
        fault = answered["fault"] if answered else None
        for column, text in enumerate((one["role"], name, one["link"])):
            self.table.set_cell(row, column, text, tip=f"{text}   ({one['driver']})")
        self.table.set_cell(row, 3, (answered or {}).get("identity") or "–")
        if answered is None:
            self.table.set_cell(row, 5, self.tr("○ not asked yet"), colour=self._theme.muted)
        elif fault:
            self.table.set_cell(row, 5, f"✕ {fault['text']} {fault['remedy']}", colour=self._theme.bad)
        else:
            self.table.set_cell(row, 5, self.tr("✓ answers"), colour=self._theme.good)

    def _show_readings(self) -> None:
        """What each instrument sent last, with the seconds since."""
        run = self._desk.run
        for row in range(self.table.rowCount()):
            role, name = self.table.text(row, 0), self.table.text(row, 1)
            source = "cage" if role.startswith("coil") else name
            said = run.reading.get(source)
            words = "–" if said is None else reading_words(role, *said)
            age = f"{run.silent_s(source):.1f} s" if said is not None else self.tr("nothing in this session")
            self.table.set_cell(row, 4, words, tip=self.tr("{0} before the newest of all: {1}").format(age, words))

    def _show_cage(self, state: LabState) -> None:
        cage = self._desk.facts.get("cage")
        applied: Triple | None = None
        if cage and state.coil_A is not None:
            x, y, z = np.asarray(cage["matrix"]) @ np.asarray(state.coil_A)
            applied = float(x), float(y), float(z)
        total = state.field_measured_nT
        ambient = None
        if applied is not None and total is not None:
            ambient = (total[0] - applied[0], total[1] - applied[1], total[2] - applied[2])
        self.cage.show_vectors(applied, ambient, total)
        if cage:
            limits = cage["limits"]
            most = ", ".join(f"{one:g}" for one in limits["current_A"])
            words = self.tr("Limits\n{0} A (x, y, z)\n{1} nT at the centre").format(
                most, number(limits["field_nT"], 0, signed=False)
            )
            seen = self.tr("Nothing measured yet: vectors appear with a run.") if total is None else ""
            self.cage_words.setText(f"{words}\n\n{seen}")


def desk_simulated(desk: Desk) -> None:
    """Take the simulated lab."""
    desk.ask("simulated_bench", desk.open_bench)


def reading_words(role: str, columns: tuple[str, ...], values: Any) -> str:
    """The last sample of an instrument, short: a coil's own current, else every value."""
    if role.startswith("coil"):
        at = columns.index(f"i_coil_{role[-1]}") if f"i_coil_{role[-1]}" in columns else 0
        return f"{number(float(values[at]), 3)} A"
    unit = {"dut": "", "reference": " nT", "platform": "°"}.get(role, "")
    return "  ".join(number(float(value), 1) for value in values[:3]) + unit
