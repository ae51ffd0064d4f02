"""What leaves the lab: the calibration file, keys and signatures, and the report for people."""

from labcal.certificate.calibration_file import calibration_bytes, parse_calibration, read_calibration

__all__ = ["calibration_bytes", "parse_calibration", "read_calibration"]
