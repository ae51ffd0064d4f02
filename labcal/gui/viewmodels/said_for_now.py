"""What stands in the line below for a while only: it leaves once it is no longer true, or belongs to another page."""

from __future__ import annotations

from labcal.gui.viewmodels.lab import LabViewModel
from labcal.gui.viewmodels.run import RunViewModel


class SaidForNow:
    """One sentence at a time: about the DUT, about Next, about the window."""

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


class SaidAtTheEnd:
    """That a run has finished is news until another page than its own is opened; how one failed stays."""

    def __init__(self, lab: LabViewModel, run: RunViewModel, for_now: SaidForNow) -> None:
        self._lab, self._run, self._for_now, self._past = lab, run, for_now, ""

    def line(self) -> str:
        """What the line below says of the run, as far as it is not past."""
        run = self._run
        if run.state != "ended":
            self._past = ""
        return self._lab.state.message if self._past == run.run_id != "" else run.message

    def put_away(self, page: str) -> None:
        """`page` is in sight now: what was said on another for a while is past as well."""
        self._for_now.put_away()
        run = self._run
        if page != "Run" and run.state == "ended" and run.status == "finished" and run.run_id != self._past:
            self._past = run.run_id
            if self._lab.state.message == run.message:
                self._lab.update(message="")
