"""Finished runs and calibrations of several labs in one PostgreSQL: pushed, found again, never changed.

Needs the extra `archive`; nothing of it is loaded before somebody asks for the archive.
"""
