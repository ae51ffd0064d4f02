"""How large what comes from outside may be: large enough for any recording, small beside a memory."""

from __future__ import annotations

from collections.abc import Collection
from itertools import islice

MiB = 1 << 20
RUN_JSON, SAMPLES_CSV, CHAIN_JSONL = "run.json", "samples.csv", "chain.jsonl"  # the last is not in every bundle
LARGEST = {RUN_JSON: 16 * MiB, SAMPLES_CSV: 930 * MiB, CHAIN_JSONL: 930 * MiB}  # bytes; a row of the store: 10^9
INFLATED, FREELY = 200, 16 * MiB  # times its size in the zip may a file have, and any file so many bytes
MOST_FILES, DIRECTORY = 1_000, 1 * MiB  # in a zip: a bundle has two; bytes of what lists them
MOST_SEGMENTS = 45_000  # a field held for a day with a look every two seconds
MOST_COLUMNS = 4_096
MOST_CELLS = 200_000_000  # a million rows of two hundred columns
MOST_WORDS = 100_000  # different texts in one column
LONGEST_LINE = 1 * MiB  # bytes
MOST_PARTS, MOST_VALUES, MOST_KEYS = 500_000, 2_000_000, 5_000  # of a run.json: objects and lists, values, keys
LONGEST_NUMBER = 400  # digits


def listed(names: Collection[str], most: int = 20) -> str:
    """The first of some names, and how many more there are."""
    more = f" and {len(names) - most} more" if len(names) > most else ""
    return f"{', '.join(shortened(name) for name in islice(names, most))}{more}"


def shortened(text: str, most: int = 60) -> str:
    """The text, or its beginning: a sentence has an end."""
    return text if len(text) <= most else f"{text[:most]}…"
