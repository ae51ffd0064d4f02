"""Real files of each format, made in the test from the formats' public definitions, all of one made-up recording."""

from __future__ import annotations

import struct
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

BIAS_nT = np.array([1500.0, -800.0, 400.0])
K = np.array([[1.02, 0.01, 0.0], [0.0, 0.98, -0.005], [0.003, 0.0, 1.01]])


@dataclass(frozen=True)
class Made:
    """A device that tumbles beside a reference: both in the body's axes [nT], stamped t_s."""

    t_s: Array
    reading: Array
    reference: Array
    temperature_C: Array


def tumble(n: int = 400, seed: int = 3, noise_nT: float = 5.0) -> Made:
    draw = np.random.default_rng(seed)
    t = np.arange(n) * 0.25
    a, b = 0.31 * t, 0.173 * t + 0.4
    reference = 48_000 * np.column_stack([np.cos(a) * np.cos(b), np.sin(a) * np.cos(b), np.sin(b)])
    reading = reference @ K.T + BIAS_nT + draw.normal(0, noise_nT, (n, 3))
    return Made(t, reading, reference, 24 + 2 * np.sin(0.01 * t))


def ulog(path: Path, made: Made) -> Path:
    """https://docs.px4.io/main/en/dev_log/ulog_file_format.html: header, formats, parameter, topics, data."""

    def message(kind: bytes, body: bytes) -> bytes:
        return struct.pack("<HB", len(body), kind[0]) + body

    def data(number: int, body: bytes) -> bytes:
        return message(b"D", struct.pack("<H", number) + body)

    formats = (
        b"vehicle_magnetometer:uint64_t timestamp;float[3] magnetometer_ga;",
        b"battery_status:uint64_t timestamp;float current_a;float voltage_v;",
        b"sensor_gps:uint64_t timestamp;uint64_t time_utc_usec;int32_t lat;int32_t lon;",
    )
    key = b"float CAL_MAG0_XOFF"
    parts = [b"ULog\x01\x12\x35\x01", struct.pack("<Q", 1_000_000), *(message(b"F", f) for f in formats)]
    parts += [message(b"P", bytes([len(key)]) + key + struct.pack("<f", 0.25))]
    names = (b"vehicle_magnetometer", b"battery_status", b"sensor_gps")
    parts += [message(b"A", struct.pack("<BH", 0, number) + name) for number, name in enumerate(names)]
    for t, m in zip(made.t_s, made.reading, strict=True):
        us = 1_000_000 + round(t * 1e6)
        parts.append(data(0, struct.pack("<Q3f", us, *(m / 1e5))))
        parts.append(data(1, struct.pack("<Q2f", us, 2 + np.sin(t), 11.5)))
    parts.append(data(2, struct.pack("<QQii", 1_000_000, 1_687_329_772_000_000, 487_678_000, 113_369_000)))
    path.write_bytes(b"".join(parts))
    return path


def dataflash(path: Path, made: Made) -> Path:
    """Binary log as LogStructure.h of ArduPilot has it: FMT describes every kind of message, itself included."""

    def fmt(kind: int, length: int, name: bytes, form: bytes, columns: bytes) -> bytes:
        return b"\xa3\x95\x80" + struct.pack("<BB4s16s64s", kind, length, name, form, columns)

    parts = [
        fmt(0x80, 89, b"FMT", b"BBnNZ", b"Type,Length,Name,Format,Columns"),
        fmt(0x40, 31, b"PARM", b"QNf", b"TimeUS,Name,Value"),
        fmt(0x41, 18, b"MAG", b"QBhhh", b"TimeUS,I,MagX,MagY,MagZ"),
        b"\xa3\x95\x40" + struct.pack("<Q16sf", 1, b"COMPASS_OFS_X", 12.5),
    ]
    for t, m in zip(made.t_s, made.reading, strict=True):
        parts.append(
            b"\xa3\x95\x41" + struct.pack("<QB3h", 1_000_000 + round(t * 1e6), 0, *np.round(m / 100).astype(int))
        )
    path.write_bytes(b"".join(parts))
    return path


def rosbag(path: Path, made: Made) -> Path:
    """A ROS 2 bag with sensor_msgs/MagneticField [T], by rosbags' own writer."""
    from rosbags.rosbag2 import Writer
    from rosbags.typesys import Stores, get_typestore

    store = get_typestore(Stores.ROS2_HUMBLE)
    types = store.types
    kind = "sensor_msgs/msg/MagneticField"
    with Writer(path, version=8) as writer:
        topics = {name: writer.add_connection(name, kind, typestore=store) for name in ("/imu/mag", "/ref/mag")}
        for t, *fields in zip(made.t_s, made.reading, made.reference, strict=True):
            ns = round((1.7e9 + t) * 1e9)
            for topic, field in zip(topics.values(), fields, strict=True):
                stamp = types["builtin_interfaces/msg/Time"](sec=ns // 10**9, nanosec=ns % 10**9)
                header = types["std_msgs/msg/Header"](stamp=stamp, frame_id="imu")
                vector = types["geometry_msgs/msg/Vector3"](*(float(x) * 1e-9 for x in field))
                message = types[kind](header, vector, np.zeros(9))
                writer.write(topic, ns + 1_000_000, store.serialize_cdr(message, kind))
    return path


def mat(path: Path, made: Made) -> Path:
    """A MATLAB file with a struct, its field in µT; compressed, as MATLAB writes it."""
    from scipy.io import savemat

    log = {"t": made.t_s, "mag": made.reading / 1e3, "ref": (made.reference / 1e3).T, "T": made.temperature_C + 273.15}
    savemat(path, {"log": log, "name": "bench"}, do_compression=True)
    return path


def iaga(path: Path, made: Made) -> Path:
    """IAGA-2002 with H [nT], D [minutes of arc], Z and F; one row is missing."""
    h, d = (
        np.hypot(made.reading[:, 0], made.reading[:, 1]),
        np.degrees(np.arctan2(made.reading[:, 1], made.reading[:, 0])),
    )
    head = {"Format": "IAGA-2002", "Station Name": "Nowhere", "IAGA CODE": "NWH", "Reported": "HDZF"}
    lines = [f" {key:<23}{value:<45}|" for key, value in head.items()]
    lines.append(f"{'DATE       TIME         DOY     NWHH      NWHD      NWHZ      NWHF':<69}|")
    for i, m in enumerate(made.reading):
        values = [h[i], d[i] * 60, m[2], np.linalg.norm(made.reference[i])] if i != 7 else [99999.0] * 4
        lines.append(f"2024-05-10 00:{i // 60:02d}:{i % 60:02d}.000 131   " + "".join(f"{v:10.2f}" for v in values))
    path.write_text("\r\n".join(lines) + "\r\n")
    return path


def imagcdf(path: Path, made: Made) -> Path:
    """ImagCDF 1.2 by NASA's layout, written with cdflib: H [nT], D [degrees] and Z; S at times of its own; a gap."""
    from cdflib.cdfwrite import CDF

    file = CDF(path, cdf_spec={"Majority": "row_major"}, delete=True)
    file.write_globalattrs({"IagaCode": {0: "NWH"}, "ObservatoryName": {0: "Nowhere"}, "ElementsRecorded": {0: "HDZS"}})
    tt = cdf_times(made.t_s)
    x, y, z = made.reading.T.copy()
    elements = {"H": np.hypot(x, y), "D": np.degrees(np.arctan2(y, x)), "Z": z.copy()}
    for values in elements.values():
        values[7] = 99999.0
    elements["S"] = np.linalg.norm(made.reference, axis=1)[::2]
    for name, stamps in (("GeomagneticVectorTimes", tt), ("GeomagneticScalarTimes", tt[::2])):
        file.write_var({"Variable": name, "Data_Type": 33, "Num_Elements": 1, "Rec_Vary": True, "Dim_Sizes": []},
                       var_data=stamps)  # fmt: skip
    for name, values in elements.items():
        times = "GeomagneticScalarTimes" if name == "S" else "GeomagneticVectorTimes"
        file.write_var(
            {"Variable": f"GeomagneticField{name}", "Data_Type": 45, "Num_Elements": 1, "Rec_Vary": True,
             "Dim_Sizes": []},
            var_attrs={"UNITS": "Degrees of arc" if name == "D" else "nT", "FILLVAL": [99999.0, "CDF_DOUBLE"],
                       "DEPEND_0": times},
            var_data=values,
        )  # fmt: skip
    file.close()
    return path


def cdf_times(t_s: Array) -> NDArray[np.int64]:
    """TT2000 of times from 2024-05-10 on [ns]: 69.184 s, TT less UTC since 2017, later than UTC's own count."""
    noon_2000, begun = 946_728_000, 1_715_299_200
    return np.round((begun - noon_2000 + 69.184) * 1e9).astype(np.int64) + np.round(t_s * 1e9).astype(np.int64)


def csv(path: Path, columns: Mapping[str, Array], delimiter: str = ",", header: bool = True) -> Path:
    rows = np.column_stack(list(columns.values()))
    lines = [delimiter.join(columns)] if header else []
    lines += [delimiter.join("" if np.isnan(x) else repr(float(x)) for x in row) for row in rows]
    path.write_text("\n".join(lines) + "\n")
    return path


def table(made: Made, **more: Array) -> dict[str, Array]:
    """The recording as columns of a table, in nT and s."""
    found = {"t": made.t_s}
    found |= {f"m{a}": column for a, column in zip("xyz", made.reading.T, strict=True)}
    found |= {f"r{a}": column for a, column in zip("xyz", made.reference.T, strict=True)}
    return {**found, "temp": made.temperature_C, **more}


MAPPING = """format = "labcal-mapping/1"
started_utc = "2026-03-02T08:15:00Z"

[dut]
serial = "SN1"

[time]
column = "t"
unit = "s"

[reading]
columns = ["mx", "my", "mz"]
unit = "nT"

[reference]
kind = "vector"
columns = ["rx", "ry", "rz"]
unit = "nT"
frame = "body"
"""


def mapping(folder: Path, *changes: tuple[str, str], more: str = "", text: str = MAPPING) -> Path:
    """The mapping of `table`, with some of its words changed and more tables behind."""
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new, 1)
    path = folder / "map.toml"
    path.write_text(text + more)
    return path
