"""What the sensor is believed to do: an affine map and a list of effects."""

from labcal.model.affine import AffineMap
from labcal.model.calibration import Calibration
from labcal.model.records import EffectRecord, Parameter, Validity

__all__ = ["AffineMap", "Calibration", "EffectRecord", "Parameter", "Validity"]
