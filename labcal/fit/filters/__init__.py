"""Estimators from magnitudes alone, one reading at a time."""
