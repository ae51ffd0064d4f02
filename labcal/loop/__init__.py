"""Close the loop: residual → evidence → effect → refit → verdict."""

from labcal.loop.close import close_loop
from labcal.loop.result import ClosedLoop, Errors, NextExperiment, Pictures

__all__ = ["ClosedLoop", "Errors", "NextExperiment", "Pictures", "close_loop"]
