"""When each signature and report came, by the server's clock: of those that are there, when this step was made."""

from alembic import op

revision, down_revision = "0002", "0001"

STEP = """
ALTER TABLE labcal.document ADD COLUMN pushed_utc timestamptz NOT NULL DEFAULT now();
CREATE INDEX document_content ON labcal.document (sha256);
CREATE FUNCTION labcal.by_the_clock() RETURNS trigger LANGUAGE plpgsql SET search_path = pg_catalog AS $$
    BEGIN NEW.pushed_utc := now(); RETURN NEW; END $$;
CREATE TRIGGER by_the_clock BEFORE INSERT ON labcal.document
    FOR EACH ROW EXECUTE FUNCTION labcal.by_the_clock();
"""


def upgrade() -> None:
    """Nobody who pushes says when it was."""
    op.get_bind().exec_driver_sql(STEP)
