"""Where the store, the keys and the settings of this user lie."""

from __future__ import annotations

import os
from pathlib import Path


def home() -> Path:
    """The folder `LABCAL_HOME` names, else the user's data folder for labcal. It need not exist yet."""
    if stated := os.environ.get("LABCAL_HOME"):
        return Path(stated).expanduser()
    import platformdirs

    return platformdirs.user_data_path("labcal", appauthor=False)
