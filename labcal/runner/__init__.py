"""Drives procedures: finds them, answers what they ask, writes what they yield, ends with the coils at zero."""

from labcal.runner.catalogue import FoundProcedure, catalogue, find, procedures
from labcal.runner.control import Control
from labcal.runner.prompts import Answer, yes_to_all
from labcal.runner.run import Outcome, resume_run, run_procedure

__all__ = [
    "Answer",
    "Control",
    "FoundProcedure",
    "Outcome",
    "catalogue",
    "find",
    "procedures",
    "resume_run",
    "run_procedure",
    "yes_to_all",
]
