"""What makes results uncertain: contributions with their source and type, and what a run declares of itself."""

from labcal.uncertainty.contribution import Contribution, covariance_of
from labcal.uncertainty.declared import DeclaredError, declared_errors

__all__ = ["Contribution", "DeclaredError", "covariance_of", "declared_errors"]
