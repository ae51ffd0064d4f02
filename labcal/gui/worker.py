"""A process of its own for whatever takes time or can fail: the bench, fits, the loop, files.

`python -m labcal.gui.worker` reads one JSON request a line from stdin, {"do": verb, "id": n, …}, works through them
in order and answers with messages of that id: any number of "progress", then "done" with a result, or "fault". During
a run it also sends "items", and hears answer, pause, go on, stop, abort and note at any moment.
"""

from __future__ import annotations

import traceback
from collections.abc import Callable
from dataclasses import asdict
from typing import Any

from labcal.gui import bench_verbs, file_verbs, study_verbs
from labcal.gui.talk import Talk, over_standard_streams
from labcal.gui.wire import fault_of

Verb = Callable[..., Any]
VERBS: dict[str, Verb] = {**bench_verbs.VERBS, **study_verbs.VERBS, **file_verbs.VERBS}


def serve(talk: Talk) -> None:
    """Work through what is asked until the window hangs up."""
    for ask in talk.asks():
        number, verb = ask.pop("id"), ask.pop("do")
        try:
            talk.say("done", id=number, result=VERBS[verb](talk, **ask))
        except Exception as error:
            talk.say("fault", id=number, **asdict(fault_of(error, traceback.format_exc())))


if __name__ == "__main__":
    serve(over_standard_streams())
