"""Which format a recording is of: by what it begins with, where that says so, else by its name."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

BY_NAME: Mapping[str, str] = {  # all else is a table of text
    ".ulg": "ulog", ".bin": "dataflash", ".bag": "rosbag", ".mcap": "rosbag", ".db3": "rosbag", ".mat": "mat",
    ".sec": "iaga", ".min": "iaga", ".cdf": "imagcdf",
}  # fmt: skip
BEGINS: Mapping[str, re.Pattern[bytes]] = {
    "ulog": re.compile(rb"ULog\x01\x12\x35"),
    "dataflash": re.compile(rb"\xa3\x95\x80|FMT, ?128, ?89, ?FMT,"),
    "mat": re.compile(rb"MATLAB \d\.\d MAT-file"),
    "iaga": re.compile(rb" Format +IAGA-2002 +\|"),
    "imagcdf": re.compile(rb"\xcd\xf3\x00\x01"),
}
LOOKED_AT = 200  # bytes


def kind_of(path: Path) -> str:
    """One of READERS; a folder is a bag. A file that cannot be read is what its name says."""
    if path.is_dir():
        return "rosbag"
    try:
        with path.open("rb") as file:
            begins = file.read(LOOKED_AT)
    except OSError:
        begins = b""
    by_content = (kind for kind, pattern in BEGINS.items() if pattern.match(begins))
    return next(by_content, BY_NAME.get(path.suffix.lower(), "csv"))
