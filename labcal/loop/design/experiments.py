"""What could be measured next: what the lab can do, on a run's own geometry.

A design turns the run at hand into the run that an experiment would record, reading and all, as far as the fitted
model predicts it. `labcal.loop.design.discrimination` ranks them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from labcal.model.effects import families
from labcal.model.effects.protocol import Action
from labcal.record import Run
from labcal.record.run import Channel, Segment

Array = NDArray[np.float64]
ROWS = 300  # of a designed run
MIN_ROWS = 4  # of a turning segment that is turned again
GAP_S = 60.0  # between the run and what is measured next
WARMER_C = 15.0
CYCLES = 4  # of a load, a mode or a heater that is switched
LADDER_nT, LADDER_STEPS = 50_000.0, 9  # its largest field, and how many fields up to it and down again
ROWS_A_FIELD = 5
ROWS_A_LEVEL, ROWS_A_MODE = 3, 12  # of a load, of a power mode
WARM_ROW_S, WARM_TURNS = 6.0, 20  # of a heated device: between two rows, and between two fields,
WEAK_FIELD = 0.02  # of the usual one, and that
OTHER, LARGEST_nT = (1 / 3, 2.0), 100_000.0  # of the coil field; that any procedure asks for


@dataclass(frozen=True, slots=True)
class Experiment:
    """Something that the lab can do; a procedure may run it, mounting, heating and switching stay a person's steps."""

    do: str  # one sentence for the technician
    procedure: str | None
    design: Callable[[Run], Run | None]  # what it would record; None where this run's lab or device cannot do it
    alters: tuple[tuple[str, float], ...] = ()  # effects that it changes by a factor where the scene does not say so
    concerns: frozenset[str] = frozenset()  # effects that it is about; empty: about any
    settings: Callable[[Run], Mapping[str, str]] = lambda run: {}  # with which the procedure does that, by name


def experiments() -> tuple[Experiment, ...]:
    """All that the lab can do, the cheapest first."""
    loaded, warmed, caged = _responding("load"), _responding("heat"), _responding("bare platform")
    return (
        Experiment("turn once forwards and once backwards in one mounting", "reverse", reverse),
        Experiment("turn at half and at twice the rate, there and back, in one mounting", "rate-sweep", rates),
        Experiment("repeat the run unchanged", "repeat", repeat),
        Experiment("step the field up and down along one axis", "linearity", ladder),
        Experiment("turn in two more coil fields, a third and twice as large", "preflight", other_fields,
                   settings=in_other_fields),
        Experiment("switch every load on and off at one attitude", "current-coupling", loads, concerns=loaded),
        Experiment("warm the device and let it cool in two fields", "temperature-drift", heated, concerns=warmed),
        Experiment("switch the power mode there and back at one attitude", None, modes, concerns=loaded),
        Experiment("move the device by 5 cm and repeat the first turns", None, repeat, _factors("move device")),
        Experiment("turn the reference by 180° and repeat the first turns", None, repeat, _factors("turn reference")),
        Experiment("put the reference at twice its distance and repeat the first turns", "dut-moment", repeat,
                   _factors("move reference")),
        Experiment("measure the bare platform's own field with the reference", "platform-signature", bare,
                   tuple((family.id, 0.0) for family in families() if family.id not in caged), caged),
    )  # fmt: skip


def _responding(action: Action) -> frozenset[str]:
    return frozenset(family.id for family in families() if action in family.responds)


def _factors(action: Action) -> tuple[tuple[str, float], ...]:
    return tuple((family.id, family.responds[action]) for family in families() if action in family.responds)


def thinned(run: Run, rows: int = ROWS) -> Run:
    """About `rows` rows, evenly."""
    return run.select(np.unique(np.linspace(0, len(run) - 1, rows).astype(np.intp)))


def repeat(run: Run) -> Run | None:
    """The same again, after it."""
    return _as_new(run, run.t_s + float(np.ptp(run.t_s)) + GAP_S)


def bare(run: Run) -> Run | None:
    """The same turns, but nothing of the device: only what the cage itself does is seen."""
    return repeat(run) if _turning(run) else None


def reverse(run: Run) -> Run | None:
    """Every turn forwards and backwards."""
    return _swept(run, (1.0, -1.0))


def rates(run: Run) -> Run | None:
    """Every turn at half and twice the rate, both ways."""
    return _swept(run, (0.5, -0.5, 2.0, -2.0))


def _swept(run: Run, speeds: Sequence[float]) -> Run | None:
    """Each turning segment again at these multiples of its rate, negative ones backwards, in one mounting."""
    if not _turning(run) or run.angle_deg is None:
        return None
    few = thinned(run, ROWS // 2)
    parts, segments, clock = list[Run](), list[Segment](), float(run.t_s[-1]) + GAP_S
    for index in _turning(few):
        rows = few.rows(index)
        if len(rows) < MIN_ROWS:
            continue
        for speed in speeds:
            order = rows if speed > 0 else rows[::-1]
            times = clock + np.abs(few.t_s[order] - few.t_s[order[0]]) / abs(speed)
            part = few.select(order)
            segments.append(replace(few.segments[index], id=f"{index}:{speed:g}", mounting=f"again-{index}"))
            parts.append(replace(part, t_s=times, segment_index=np.full(len(rows), len(segments) - 1, dtype=np.intp)))
            clock = float(times[-1]) + GAP_S
    return _joined(parts, segments) if parts else None


def ladder(run: Run) -> Run | None:
    """At rest, the field stepped up and down along each axis of the cage in turn."""
    steps = np.concatenate([np.linspace(-1, 1, LADDER_STEPS), np.linspace(1, -1, LADDER_STEPS)])
    fields = np.concatenate([np.outer(np.repeat(steps, ROWS_A_FIELD), axis) for axis in np.eye(3)])
    return _at_rest(run, fields * LADDER_nT, 1.0)


def other_fields(run: Run) -> Run | None:
    """The same turns in a third of the field and in twice the field."""
    again = repeat(run)
    if again is None:
        return None
    first = thinned(again, ROWS // 2)
    later = replace(first, t_s=first.t_s + float(np.ptp(first.t_s)) + GAP_S)
    weaker, stronger = _other_parts(run)
    return _joined([_scaled(first, weaker), _scaled(later, stronger)], list(first.segments), own=True)


def in_other_fields(run: Run) -> Mapping[str, str]:
    """The settings of a preflight that turns so, in the run's own modes."""
    fields = ", ".join(f"{np.nanmedian(run.magnitude_nT) * part:.0f}" for part in _other_parts(run))
    modes = ", ".join(dict.fromkeys(s.mode for s in run.segments if s.mode))
    return {"magnitudes_nT": fields, "reverse": "false"} | ({"modes": modes} if modes else {})


def _other_parts(run: Run) -> tuple[float, float]:
    """How many times the run's field the two others are."""
    return OTHER[0], min(OTHER[1], LARGEST_nT / float(np.nanmedian(run.magnitude_nT)))


def loads(run: Run) -> Run | None:
    """At rest, each current switched on and off by itself, in three levels."""
    names = [c.name for c in run.channels if c.role == "dut" and c.quantity == "current"]
    if not names:
        return None
    levels = np.tile(np.repeat([0.0, 1.0, 0.5, 0.0], ROWS_A_LEVEL), CYCLES)
    still = _at_rest(run, np.tile(_usual_field(run), (len(names) * len(levels), 1)), 1.0)
    return still and _with(still, {
        name: _base(run, name) + _span(run, name) * _placed(levels, n, len(names)) for n, name in enumerate(names)
    })  # fmt: skip


def heated(run: Run) -> Run | None:
    """At rest in two fields by turns, every temperature up and down again."""
    names = [c.name for c in run.channels if c.role == "dut" and c.quantity == "temperature"]
    if not names:
        return None
    field = np.repeat(np.tile([WEAK_FIELD, 1.0], WARM_TURNS), ROWS_A_FIELD)[:, None] * _usual_field(run)
    warm = WARMER_C * np.sin(np.linspace(0, np.pi, len(field)))
    still = _at_rest(run, field, WARM_ROW_S)
    return still and _with(still, {name: _base(run, name) + warm for name in names})


def modes(run: Run) -> Run | None:
    """At rest, the power modes of the run by turns, everything else as it was."""
    known = sorted(set(run.mode.tolist()) - {""})
    if len(known) < 2:
        return None
    field = np.tile(_usual_field(run), (len(known) * CYCLES * ROWS_A_MODE, 1))
    still = _at_rest(run, field, 1.0)
    return still and replace(still, row_mode=np.tile(np.repeat(np.array(known), ROWS_A_MODE), CYCLES))


def _turning(run: Run) -> list[int]:
    return [n for n, s in enumerate(run.segments) if s.kind == "rotation" and s.axis_cage is not None]


def _as_new(run: Run, t_s: Array) -> Run:
    """The same rows at other times, with new mountings."""
    few = thinned(run)
    segments = tuple(
        replace(s, id=f"again-{s.id}", mounting=s.mounting and f"again-{s.mounting}") for s in few.segments
    )
    place = np.searchsorted(run.t_s, few.t_s)
    return replace(few, t_s=t_s[place], segments=segments)


def _scaled(run: Run, factor: float) -> Run:
    changes: dict[str, Any] = {}
    if run.reference_vector is not None:
        changes["reference_vector"] = run.reference_vector * factor
    if run.reference_magnitude is not None:
        changes["reference_magnitude"] = run.reference_magnitude * factor
    return replace(run, reading=run.reading * factor, **changes)


def _usual_field(run: Run) -> Array:
    """A field (3,) along the diagonal, as large as the run's."""
    return np.full(3, float(np.nanmedian(run.magnitude_nT)) / np.sqrt(3))


def _at_rest(run: Run, fields_nT: Array, step_s: float) -> Run | None:
    """A standstill in these fields (n, 3) of the cage, the body's axes along the cage's; channels at their usual."""
    if run.reference_vector is None:
        return None
    n = len(fields_nT)
    eye = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    channels = tuple(Channel(c.name, c.unit, c.quantity, np.full(n, _base(run, c.name)), c.role) for c in run.channels)
    return replace(
        run,
        segments=(Segment("at-rest", "static", mode=run.segments[0].mode, body_from_cage=eye),),
        t_s=run.t_s[-1] + GAP_S + step_s * np.arange(n),
        segment_index=np.zeros(n, dtype=np.intp),
        reading=fields_nT.copy(),
        reference_vector=fields_nT.copy(),
        reference_magnitude=None,
        angle_deg=None,
        row_mode=None,
        channels=channels,
    )


def _with(run: Run, drives: dict[str, Array]) -> Run:
    return replace(run, channels=tuple(replace(c, values=drives.get(c.name, c.values).copy()) for c in run.channels))


def _placed(levels: Array, number: int, count: int) -> Array:
    out = np.zeros((count, len(levels)))
    out[number] = levels
    return out.ravel()


def _base(run: Run, name: str) -> float:
    values = run.channel(name).values
    return float(np.nanmedian(values)) if np.isfinite(values).any() else 0.0


def _span(run: Run, name: str) -> float:
    values = run.channel(name).values
    return float(np.nanmax(values) - np.nanmin(values)) if np.isfinite(values).any() else 1.0


def _joined(parts: Sequence[Run], segments: Sequence[Segment], *, own: bool = False) -> Run:
    """Parts of one run after one another; `own`: each part brings its own segments."""
    first = parts[0]
    index = [p.segment_index + (n * len(segments) if own else 0) for n, p in enumerate(parts)]
    named = [replace(s, id=f"{n}:{s.id}", mounting=s.mounting and f"{n}:{s.mounting}") for n in range(len(parts))
             for s in segments] if own else list(segments)  # fmt: skip
    stacked: dict[str, Any] = {
        name: np.concatenate([getattr(p, name) for p in parts])
        for name in ("t_s", "reading", "reference_vector", "reference_magnitude", "angle_deg", "row_mode")
        if getattr(first, name) is not None
    }
    channels = tuple(
        replace(c, values=np.concatenate([p.channels[n].values for p in parts])) for n, c in enumerate(first.channels)
    )
    return replace(first, segments=tuple(named), segment_index=np.concatenate(index), channels=channels, **stacked)
