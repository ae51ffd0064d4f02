"""Moved to `labcal.bench.driver_kit.roles`; drivers of other packages find it under its first name too."""

from labcal.bench.driver_kit.roles import *  # noqa: F403
from labcal.record.header import ChannelSpec as ChannelSpec
