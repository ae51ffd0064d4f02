"""Who is named on a certificate: the laboratory, remembered for all of them, and the customer of this one."""

from __future__ import annotations

from pathlib import Path

from labcal import certificate
from labcal.certificate.laboratory import CUSTOMER, administrative_of, write_customer, write_laboratory
from labcal.certificate.laboratory import FILE as LABORATORY
from labcal.certificate.signing import signature_files
from labcal.errors import InputError
from labcal.files.home import home
from labcal.record import Administrative
from labcal.record.administrative import Address, Laboratory
from labcal.session.sources import run_of


def named_on(calibration: Path) -> Administrative:
    """What a certificate of this file states of laboratory and customer; None of what nobody has said."""
    run = run_of(certificate.read_calibration(calibration))
    return administrative_of(run.administrative if run else None, home() / LABORATORY, calibration)


def name_on(calibration: Path, laboratory: Laboratory | None, customer: Address | None) -> Administrative:
    """Say what is not said yet; answers what holds then. Raises InputError for what a run or a person has stated."""
    stated = named_on(calibration)
    if customer is not None:
        own = calibration.with_suffix(CUSTOMER).exists() and not signature_files(calibration)
        if stated.customer is not None and not own:
            raise InputError("the customer is stated already", file=calibration)
        write_customer(calibration, customer)
    if laboratory is not None:
        write_laboratory(home() / LABORATORY, laboratory)
    return named_on(calibration)
