"""The lab as a procedure sees it: roles, the cage, the clock, and the file that says what stands where."""

from labcal.bench.bench import Bench, open_bench
from labcal.bench.cage import Cage

__all__ = ["Bench", "Cage", "open_bench"]
