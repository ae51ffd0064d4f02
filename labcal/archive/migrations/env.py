"""Runs the versions on the connection that `labcal.archive.versions` hands in, within its transaction."""

from alembic import context

from labcal.archive.tables import METADATA, SCHEMA

context.configure(
    connection=context.config.attributes["connection"],
    target_metadata=METADATA,
    version_table_schema=SCHEMA,
    include_schemas=True,
)
context.run_migrations()
