"""Maximum likelihood for vectors, axes and magnitudes."""
