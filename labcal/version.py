"""Which labcal this is: files say it as `software`."""

__version__ = "0.1.0"
