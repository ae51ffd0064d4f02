"""The line in order: bench → procedure → record → fit → loop → certificate. The command line and the window call it."""

from __future__ import annotations
