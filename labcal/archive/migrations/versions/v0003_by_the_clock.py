"""When each run and calibration came, by the server's clock, as it is of signatures since the second version."""

from alembic import op

revision, down_revision = "0003", "0002"

STEP = """
CREATE TRIGGER by_the_clock BEFORE INSERT ON labcal.run FOR EACH ROW EXECUTE FUNCTION labcal.by_the_clock();
CREATE TRIGGER by_the_clock BEFORE INSERT ON labcal.calibration FOR EACH ROW EXECUTE FUNCTION labcal.by_the_clock();
"""


def upgrade() -> None:
    """Nobody who pushes says when it was."""
    op.get_bind().exec_driver_sql(STEP)
