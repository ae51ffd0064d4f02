"""What a bench file states, as the window knows it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from labcal.bench.serials import USUAL
from labcal.record.run import Dut

Triple = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Instrument:
    """One instrument of a bench file."""

    role: str
    link: str
    driver: str
    serial: str = ""  # as its [[equipment]] states it


@dataclass(frozen=True, slots=True)
class Cage:
    """The coils as a bench file states them. `matrix` [nT/A]: its columns are the coil axes in C."""

    matrix: tuple[Triple, Triple, Triple]
    stated: bool  # as a matrix, not as constants alone
    calibration: str | None  # an approved cage calibration
    limit_A: tuple[float, ...]
    limit_nT: float
    ramp_A_per_s: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class Reference:
    """What is known of the reference sensor."""

    u_offset_nT: float | None
    u_scale_ppm: float | None
    calibration: str | None


@dataclass(frozen=True, slots=True)
class CoilEnd:
    """One axis as it was read back when it was switched off; None is not known."""

    axis: str
    current_A: float | None
    words: str
    ok: bool
    read_s: float | None = None


@dataclass(frozen=True, slots=True)
class Doubt:
    """A zero that the reference did not see, measured again; `before`: what was seen then; `coils` as read back now."""

    words: str
    lifted: bool
    coils: tuple[CoilEnd, ...] = ()
    before: str = ""


@dataclass(frozen=True, slots=True)
class EarlierSupply:
    """One that an earlier session drove at another link, and that was not read back at zero; `name`: axis and port.

    `gone`: nothing is at its link any more. `flows`: it answers, and is not at zero.
    """

    name: str
    port: str
    words: str
    gone: bool
    flows: bool


@dataclass(frozen=True, slots=True)
class Earth:
    """The magnitude that a model of the Earth's field expects outdoors at the bench's place today, and U (k=2) [nT]."""

    model: str
    magnitude_nT: float
    U_nT: float


@dataclass(frozen=True, slots=True)
class Bench:
    """What a bench file states."""

    name: str
    simulated: bool
    dut: Dut
    reference: Reference
    cage: Cage
    instruments: Mapping[str, Instrument]
    serial_pattern: str = USUAL  # of the DUTs that this bench takes
    modes: tuple[str, ...] = ()  # the power modes that the DUT may be in; none stated: any
    fastest_deg_per_s: float | None = None  # that DUT and platform may turn, where a limit is stated
    virtual_time: bool = False  # it passes as fast as is wanted
    laboratory: str = ""  # whose bench it is, where that is stated
    camera: str = ""  # its number on this computer, or its address; shown where the DUT is mounted
    earth: Earth | None = None  # where the bench file states its place
