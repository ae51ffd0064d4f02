"""What a procedure knows of the DUT while it still turns: the extended filter, fed with every turn's magnitudes."""

from __future__ import annotations

import numpy as np

from labcal.bench.bench import Bench
from labcal.bench.steps import Blocks, Work, dut_nT, note
from labcal.bench.streams.samples import samples
from labcal.fit.filters.ekf import EKF

NOISE_NT = 100.0  # of one axis, where none is stated; the filter's start finds its own

ASTRAY = (
    "offsets so far: the quick estimate of this procedure, from magnitudes alone, does not follow these readings; "
    "verdict and Fit do not rest on it"
)
UNDETERMINED = "offsets so far: not yet determined by the turns made"


class RunningEstimate:
    """The offsets of the DUT from the turns that it has made."""

    def __init__(self, bench: Bench) -> None:
        self._bench = bench
        self.forget()

    def forget(self) -> None:
        """Begin again, where turns are not to be used."""
        self._filter = EKF((self._bench.config.dut.noise_nT or NOISE_NT) ** 2 * np.eye(3))

    def take(self, blocks: Blocks) -> Work[None]:
        """Feed one turn in a steady field, reading by reading, and say what is known since."""
        magnitude = float(np.linalg.norm(samples(blocks, "reference").mean))
        for reading in dut_nT(self._bench, blocks).values:
            self._filter.update(reading, magnitude)
        yield note(self._bench, self.sentence())

    def sentence(self) -> str:
        """What is known so far."""
        if self._filter.diverged():
            return ASTRAY
        if not self._filter.started:
            return UNDETERMINED
        try:
            found = self._filter.estimate()
        except ArithmeticError:  # no real scale factors belong to where it is
            return UNDETERMINED
        u = np.sqrt(np.diag(found.covariance)[:3])
        each = (f"{axis} {b:.0f} ± {2 * s:.0f}" for axis, b, s in zip("xyz", found.bias, u, strict=True))
        return f"offsets so far, from magnitudes alone: {', '.join(each)} nT (k = 2)"
