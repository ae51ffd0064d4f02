"""Moved to `labcal.bench.driver_kit.testing`; drivers of other packages find it under its first name too."""

from labcal.bench.driver_kit.testing import *  # noqa: F403
