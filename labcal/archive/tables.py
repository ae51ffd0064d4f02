"""The catalogue: what the archive knows of each run and calibration. Rows are added, none is ever changed.

The key of everything is the site with a SHA-256: two labs may both have a run called demo-0.
"""

from __future__ import annotations

from sqlalchemy import (
    BigInteger,
    Boolean,
    Column,
    DateTime,
    Double,
    Index,
    Integer,
    LargeBinary,
    MetaData,
    Table,
    Text,
    func,
    text,
)

SCHEMA, VERSION = "labcal", "0003"
METADATA = MetaData(schema=SCHEMA)


def _key(name: str) -> Column[str]:
    return Column(name, Text, primary_key=True)


def _text(name: str, *, nullable: bool = False) -> Column[str]:
    return Column(name, Text, nullable=nullable)


def _sensor() -> tuple[Column[bool], Column[str], Column[str], Column[str]]:
    """Whether it is simulated, and which DUT, read in which unit."""
    return (Column("simulated", Boolean, nullable=False), _text("dut_serial"), _text("dut_model"), _text("dut_unit"))


def _pushed() -> tuple[Column[object], Column[str]]:
    return (
        Column("pushed_utc", DateTime(timezone=True), nullable=False, server_default=func.now()),
        Column("pushed_by", Text, nullable=False, server_default=text("CURRENT_USER")),
    )


RUN = Table(
    "run", METADATA, _key("site"), _key("sha256"), _text("run_id"),
    Column("started_utc", DateTime(timezone=True), nullable=False), _text("status"), *_sensor(), _text("operator"),
    _text("procedure"), _text("reference_kind"), _text("reference_serial"),
    Column("n_samples", BigInteger, nullable=False), _text("chain_head", nullable=True),
    _text("bundle_sha256"), Column("bundle_bytes", BigInteger, nullable=False), *_pushed(),
    Index("run_started", "started_utc"), Index("run_named", "run_id"), Index("run_content", "sha256"),
)  # fmt: skip

KEPT_HEAD = Table(  # the head that a run's chain had in the store that it came from: known without reading the run
    "kept_head", METADATA, _key("site"), _key("head"), _text("sha256"),
)  # fmt: skip

INSTRUMENT = Table(  # of a run, or of a calibration: `of` is its SHA-256; the reference is number 0
    "instrument", METADATA, _key("site"), _key("of"), Column("number", Integer, primary_key=True),
    _text("name"), _text("manufacturer"), _text("model"), _text("serial"), _text("firmware"),
    Index("instrument_serial", "serial"),
)  # fmt: skip

CALIBRATION = Table(
    "calibration", METADATA, _key("site"), _key("sha256"), _text("run_sha256"), _text("run_id"),
    *_sensor(), _text("operator"), Column("issued_utc", DateTime(timezone=True), nullable=True),
    _text("number", nullable=True), _text("supersedes", nullable=True),
    Column("content", LargeBinary, nullable=False), *_pushed(),
    Index("calibration_dut", "dut_serial", "dut_model"), Index("calibration_run", "run_sha256"),
    Index("calibration_supersedes", "supersedes"),
)  # fmt: skip

EFFECT = Table(
    "effect", METADATA, _key("site"), _key("calibration"), Column("number", Integer, primary_key=True),
    _text("effect"), _text("belongs_to"), _text("channels"), Column("provisional", Boolean, nullable=False),
    Column("p_value", Double, nullable=True), Index("effect_named", "effect"),
)  # fmt: skip

PARAMETER = Table(  # `of` is "map" (K and k), "figure" (offset, scale, angles between axes) or the effect's id
    "parameter", METADATA, _key("site"), _key("calibration"), Column("number", Integer, primary_key=True),
    _text("of"), _text("name"), Column("value", Double, nullable=False), Column("u", Double, nullable=True),
    _text("unit"), Index("parameter_of", "of", "unit"),
    Index("parameter_named", "calibration", "of", "name"),
)  # fmt: skip

DOCUMENT = Table(  # a signature or a report of the calibration `of`
    "document", METADATA, _key("site"), _key("of"), _key("sha256"), _text("kind"), _text("name"),
    _text("signer"), _text("objection"), Column("content", LargeBinary, nullable=False), _pushed()[0],
    Index("document_content", "sha256"),
)  # fmt: skip

AUDIT = Table(  # `log` is the link of a log's first entry: a site may have several machines
    "audit", METADATA, _key("site"), _key("log"), _key("link"), Column("number", BigInteger, nullable=False),
    _text("utc"), _text("deed"), _text("who"), _text("machine"),
    Column("entry", LargeBinary, nullable=False), Column("signature", LargeBinary, nullable=False),
)  # fmt: skip

OF_A_SITE = (RUN, KEPT_HEAD, INSTRUMENT, CALIBRATION, EFFECT, PARAMETER, DOCUMENT, AUDIT)

SETTING = Table("setting", METADATA, _key("name"), _text("value"))
MEMBER = Table("member", METADATA, _key("role"), _key("lab"), _key("duty"))  # duty: read, push; lab *: all
