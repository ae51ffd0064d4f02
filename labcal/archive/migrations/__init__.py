"""The catalogue's versions, run by Alembic; `env.py` is what it calls."""
