"""Who is named on a certificate: laboratory and customer, asked for before it is signed where nobody has said it."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QGridLayout, QLineEdit

from labcal.gui.ipc.answers import CalibrationFile
from labcal.gui.ipc.customer_messages import Named, Party, StateNames, WhoIsNamed
from labcal.gui.theming.theme import GRID
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.widgets.common import Card, button
from labcal.gui.widgets.fault_card import FaultCard

SHARES = (4, 2, 2)  # of the width: name, city, country
Fields = tuple[QLineEdit, ...]


class NamesCard(Card):
    """A row of fields for each of the two who is not stated; away where both are, and after the first signature.

    `heard`: called when it is known, or known anew, who is named.
    """

    def __init__(self, app_state: AppState, fault: FaultCard, heard: Callable[[], object]) -> None:
        super().__init__()
        self._app_state, self._fault, self._heard = app_state, fault, heard
        self._one: CalibrationFile | None = None
        self.named: Named | None = None  # before it is known
        self._wanted = False  # by the step that is to be done now, or by a signature that waits
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
        for column, share in enumerate(SHARES):
            self._grid.setColumnStretch(column, share)
        self._grid.addWidget(self.keep, 0, len(SHARES), 2, 1, Qt.AlignmentFlag.AlignBottom)
        self.body.addLayout(self._grid)
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
            self.named = None
            for field in (*self.laboratory, *self.customer):
                field.clear()
        if one is not None and self.named is None:
            self._ask(WhoIsNamed(one.path))
        self._show()

    def _ask(self, asked: WhoIsNamed | StateNames) -> None:
        def known(said: Named) -> None:
            if self._one is not None and self._one.path == asked.path:
                self.named = said
                self._show()
                self._heard()

        self._app_state.quick_worker.request(asked, known, self._fault.show_fault)

    def _show(self) -> None:
        one, said = self._one, self.named
        asks = one is not None and not one.standing.signatures and bool(self.lacks())
        self.setVisible(asks and self._wanted)
        if said is None:
            return
        for fields, stated in ((self.laboratory, said.laboratory), (self.customer, said.customer)):
            for field in fields:
                field.setVisible(not stated)

    def want(self, wanted: bool) -> None:
        """Ask, or not yet: one thing after the other."""
        if wanted != self._wanted:
            self._wanted = wanted
            self._show()

    def lacks_at_a_signature(self) -> str:
        """As `lacks`; the fields are there then."""
        self.want(True)
        return self.lacks()

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

    def _keep(self) -> None:
        if self._one is not None:
            self._fault.show_fault(None)
            self._ask(StateNames(self._one.path, _typed(self.laboratory), _typed(self.customer)))
            self.keep.setEnabled(False)


def _typed(fields: Fields) -> Party | None:
    """Whom the fields name; None where they are empty, or not whole."""
    name, city, country = (field.text().strip() for field in fields)
    whole = name and city and len(country) == len("DE") and country.isascii() and country.isalpha()
    return Party(name, city, country.upper()) if whole else None
