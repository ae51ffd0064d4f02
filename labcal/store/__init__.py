"""Keeping what was measured: bundles for exchange and the live store."""

from labcal.store.bundle import (
    Bundle,
    bundle_files,
    bundle_of,
    bundle_sha256,
    load_bundle,
    read_bundle,
    save_bundle,
    write_bundle,
)
from labcal.store.check import Checked, check_store
from labcal.store.live import RunSummary, Store
from labcal.store.summary import describe
from labcal.store.table import Table, read_table
from labcal.store.writer import RunWriter

__all__ = [
    "Bundle",
    "Checked",
    "RunSummary",
    "RunWriter",
    "Store",
    "Table",
    "bundle_files",
    "bundle_of",
    "bundle_sha256",
    "check_store",
    "describe",
    "load_bundle",
    "read_bundle",
    "read_table",
    "save_bundle",
    "write_bundle",
]
