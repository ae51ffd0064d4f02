"""labcal calibrates a magnetometer before it flies. A newcomer reads `labcal.session` first."""

__version__ = "0.1.0"
