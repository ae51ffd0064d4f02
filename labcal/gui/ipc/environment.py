"""What the window's child processes may know."""

from __future__ import annotations

from PySide6.QtCore import QProcessEnvironment

from labcal.files.home import for_children


def child_environment() -> QProcessEnvironment:
    """This process's environment without what is secret in it."""
    found = QProcessEnvironment()
    for name, value in for_children().items():
        found.insert(name, value)
    return found
