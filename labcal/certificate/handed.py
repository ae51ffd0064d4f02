"""What a file is that a calibration was handed out with, by its name."""

from __future__ import annotations

CONTENTS = "-contents.txt"  # ends the name of the list of what is what
ENDS = {
    ".pdf": "certificate",
    ".json": "calibration",
    ".sshsig": "signature",
    ".tsr": "time-stamp",
    CONTENTS: "contents",
}


def kind_of(file: str, name: str) -> str:
    """certificate, calibration, signature, time-stamp, keys or contents; "" for a file of something else."""
    if file == "allowed_signers":
        return "keys"
    end = next((end for end in ENDS if file.endswith(end)), "")
    return ENDS[end] if end and file.startswith(name) else ""
