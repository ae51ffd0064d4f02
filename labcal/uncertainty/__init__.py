"""What makes results uncertain: contributions with source and type, what a run declares of itself, budgets."""

from labcal.uncertainty.contribution import Contribution, covariance_of
from labcal.uncertainty.declared import DeclaredError, declared_errors
from labcal.uncertainty.fit_noise import FitNoise
from labcal.uncertainty.sources import Sources

__all__ = ["Contribution", "DeclaredError", "FitNoise", "Sources", "covariance_of", "declared_errors"]
