"""A run that gives no calibration: what that means, why the methods say so, and the button for what is next."""

from __future__ import annotations

from PySide6.QtCore import Signal

from labcal.gui.viewmodels.fit_words import no_fit_words
from labcal.gui.viewmodels.study import StudyViewModel
from labcal.gui.widgets.common import Card, button, label, set_primary, set_state
from labcal.gui.widgets.flow import Flow


class NoFit(Card):
    """`others_wanted`: by the methods that were not tried. `again_wanted`: it is to be measured again."""

    others_wanted, again_wanted = Signal(), Signal()

    def __init__(self) -> None:
        super().__init__(" ")
        self.means, self.why, self.next = (label("", wrap=True) for _ in range(3))
        set_state(self.heading, "bad")
        self.others = button(self.tr("The other methods"), self.tr("Estimate by every method that was not tried yet"))
        self.others.clicked.connect(self.others_wanted)
        self.again = button(self.tr("Measure again"), self.tr("To the preflight of this DUT on the Run page"))
        self.again.clicked.connect(self.again_wanted)
        for words in (self.means, self.why, self.next):
            self.body.addWidget(words)
        self.body.addLayout(Flow(self.others, self.again))
        self.hide()

    def show_study(self, study: StudyViewModel) -> None:
        """Whether there is none, and what to do; a fault has its own card for why."""
        said = no_fit_words(study.fits, others=bool(study.untried))
        for place, words in zip((self.heading, self.means, self.why, self.next), said, strict=True):
            place.setText(words)
            place.setVisible(bool(words))
        self.others.setVisible(bool(study.untried))
        set_primary(self.others, bool(study.untried))
        set_primary(self.again, not study.untried)
        self.setVisible(study.no_fit)
