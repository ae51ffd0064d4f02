"""One form that an effect can take: its physics with the linear parameters left open."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError
from labcal.model.effects.scene import Scene
from labcal.model.effects.shape import FoundBy, Kind, Shape
from labcal.model.smooth import Basis

Array = NDArray[np.float64]
Kernel = Callable[["Term", Scene], Array]
SMALLEST = 1e-6  # values of secants that count as zero


@dataclass(frozen=True, slots=True)
class Term:
    """One form that an effect can take: `kernel` is all its physics, the linear parameters are left open.

    `kernel(form, scene)` gives the derivative of e by each linear parameter, (n, 3, p) [nT of B per unit].
    """

    kernel: Kernel
    parameters: tuple[tuple[str, str], ...]  # name and unit of each linear parameter, in the order of the columns
    channels: tuple[str, ...] = ()
    reference_value: Mapping[str, float] = field(default_factory=dict)  # where each channel counts as zero
    shape: tuple[Shape, ...] = ()
    inputs: tuple[str, ...] = ()  # of a smooth function (`effects.inputs`)
    basis: Basis | None = None  # of the same
    of_beginnings: int = 0  # the last parameters, which say how segments of the fit's run began: they hold nowhere else

    def columns(self, scene: Scene) -> Array:
        """The derivative of e by each linear parameter (n, 3, p)."""
        return self.kernel(self, scene)

    @property
    def lasting(self) -> int:
        """How many of the parameters, the first ones, hold in other recordings too."""
        return len(self.parameters) - self.of_beginnings

    def at(self, name: str) -> float:
        """The value of a shape parameter. Raises InputError where the form lacks it."""
        for shape in self.shape:
            if shape.name == name:
                return shape.value
        raise InputError(f"the effect lacks its parameter {name}")

    def of(self, kind: Kind) -> Shape | None:
        """Its first shape parameter of this kind; None where it has none."""
        return next((shape for shape in self.shape if shape.kind is kind), None)

    def found_by(self, search: FoundBy) -> Shape | None:
        """Its first shape parameter that this search finds; None where it has none."""
        return next((shape for shape in self.shape if shape.kind.found_by == search), None)

    def with_values(self, **values: float) -> Term:
        """The same form at other shape parameters."""
        return replace(self, shape=tuple(replace(s, value=values.get(s.name, s.value)) for s in self.shape))

    def with_shape(self, at: Shape) -> Term:
        """The same form with the shape parameter of this name as it is here."""
        return replace(self, shape=tuple(at if s.name == at.name else s for s in self.shape))

    def own_secants(self) -> list[Shape]:
        """The intervals that secants are taken over: each is the value of the linear parameter in its place."""
        return [shape for shape in self.shape if shape.kind.found_by == "own secant"]

    def over_own_secants(self, values: Array) -> Term:
        """The same form with its secants taken over these values of its linear parameters; over none that vanish."""
        secants = self.own_secants()
        if not any(abs(value) > SMALLEST for value in values[: len(secants)]):
            return self
        return self.with_values(**{s.name: float(v) for s, v in zip(secants, values, strict=False)})

    def stepped(self) -> Term:
        """The same form as it is after its moment: the step came before the run began."""
        moment = self.found_by("changepoints")
        return replace(self, shape=tuple(replace(s, value=-np.inf) if s is moment else s for s in self.shape))

    def drive(self, scene: Scene) -> Array:
        """Its first channel, counted from the reference value (n,)."""
        name = self.channels[0]
        return np.asarray(scene.channels[name] - self.reference_value[name])

    def ends_of_drive(self, scene: Scene) -> tuple[float, float] | None:
        """Between which values the drive has been seen; None where nothing says so."""
        ends = None if scene.past is None else scene.past.ends.get(name := self.channels[0])
        if ends is None:
            return None
        low, high = (end - self.reference_value[name] for end in ends)
        return low, high
