"""Fits, the loop."""

from typing import Any

VERBS: dict[str, Any] = {}
