"""Keeping what was measured: bundles for exchange and the live store."""

from labcal.store.bundle import Bundle, bundle_of, bundle_sha256, load_bundle, read_bundle, save_bundle, write_bundle
from labcal.store.table import Table, read_table

__all__ = [
    "Bundle",
    "Table",
    "bundle_of",
    "bundle_sha256",
    "load_bundle",
    "read_bundle",
    "read_table",
    "save_bundle",
    "write_bundle",
]
