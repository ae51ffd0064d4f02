"""When each instrument was heard last: who is lost is out since then, and not since it was first missed. No widgets."""

from __future__ import annotations

from collections.abc import Mapping

from labcal.bench.coils.state import LabState


class LastHeard:
    """By instrument, and by axis of its coil; times are by the computer's monotonic clock."""

    def __init__(self) -> None:
        self._heard_s, self._coil_s = dict[str, float](), dict[str, float]()
        self._stated_s = dict[str, float]()  # by whoever knows that they are silent
        self._unread = set[str]()

    def keep(self, known: LabState) -> None:
        """Who was heard by then; who was not keeps what it had."""
        self._stated_s = {one.name: one.heard_s for one in known.instruments if one.fault and one.heard_s is not None}
        self._heard_s |= {one.name: one.heard_s for one in known.instruments if one.heard_s is not None}
        read_s = {coil.axis: coil.read_s for coil in known.coils if not coil.fault and coil.current_A is not None}
        self._unread = {coil.axis for coil in known.coils if coil.current_A is None}
        self._coil_s |= {axis: at_s for axis, at_s in read_s.items() if at_s is not None}

    def at_s(self, supplies: Mapping[str, str]) -> tuple[tuple[str, float], ...]:
        """Of everybody; the `supplies`, by axis, as their coils were read."""
        coils = {name: self._coil_s[axis] for axis, name in supplies.items() if axis in self._coil_s}
        names = dict.fromkeys((*self._heard_s, *coils))
        last_s = {name: max(by[name] for by in (self._heard_s, coils) if name in by) for name in names}
        unread = {name: at_s for name, at_s in coils.items() if any(supplies.get(a) == name for a in self._unread)}
        return tuple((last_s | self._stated_s | unread).items())
