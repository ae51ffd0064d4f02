"""Beside effects: residual tests, the residual's shape, confounded explanations, the working range."""
