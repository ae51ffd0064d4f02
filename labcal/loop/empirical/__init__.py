"""An effect that nobody has written: a smooth function of what is recorded, built and proven after the search."""
