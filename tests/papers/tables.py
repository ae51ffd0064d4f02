"""Write docs/papers.md: what the papers print beside what is measured here. `make papers` runs it (a few minutes)."""

from __future__ import annotations

import sys
from importlib import import_module
from pathlib import Path

from labcal.files.atomic import write_text

SECTIONS = ("crassidis", "springmann", "riwanto")
HEAD = """# The papers, reproduced

Written by `make papers`. Printed values beside measured ones; every number follows from the seeds.
"""


def main(out: Path) -> None:
    """Write the sections, in order, to `out`."""
    parts = [HEAD]
    for name in SECTIONS:
        print(f"{name} ...", file=sys.stderr, flush=True)
        section = getattr(import_module(name), "section", None)
        if section:
            parts.append(section())
    write_text(out, "\n".join(parts))


if __name__ == "__main__":
    main(Path(sys.argv[1]))
