"""The lab's work, one procedure a file."""
