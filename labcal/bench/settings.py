"""Moved to `labcal.bench.driver_kit.settings`; drivers of other packages find it under its first name too."""

from labcal.bench.driver_kit.settings import *  # noqa: F403
