"""Particle-swarm estimators."""
