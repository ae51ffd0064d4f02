"""Close the loop: residual → evidence → effect → refit → verdict."""

from labcal.loop.close import close_loop
from labcal.loop.result import ClosedLoop, Errors, NextExperiment, Pictures, Round
from labcal.loop.single_effect import OneCause, one_cause

__all__ = ["ClosedLoop", "Errors", "NextExperiment", "OneCause", "Pictures", "Round", "close_loop", "one_cause"]
