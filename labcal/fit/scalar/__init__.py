"""Estimators from magnitudes alone, all rows at once."""
