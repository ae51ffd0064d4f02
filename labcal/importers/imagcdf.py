"""ImagCDF, INTERMAGNET's binary format: one variable an element, each with the variable of its times (version 1.2).

https://tech-man.intermagnet.org/latest/appendices/dataformats.html
"""

from __future__ import annotations

from collections.abc import Mapping
from datetime import UTC, datetime
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError
from labcal.importers.recording import ForeignRecording, ReadRequest, Stream

Array = NDArray[np.float64]

ELEMENT, TIMES = "GeomagneticField", "Times"
KEPT = ("ObservatoryName", "IagaCode", "Latitude", "Longitude", "Elevation", "ElementsRecorded", "PublicationLevel")
MAIN = "GeomagneticVectorTimes"  # what has other times is a stream of its own, such as GeomagneticScalarTimes


def read(path: Path, request: ReadRequest) -> ForeignRecording:
    """Streams by their variable of times, "" that of the vector: `time` [s since 1970, UTC], elements X Y Z F … [nT].

    D and I are in degrees; H and D give X and Y as well.
    """
    cdf: Any = import_module("cdflib")
    try:
        file = cdf.CDF(path)
        names = list(file.cdf_info().zVariables)
        head = {key: str(value[0]) for key, value in file.globalattsget().items() if len(value)}
        by_times: dict[str, dict[str, Array]] = {}
        for name in names:
            if name.startswith(ELEMENT):
                facts = file.varattsget(name)
                times = str(facts.get("DEPEND_0", MAIN))
                values = _values(file.varget(name), facts, request.most_rows)
                by_times.setdefault(times, {})[name.removeprefix(ELEMENT)] = values
        stamps = {times: _stamps(cdf, file.varget(times), request.most_rows) for times in by_times}
    except InputError:
        raise
    except (
        Exception
    ) as error:  # cdflib raises what its reading happens upon: ValueError, OSError, KeyError, struct.error
        raise InputError(f"expected an ImagCDF file; it cannot be read ({error})", file=path) from error
    if not by_times:
        raise InputError(f"expected an ImagCDF file: no variable is called {ELEMENT}…", file=path)
    first = MAIN if MAIN in by_times else next(iter(by_times))
    streams = {
        "" if times == first else times: Stream(
            "" if times == first else times, path, {"time": stamps[times], **_north_east(elements)}
        )
        for times, elements in by_times.items()
    }
    _refuse_lengths(streams, path)
    started = datetime.fromtimestamp(float(stamps[first][0]), UTC).isoformat().replace("+00:00", "Z")
    return ForeignRecording(path, streams, started, tuple(f"{key}: {head[key]}" for key in KEPT if head.get(key)))


def _values(held: Any, facts: Mapping[str, Any], most: int | None) -> Array:
    """A variable's records (n,), NaN where one has its fill value."""
    values = np.array(held, dtype=float).reshape(-1)[:most]
    fill = float(np.asarray(facts.get("FILLVAL", 99999.0)).reshape(-1)[0])
    values[values == fill] = np.nan
    return values


def _stamps(cdf: Any, held: Any, most: int | None) -> Array:
    return np.array(cdf.cdfepoch.unixtime(np.asarray(held).reshape(-1)[:most]), dtype=float).reshape(-1)


def _north_east(elements: Mapping[str, Array]) -> dict[str, Array]:
    found = dict(elements)
    if {"H", "D"} <= found.keys():
        declination = np.radians(found["D"])
        found |= {"X": found["H"] * np.cos(declination), "Y": found["H"] * np.sin(declination)}
    return found


def _refuse_lengths(streams: Mapping[str, Stream], path: Path) -> None:
    for stream in streams.values():
        for name, values in stream.numbers.items():
            if len(values) != len(stream.numbers["time"]) or not len(values):
                counts = f"{name} has {len(values)} records, its times have {len(stream.numbers['time'])}"
                raise InputError(f"expected an ImagCDF file: {counts}", file=path)
