"""The technician's window, over worker processes."""
