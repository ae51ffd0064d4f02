"""The instruments' own side of the wire, on the twin."""
