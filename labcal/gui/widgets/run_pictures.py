"""What is drawn of a run as it goes: traces at each frame, and the loci, which cost more, seldom."""

from __future__ import annotations

from labcal.gui.viewmodels.run import RunViewModel
from labcal.gui.widgets.plots import Loci, Traces

LOCI_EVERY = 12  # frames: a locus grows slowly, and is expensive to draw
SHOWN_S = 120.0  # of the traces


class RunPictures:
    """Draws `run` into `loci` and `traces`."""

    def __init__(self, run: RunViewModel, loci: Loci, traces: Traces) -> None:
        self._run, self._loci, self._traces = run, loci, traces
        self._drawn, self._ticks, self._begun = -1, 0, 0  # rows; frames since the loci were drawn; turns that they have
        self.behind = False  # the loci, of what was drawn

    def draw(self) -> None:
        """What has come since the last frame; of a turn, its first rows at once, for it may be over before the next."""
        run, rows = self._run, self._run.dut.rows()
        self._ticks += 1
        if len(rows) != self._drawn or not run.alive or len(rows) >= 10_000:
            if len(rows) < self._drawn or self._drawn <= 0:  # another run: nothing of the one before stays
                self._ticks = LOCI_EVERY
            self._drawn, self.behind = len(rows), True
            self._traces.show_rows(rows[rows[:, 0] > rows[-1, 0] - SHOWN_S] if len(rows) else rows)
        begun = sum(len(ring) > 0 for ring in run.drawn.now.values())
        if self.behind and (self._ticks >= LOCI_EVERY or begun != self._begun or not run.alive):
            self.draw_loci()
            self._begun = begun

    def draw_loci(self) -> None:
        """As they are now."""
        self._ticks, self.behind = 0, False
        self._loci.show_field(self._run.drawn.rows())
        self._loci.show_field(self._run.drawn.rows(earlier=True), 1)
