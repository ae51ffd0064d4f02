"""Keeping what was measured: bundles for exchange and the live store.

Its names are loaded when they are asked for: who only lists runs does not wait for what reads bundles.
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from labcal.store.bundle import (
        Bundle,
        bundle_files,
        bundle_of,
        bundle_sha256,
        load_bundle,
        read_bundle,
        save_bundle,
        write_bundle,
        zipped,
        zipped_as,
    )
    from labcal.store.check import StoreCheck, check_store
    from labcal.store.listing import RunSummary, list_runs
    from labcal.store.live import Store
    from labcal.store.summary import describe
    from labcal.store.table import ColumnTable, read_table
    from labcal.store.writer import RunWriter

__all__ = [
    "Bundle",
    "ColumnTable",
    "RunSummary",
    "RunWriter",
    "Store",
    "StoreCheck",
    "bundle_files",
    "bundle_of",
    "bundle_sha256",
    "check_store",
    "describe",
    "list_runs",
    "load_bundle",
    "read_bundle",
    "read_table",
    "save_bundle",
    "write_bundle",
    "zipped",
    "zipped_as",
]
_OF_OTHERS = {
    **dict.fromkeys(("StoreCheck", "check_store"), "check"),
    **dict.fromkeys(("RunSummary", "list_runs"), "listing"),
    **dict.fromkeys(("ColumnTable", "read_table"), "table"),
    "Store": "live",
    "describe": "summary",
    "RunWriter": "writer",
}


def __getattr__(name: str) -> Any:
    from importlib import import_module

    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_OF_OTHERS.get(name, 'bundle')}"), name)
