"""The files of each format, by name."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from labcal.certificate.flight.autopilots import ardupilot, px4
from labcal.certificate.flight.c_check import check_program
from labcal.certificate.flight.c_source import header, program_of, source
from labcal.certificate.flight.content import Content
from labcal.certificate.flight.documents import as_json, as_mat
from labcal.certificate.flight.vectors import vectors_of, written
from labcal.record import Run

Files = Mapping[str, bytes]


def flight_files(format_: str, content: Content, run: Run | None) -> Files:
    """What `format_` writes of a calibration, {file name: bytes}; `run` is its own where that is at hand.

    Raises InputError where the format cannot hold it.
    """
    return WRITERS[format_](content, run)


def _c(content: Content, run: Run | None) -> Files:
    vectors = vectors_of(content, run)
    program = program_of(content, vectors)
    texts = {
        "labcal_calibration.h": header(program),
        "labcal_calibration.c": source(program),
        "main.c": check_program(program, vectors),
        "test_vectors.csv": written(content, program.inputs, program.modes, vectors),
    }
    return {name: text.encode() for name, text in texts.items()}


def _json(content: Content, run: Run | None) -> Files:
    return {"labcal_calibration.json": as_json(content)}


def _mat(content: Content, run: Run | None) -> Files:
    return {"labcal_calibration.mat": as_mat(content)}


def _px4(content: Content, run: Run | None) -> Files:
    return {"labcal_px4.params": px4(content).encode()}


def _ardupilot(content: Content, run: Run | None) -> Files:
    return {"labcal_ardupilot.param": ardupilot(content).encode()}


WRITERS: Mapping[str, Callable[[Content, Run | None], Files]] = {
    "c": _c,
    "json": _json,
    "mat": _mat,
    "px4": _px4,
    "ardupilot": _ardupilot,
}
FILES = {
    "c": ("labcal_calibration.h", "labcal_calibration.c", "main.c", "test_vectors.csv"),
    "json": ("labcal_calibration.json",),
    "mat": ("labcal_calibration.mat",),
    "px4": ("labcal_px4.params",),
    "ardupilot": ("labcal_ardupilot.param",),
}
