"""What could be at work: every effect as columns beside the base model, scored against coloured noise."""
