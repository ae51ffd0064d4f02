"""The guardian: a process of its own that holds the links of all supplies and reversing contacts, and takes every
coil to zero when the session that drives them is gone, hangs, or when anyone says off.

`python -m labcal.bench.guardian FILE` runs it; a session starts it and talks to it through `client`.
"""
