"""The coils: supplies as signed axes, limits, ramps, the way to zero, and whether the reference sees what they say."""
