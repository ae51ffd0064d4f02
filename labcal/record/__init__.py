"""What was measured: a `Run` and what each of its segments offers an estimator."""

from labcal.record.header import ChannelSpec, RunHeader
from labcal.record.observation import Observation, carry, offers
from labcal.record.run import Channel, Dut, Reference, Run, Segment
from labcal.record.sampling import period_s

__all__ = [
    "Channel",
    "ChannelSpec",
    "Dut",
    "Observation",
    "Reference",
    "Run",
    "RunHeader",
    "Segment",
    "carry",
    "offers",
    "period_s",
]
