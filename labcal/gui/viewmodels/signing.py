"""How a calibration comes to be signed: what is to be done next, in words."""

from __future__ import annotations

from labcal.gui.ipc.answers import CalibrationFile
from labcal.gui.translations.translate import translated


def next_step(one: CalibrationFile, operator: str) -> str:
    """What is to be done with a calibration now, in one sentence."""
    signatures = one.standing.signatures
    if signatures and not one.standing.valid:
        return translated("Do not use it: make a new draft on the Fit page.")
    if not signatures and not one.approvers:
        return translated(
            "Another person than {0} approves, then both sign. Nobody there? Sign alone: it is PROVISIONAL."
        ).format(one.operator or operator or translated("the operator"))
    waiting = [name for name in one.approvers if name not in one.standing.signers]
    if not signatures:
        return translated("Approved by {0}. Now both sign, each under their own name.").format(", ".join(one.approvers))
    if waiting:
        return translated("Good to use as PROVISIONAL; {0} has still to sign.").format(", ".join(waiting))
    if not one.approvers:
        return translated("Good to use as PROVISIONAL: nobody approved it before it was signed.")
    return translated("Done: hand it out.")
