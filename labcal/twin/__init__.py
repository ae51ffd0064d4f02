"""The simulated lab: physics only. It knows no wire, and none of the formulas that it is used to judge."""

from labcal.twin.lab import Lab, open_twin

__all__ = ["Lab", "open_twin"]
