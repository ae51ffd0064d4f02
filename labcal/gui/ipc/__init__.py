"""The window's worker processes: client, messages, and the commands that a worker carries out."""
