"""What a run may be called: a word that a shell, a file system and a person all read alike."""

from __future__ import annotations

import re

LONGEST = 128
RUN_ID = re.compile(rf"[A-Za-z0-9][A-Za-z0-9._+-]{{0,{LONGEST - 1}}}")
NO_FILE = re.compile(r"(con|prn|aux|nul|com[0-9]|lpt[0-9])(\..*)?|.*\.", re.IGNORECASE)  # on Windows, whatever follows


def checked_run_id(text: str) -> str:
    """`text` itself. Raises ValueError where no run may be called so; stores of before may still hold such runs."""
    if not RUN_ID.fullmatch(text):
        shown = ascii(text if len(text) <= LONGEST else f"{text[:40]}...")
        raise ValueError(
            f"a run id is of letters a to z, digits and - _ . + alone, begins with a letter or digit and has at most "
            f"{LONGEST} of them, found {shown}"
        )
    if NO_FILE.fullmatch(text):
        raise ValueError(f"a run id is the name of a file, and on Windows {text!r} can be none")
    return text


def as_file_name(run_id: str) -> str:
    """The name of a run in a folder's files, whatever it is called: what no id may hold becomes its number."""
    safe = (letter if RUN_ID.fullmatch(f"0{letter}") else f"%{ord(letter):x}" for letter in run_id)
    name = "".join(safe).replace("..", "%2e%2e")
    name = f"{name[:-1]}%2e" if name.endswith(".") else name
    return f"%{ord(name[0]):x}{name[1:]}" if NO_FILE.fullmatch(name) else name


def name_outside(serial: str, stem: str) -> str:
    """What a file of this sensor is called where it leaves the lab: by serial and run, which says the day."""
    return stem if stem.startswith(f"{serial}_") else re.sub(r"[^\w.-]", "-", f"{serial}_{stem}")
