"""The first version: runs, calibrations, what was found, documents, audit logs; who sees and adds whose rows."""

from alembic import op

revision, down_revision = "0001", None

TABLES = """
CREATE TABLE labcal.run (
    site text, sha256 text, run_id text NOT NULL, started_utc timestamptz NOT NULL, status text NOT NULL,
    simulated boolean NOT NULL, dut_serial text NOT NULL, dut_model text NOT NULL, dut_unit text NOT NULL,
    operator text NOT NULL, procedure text NOT NULL, reference_kind text NOT NULL, reference_serial text NOT NULL,
    n_samples bigint NOT NULL, chain_head text, bundle_sha256 text NOT NULL, bundle_bytes bigint NOT NULL,
    pushed_utc timestamptz NOT NULL DEFAULT now(), pushed_by text NOT NULL DEFAULT CURRENT_USER,
    PRIMARY KEY (site, sha256));
CREATE INDEX run_started ON labcal.run (started_utc);
CREATE INDEX run_named ON labcal.run (run_id);
CREATE INDEX run_content ON labcal.run (sha256);

CREATE TABLE labcal.kept_head (site text, head text, sha256 text NOT NULL, PRIMARY KEY (site, head));

CREATE TABLE labcal.instrument (
    site text, "of" text, number integer, name text NOT NULL, manufacturer text NOT NULL, model text NOT NULL,
    serial text NOT NULL, firmware text NOT NULL, PRIMARY KEY (site, "of", number));
CREATE INDEX instrument_serial ON labcal.instrument (serial);

CREATE TABLE labcal.calibration (
    site text, sha256 text, run_sha256 text NOT NULL, run_id text NOT NULL,
    simulated boolean NOT NULL, dut_serial text NOT NULL, dut_model text NOT NULL, dut_unit text NOT NULL,
    operator text NOT NULL, issued_utc timestamptz, number text, supersedes text, content bytea NOT NULL,
    pushed_utc timestamptz NOT NULL DEFAULT now(), pushed_by text NOT NULL DEFAULT CURRENT_USER,
    PRIMARY KEY (site, sha256));
CREATE INDEX calibration_dut ON labcal.calibration (dut_serial, dut_model);
CREATE INDEX calibration_run ON labcal.calibration (run_sha256);
CREATE INDEX calibration_supersedes ON labcal.calibration (supersedes);

CREATE TABLE labcal.effect (
    site text, calibration text, number integer, effect text NOT NULL, belongs_to text NOT NULL,
    channels text NOT NULL, provisional boolean NOT NULL, p_value double precision,
    PRIMARY KEY (site, calibration, number));
CREATE INDEX effect_named ON labcal.effect (effect);

CREATE TABLE labcal.parameter (
    site text, calibration text, number integer, "of" text NOT NULL, name text NOT NULL,
    value double precision NOT NULL, u double precision, unit text NOT NULL,
    PRIMARY KEY (site, calibration, number));
CREATE INDEX parameter_of ON labcal.parameter ("of", unit);
CREATE INDEX parameter_named ON labcal.parameter (calibration, "of", name);

CREATE TABLE labcal.document (
    site text, "of" text, sha256 text, kind text NOT NULL, name text NOT NULL, signer text NOT NULL,
    objection text NOT NULL, content bytea NOT NULL, PRIMARY KEY (site, "of", sha256));

CREATE TABLE labcal.audit (
    site text, log text, link text, number bigint NOT NULL, utc text NOT NULL, deed text NOT NULL, who text NOT NULL,
    machine text NOT NULL, entry bytea NOT NULL, signature bytea NOT NULL, PRIMARY KEY (site, log, link));

CREATE TABLE labcal.setting (name text PRIMARY KEY, value text NOT NULL);
CREATE TABLE labcal.member (role text, lab text, duty text, PRIMARY KEY (role, lab, duty));
"""

# The labs in which whoever asks has one of these duties: by their own role, or one that they are a member of. A role
# that this server does not know (the archive was restored elsewhere) gives nobody a right.
LABS = """
CREATE FUNCTION labcal.labs(wanted text[]) RETURNS text[] LANGUAGE sql STABLE SET search_path = pg_catalog AS $$
    SELECT coalesce(array_agg(m.lab), '{}') FROM labcal.member m JOIN pg_roles r ON r.rolname = m.role
    WHERE m.duty = ANY (wanted) AND pg_has_role(r.oid, 'MEMBER') $$
"""

# Nobody but the owner changes or removes a row: there is no policy for it, and no right.
POLICIES = """
ALTER TABLE labcal.{table} ENABLE ROW LEVEL SECURITY;
CREATE POLICY seen ON labcal.{table} FOR SELECT
    USING (site = ANY ((SELECT labcal.labs('{{read,push}}'))::text[]) OR (SELECT labcal.labs('{{read}}')) && '{{*}}');
CREATE POLICY added ON labcal.{table} FOR INSERT
    WITH CHECK (site = ANY ((SELECT labcal.labs('{{push}}'))::text[]){more});
"""
NAMED = " AND pushed_by = CURRENT_USER"
OF_A_SITE = {
    "run": NAMED,
    "kept_head": "",
    "instrument": "",
    "calibration": NAMED,
    "effect": "",
    "parameter": "",
    "document": "",
    "audit": "",
}


def upgrade() -> None:
    """Make it, with its row security."""
    policies = "".join(POLICIES.format(table=table, more=more) for table, more in OF_A_SITE.items())
    op.get_bind().exec_driver_sql(TABLES + LABS + ";" + policies)
