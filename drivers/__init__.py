"""Instruments of the lab, one file each."""
