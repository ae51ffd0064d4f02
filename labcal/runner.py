"""Drives a procedure, writes the store, resumes."""
