"""Who has answered in this process, by link: one that falls silent later has lost plug or power; the file is right."""

from __future__ import annotations

PLUG = "It has answered at this link before: is its plug in at both ends, and has it power?"
NOT_HEARD = (  # what else is asked of one that is silent
    "Is it switched on, and is the link in bench.toml the right one?",
    "Is it switched on, are address and baud rate right, are A and B not swapped?",
)
LINE, MODBUS = NOT_HEARD
_heard = set[tuple[str, int | None]]()


def heard(url: str, device: int | None = None) -> None:
    """Somebody answered at `url`; of several on one line, `device`. All emulated ones have one link, and no plug."""
    if not url.startswith("emulated://"):
        _heard.add((url, device))


def remedy(otherwise: str, url: str, device: int | None = None) -> str:
    """What to look at where nobody answers there now; `otherwise`: where nobody ever did."""
    return PLUG if (url, device) in _heard else otherwise


def forget() -> None:
    """Another lab: nobody has answered yet."""
    _heard.clear()
