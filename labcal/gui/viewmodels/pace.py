"""How fast the bench's time passes: as it is seen to, on a computer that is busy. No Qt."""

from __future__ import annotations

from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.ipc.simulated_clock import SPEEDS

GAP_S = 5.0  # without a word: it stood, as between Stop and Go on, or the computer slept
LEARNT_S = 5.0  # on the wall, before what is seen counts


class Pace:
    """Seconds of the bench for each one on the wall, since the run began, but for what a person took.

    Of the last moments alone it would go up and down with what the computer has to do beside it.
    """

    def __init__(self) -> None:
        self._last: tuple[float, float] | None = None
        self._lab_s = self._wall_s = 0.0

    def see(self, lab_s: float, wall_s: float) -> None:
        """It is `lab_s` on the bench, and `wall_s` on the wall."""
        last, self._last = self._last, (lab_s, wall_s)
        if last is not None and 0 <= wall_s - last[1] < GAP_S:
            self._lab_s += lab_s - last[0]
            self._wall_s += wall_s - last[1]

    def waits(self) -> None:
        """A person is waited for: that says nothing of the pace."""
        self._last = None

    def of(self, order: RunProcedure | None, *, virtual_time: bool) -> float:
        """How fast the bench's time passes in a run that was ordered so; 0 where nobody can say."""
        stated = SPEEDS.get(order.pace, 0.0) if virtual_time and order else 1.0
        return self.learnt(stated) if virtual_time and stated else stated

    def learnt(self, stated: float) -> float:
        """What is seen, once there is enough of it; until then the pace of life where it is `stated`, else 0: unknown.

        What is to be 100 times may be 20 on a busy computer.
        """
        if self._wall_s >= LEARNT_S and self._lab_s > 0:
            return self._lab_s / self._wall_s
        return stated if stated == 1.0 else 0.0


def faster_than_life(order: RunProcedure | None, virtual_time: bool) -> bool:
    """Whether a second of the bench is none on the wall."""
    return virtual_time and order is not None and SPEEDS.get(order.pace) != 1.0
