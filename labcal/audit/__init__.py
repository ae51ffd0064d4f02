"""The lab's audit log: who did what, when, on which machine; each entry bound to all before it and signed."""

from labcal.audit.log import Audit, Deed, Entry, append, read

__all__ = ["Audit", "Deed", "Entry", "append", "read"]
