"""What the line below says of a scan or of the DUT's serial, until it is put away."""

from __future__ import annotations

from labcal.gui.viewmodels.lab import LabViewModel


class SaidOfDut:
    """One sentence at a time."""

    def __init__(self, lab: LabViewModel) -> None:
        self._lab, self._words = lab, ""

    def say(self, words: str) -> None:
        """In the line below, until it is put away."""
        self._words = words
        self._lab.update(message=words)

    def put_away(self) -> None:
        """It is past with the next that is accepted, and with another page."""
        if self._words and self._lab.state.message == self._words:
            self.say("")
