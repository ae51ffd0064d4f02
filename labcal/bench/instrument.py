"""Moved to `labcal.bench.driver_kit.quantity`; drivers of other packages find it under its first name too."""

from labcal.bench.driver_kit.quantity import *  # noqa: F403
