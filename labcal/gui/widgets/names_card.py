"""Who is named on a certificate: laboratory and customer; to be stated and changed until it is signed."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QGridLayout, QHBoxLayout, QLineEdit

from labcal.gui.ipc.answers import CalibrationFile
from labcal.gui.ipc.customer_messages import Named, Party, StateNames, WhoIsNamed
from labcal.gui.ipc.wire import Fault
from labcal.gui.theming.theme import GRID
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.countries import country_code
from labcal.gui.widgets.common import Card, button, label, set_state
from labcal.gui.widgets.fault_card import FaultCard
from labcal.gui.widgets.kept_focus import focus_kept_in

SHARES = (4, 2, 2)  # of the width: name, city, country
Fields = tuple[QLineEdit, ...]


class NamesCard(Card):
    """A row of fields for each of the two who is not stated, or is to be changed; away after the first signature.

    `heard`: called when it is known, or known anew, who is named; with whether somebody stated it who waits here.
    """

    def __init__(self, app_state: AppState, fault: FaultCard, heard: Callable[[bool], object]) -> None:
        super().__init__(self.tr("Named on the certificate"))
        self._app_state, self._fault, self._heard = app_state, fault, heard
        self._one: CalibrationFile | None = None
        self.named: Named | None = None  # before it is known
        self._changes = False  # who is stated already
        self._grid = QGridLayout()
        self._grid.setSpacing(GRID)
        self.laboratory = self._row(
            0,
            self.tr("Laboratory on the certificate"),
            self.tr("The laboratory is asked for once. Its logo: logo.png or logo.svg in labcal's folder."),
        )
        self.customer = self._row(
            1, self.tr("Customer on the certificate"), self.tr("For no customer in particular? Leave it empty.")
        )
        self.keep = button(self.tr("Keep"), self.tr("The laboratory is remembered for every certificate"))
        self.keep.clicked.connect(self._keep)
        self.stated, self.wrong = label("", wrap=True), label("", wrap=True)
        set_state(self.wrong, "bad")
        self.change = button(self.tr("Change …"), self.tr("State the laboratory, or the customer, anew"))
        self.change.clicked.connect(self._change)
        row = QHBoxLayout()
        row.addWidget(self.stated, 1)
        row.addWidget(self.change)
        self.body.addLayout(row)
        for column, share in enumerate(SHARES):
            self._grid.setColumnStretch(column, share)
        self._grid.addWidget(self.keep, 0, len(SHARES), 2, 1, Qt.AlignmentFlag.AlignVCenter)
        self.body.addLayout(self._grid)
        self.body.addWidget(self.wrong)
        for field in (*self.laboratory, *self.customer):
            field.textChanged.connect(self._check)
        self._check()
        self.hide()

    def _row(self, row: int, who: str, tip: str) -> Fields:
        fields = QLineEdit(), QLineEdit(), QLineEdit()
        for column, (field, what) in enumerate(
            zip(fields, (who, self.tr("City"), self.tr("Country, as DE")), strict=True)
        ):
            field.setPlaceholderText(what)
            field.setToolTip(f"{who}: {what}" if column else tip)
            field.setAccessibleName(f"{who}: {what}" if column else who)
            self._grid.addWidget(field, row, column)
        return fields

    def show_file(self, one: CalibrationFile | None) -> None:
        """Ask who is named on this file, unless that is known."""
        before, self._one = self._one, one
        if before is None or one is None or before.path != one.path:
            self.named, self._changes = None, False
            for field in (*self.laboratory, *self.customer):
                field.clear()
        if one is not None and self.named is None:
            self._ask(WhoIsNamed(one.path))
        self._show()

    def _ask(self, asked: WhoIsNamed | StateNames) -> None:
        def known(said: Named) -> None:
            if self._one is not None and self._one.path == asked.path:
                waits = isinstance(asked, StateNames) and self._at_work()  # asked before what they stand in goes away
                self.named, self._changes = said, False
                for field in (*self.laboratory, *self.customer):
                    field.clear()
                self._show()
                self._heard(waits)

        def failed(fault: Fault) -> None:
            self._check()  # it may be tried again
            self._fault.show_fault(fault)

        self._app_state.quick_worker.request(asked, known, failed)

    def _show(self) -> None:
        one, said = self._one, self.named
        self.setVisible(one is not None and not one.standing.signatures and said is not None)
        if said is None:
            return
        stated = self.tr("Laboratory: {0}").format(said.laboratory), self.tr("Customer: {0}").format(said.customer)
        self.stated.setText(
            "   ".join(words for words, who in zip(stated, (said.laboratory, said.customer), strict=True) if who)
        )
        self.stated.setVisible(bool(self.stated.text()))  # no empty line above the fields
        for fields, who in ((self.laboratory, said.laboratory), (self.customer, said.customer)):
            for field in fields:
                field.setVisible(not who or self._changes)
        self.keep.setVisible(bool(self.lacks()) or self._changes)
        self.change.setVisible(bool(self.stated.text()) and not self._changes)

    def _change(self) -> None:
        """Both may be stated anew."""
        self._changes = True
        self._show()
        self.laboratory[0].setFocus(Qt.FocusReason.OtherFocusReason)

    def lacks(self) -> str:
        """Whom the certificate will not name, as a sentence; "" where both are stated, or it is not known yet."""
        said = self.named
        if said is None or (said.laboratory and said.customer):
            return ""
        if said.laboratory or said.customer:
            no_laboratory = self.tr("The certificate names no laboratory.")
            return no_laboratory if said.customer else self.tr("The certificate names no customer.")
        return self.tr("The certificate names no laboratory and no customer.")

    def line(self) -> str:
        """By whom and for whom it is; "" before that is known."""
        said = self.named
        if said is None or self.lacks():
            return self.lacks()
        return self.tr("Certificate of {0}, for {1}.").format(said.laboratory, said.customer)

    def _check(self) -> None:
        begun = [row for row in (self.laboratory, self.customer) if any(field.text().strip() for field in row)]
        self.keep.setEnabled(bool(begun) and all(_typed(row) is not None for row in begun))
        typed = [row[-1].text().strip() for row in begun]
        wrong = next((country for country in typed if len(country) > 1 and not country_code(country)), "")
        no_country = self.tr("✕ “{0}” is no country: two letters, as DE, or its name.").format(wrong)
        self._say(no_country if wrong else self._waits_for(begun), "bad" if wrong else "muted")

    def _say(self, words: str, state: str) -> None:
        """Why Keep is grey."""
        self.wrong.setText(words)
        set_state(self.wrong, state)
        self.wrong.setVisible(bool(words))

    def _waits_for(self, begun: list[Fields]) -> str:
        """What is still to be typed before these can be kept; "" where nothing is."""
        empty = [field.accessibleName() for row in begun for field in row if not field.text().strip()]
        if not empty and not all(_typed(row) for row in begun):
            return self.tr("A country is two letters, as DE, or its name.")
        return self.tr("Keep waits for: {0}.").format(", ".join(empty)) if empty else ""

    def _at_work(self) -> bool:
        """Whether the focus is here."""
        here = QApplication.focusWidget()
        return here is not None and self.isAncestorOf(here)

    def _keep(self) -> None:
        if self._one is not None:
            self._fault.show_fault(None)
            self._ask(StateNames(self._one.path, _typed(self.laboratory), _typed(self.customer)))
            with focus_kept_in(self, *self.laboratory[:1], *self.customer[:1]):
                self.keep.setEnabled(False)
            self._say(self.tr("Being kept …"), "muted")


def _typed(fields: Fields) -> Party | None:
    """Whom the fields name; None where they are empty, or not whole."""
    name, city, country = (field.text().strip() for field in fields)
    code = country_code(country)
    return Party(name, city, code) if name and city and code else None
