"""Close the loop: residual → evidence → effect → refit → verdict."""

from labcal.loop.close import close_loop
from labcal.loop.one import OneCause, one_cause
from labcal.loop.result import ClosedLoop, Errors, NextExperiment, Pictures, Round

__all__ = ["ClosedLoop", "Errors", "NextExperiment", "OneCause", "Pictures", "Round", "close_loop", "one_cause"]
