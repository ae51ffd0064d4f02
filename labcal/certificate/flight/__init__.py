"""A calibration for those who fly it: C99, JSON, MATLAB, parameters of autopilots; and other people's taken in."""

from labcal.certificate.flight.content import content_of, said_of
from labcal.certificate.flight.foreign import KINDS, read_foreign
from labcal.certificate.flight.write import FILES, flight_files

__all__ = ["FILES", "KINDS", "content_of", "flight_files", "read_foreign", "said_of"]
