"""The lab's audit log: who did what, when, on which machine; each entry bound to all before it and signed."""

from labcal.audit.log import Audit, Deed, Entry, Row, append, link_of, read, stored

__all__ = ["Audit", "Deed", "Entry", "Row", "append", "link_of", "read", "stored"]
