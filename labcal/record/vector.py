"""Three components and three rows of them, as headers and segments state them."""

from __future__ import annotations

Vector = tuple[float, float, float]
Matrix = tuple[Vector, Vector, Vector]
