"""A bench.toml of what was found."""

from __future__ import annotations

from collections.abc import Sequence

from labcal.bench.find.questions import Found
from labcal.bench.links import abridged

HEAD = """# What `labcal bench find` found. It is refused until a person has stated what is commented out: limits first.
name = "cage"

[cage]
# constants_nT_per_A = [ , , ]   # measured, nT per ampere of each coil; or matrix_nT_per_A, or calibration

[cage.limits]
# current_A =                    # what the thinnest wire of a coil bears for ever
# ramp_A_per_s =                 # full current must ramp down within 1.5 s
# field_nT =                     # at the centre, ambient included

[dut]
# serial = ""
"""


ASKS = {  # what a person must state beside its role
    "waveshare-relay": "x = , y = , z = ", "csv-line": "columns = [ ]", "labjack-t7": "uT_per_V = [ , , ]",
    "daq-inputs": "uT_per_V = [ , , ]",
}  # fmt: skip


def draft(found: Sequence[Found]) -> str:
    """A bench.toml of what was found, with what a person must still state commented out."""
    parts = [HEAD]
    for number, one in enumerate(found, 1):
        said = abridged(one.said).replace("\n", " ")
        if not one.driver:
            parts.append(f"# {one.link}: {said}: no driver of labcal is known to fit.\n")
            continue
        limits = "max_current_A = , compliance_V = " if one.kind == "coil" else ""
        settings = ", ".join(filter(None, (one.settings, limits, ASKS.get(one.driver, ""))))
        name, role = f"{one.driver.replace('-', '_')}_{number}", one.kind + "-x, -y or -z" * bool(limits)
        lines = [f"[instruments.{name}]  # {said}", f'driver = "{one.driver}"', f'link = "{one.link}"']
        lines += [f'# role = ""  # {role}'] + [f"# settings = {{ {settings} }}"] * bool(settings)
        parts.append("\n".join(lines) + "\n")
    return "\n".join(parts)
