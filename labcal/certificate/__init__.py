"""What leaves the lab: the calibration file, keys and signatures, and the report for people."""

from labcal.certificate import flight, keys
from labcal.certificate.allowed_signers import Signer, read_allowed_signers
from labcal.certificate.apply_file import AppliedFile, apply_file, check_effects
from labcal.certificate.calibration_file import (
    calibration_bytes,
    looks_like_calibration,
    parse_calibration,
    read_calibration,
)
from labcal.certificate.hand_out import hand_out
from labcal.certificate.keys import KeyEntry
from labcal.certificate.predecessor import changed_from, changed_since
from labcal.certificate.roles import check_approver, check_roles
from labcal.certificate.signing import (
    SignatureCheck,
    Verification,
    approve,
    check_approvers,
    sign,
    sign_simulated,
    signature_files,
    verify,
)
from labcal.certificate.stated import Stated, check_stated, state, stated_by_people
from labcal.certificate.superseding import keep_superseding, superseded_by

__all__ = [
    "AppliedFile",
    "KeyEntry",
    "SignatureCheck",
    "Signer",
    "Stated",
    "Verification",
    "apply_file",
    "approve",
    "calibration_bytes",
    "changed_from",
    "changed_since",
    "check_approver",
    "check_approvers",
    "check_effects",
    "check_roles",
    "check_stated",
    "flight",
    "hand_out",
    "keep_superseding",
    "keys",
    "looks_like_calibration",
    "parse_calibration",
    "read_allowed_signers",
    "read_calibration",
    "sign",
    "sign_simulated",
    "signature_files",
    "state",
    "stated_by_people",
    "superseded_by",
    "verify",
]
