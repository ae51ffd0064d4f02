"""Recordings of others: a foreign file and a mapping in, a `Run` out. One file a format, its library loaded when asked.

`readers.READERS` lists the formats, `mapping` is what a person says about the columns, `rows` brings them together,
`doubts` looks at the outcome before anybody fits it, and `guess` writes a mapping for a person to check.
"""

from labcal.importers.mapping import Mapping, read_mapping
from labcal.importers.readers import READERS
from labcal.importers.rows import Imported, files_of, take_in

__all__ = ["READERS", "Imported", "Mapping", "files_of", "read_mapping", "take_in"]
