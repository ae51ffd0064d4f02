"""What the worker does with a bench: look at it, greet it, run a procedure on it, switch it off."""

from __future__ import annotations

import traceback
from collections.abc import Callable, Mapping
from dataclasses import asdict
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

from labcal.gui.pace import paced
from labcal.gui.talk import Talk
from labcal.gui.wire import fault_of

if TYPE_CHECKING:
    from labcal.runner import Found, Outcome


def bench_facts(talk: Talk, bench: str) -> dict[str, Any]:
    """What a bench file states: names, roles, limits, the cage's matrix, what is known of the reference."""
    from labcal.bench.cage_file import calibrated
    from labcal.bench.config import read_config

    config, _ = calibrated(read_config(Path(bench)), Path(bench))
    instruments = {name: {"role": i.role, "link": i.link, "driver": i.driver} for name, i in config.instruments.items()}
    return {
        "name": config.name,
        "simulated": config.simulated,
        "dut": config.dut.model_dump(mode="json"),
        "reference": config.reference.model_dump(mode="json"),
        "cage": config.cage.model_dump(mode="json") | {"matrix": config.cage.matrix.tolist()},
        "axis_cage": list(config.platform.axis_cage),
        "instruments": instruments,
    }


def greet(talk: Talk, bench: str) -> list[dict[str, Any]]:
    """Ask every instrument who it is; where the reference did not see a zero, measure that again and say so in each."""
    from labcal import session

    def words(greeting: Any) -> dict[str, Any]:
        fault = None if greeting.fault is None else asdict(fault_of(greeting.fault))
        said = ("name", "role", "link", "identity")
        return {name: getattr(greeting, name) for name in said} | {"fault": fault}

    answers = [words(greeting) for greeting in session.greetings(Path(bench))]
    looked = session.look_again(Path(bench))
    doubt = None if looked is None else {"words": looked.words, "lifted": looked.lifted}
    return [answer | {"doubt": doubt} for answer in answers]


def off(talk: Talk, bench: str) -> list[dict[str, Any]]:
    """Every coil to zero and open, one report an axis, with when it was read and the doubt that stands about zero."""
    from labcal import session
    from labcal.bench.doubt import doubt_of

    ended, doubt = session.coils_off(Path(bench)), doubt_of(Path(bench))
    return [
        {"axis": a.axis, "current_A": a.current_A, "words": a.words, "ok": a.fault is None,
         "read_s": a.read_s, "doubt": doubt}
        for a in ended
    ]  # fmt: skip


def run(
    talk: Talk, procedure: str, bench: str, given: Mapping[str, str], dut: str, operator: str,
    pace: str = "at once", seed: int | None = None, after: str = "",
) -> dict[str, Any]:  # fmt: skip
    """Run a procedure, in simulated time after the run `after`; answers, stop and all else come in by `talk`."""
    from labcal import session

    def work(**common: Any) -> Outcome:
        return session.run(procedure, Path(bench), given, dut=dut, operator=operator, **common)

    return _on_bench(talk, bench, pace, seed, work, after)


def resume(
    talk: Talk, run: str, bench: str, dut: str, pace: str = "at once", seed: int | None = None
) -> dict[str, Any]:
    """Go on with an interrupted run of the DUT `dut`."""
    from labcal import session

    return _on_bench(talk, bench, pace, seed, lambda **common: session.resume(run, Path(bench), dut=dut, **common))


def _on_bench(
    talk: Talk, bench: str, pace: str, seed: int | None, work: Callable[..., Outcome], after: str = ""
) -> dict[str, Any]:
    from labcal.bench.config import read_config

    simulated = read_config(Path(bench)).simulated
    talk.on_bench(simulated)
    try:
        clock = paced(pace, *_from(after)) if simulated else None
        ended = work(answer=talk.answer, clock=clock, seed=seed, control=talk.control, tell=talk.tell, show=talk.show)
    finally:
        talk.off_bench()
    fault = None
    if ended.fault is not None:
        fault = asdict(fault_of(ended.fault, "".join(traceback.format_exception(ended.fault))))
    return {"run_id": ended.run_id, "status": ended.status, "fault": fault, "failed": [m.name for m in ended.failed]}


def _from(after: str) -> tuple[datetime, float]:
    """Where simulated time begins: now, or where a run has ended."""
    if not after:
        return datetime.now(UTC), 0.0
    from labcal import measuring

    return measuring.goes_on(after)


def plan(talk: Talk, procedure: str, bench: str, given: Mapping[str, str], seed: int | None = None) -> list[str]:
    """What a procedure would do, a line each, as rehearsed on the simulated lab; nothing real is touched."""
    from labcal.runner import find
    from labcal.runner.rehearsal import rehearsed

    return rehearsed(Path(bench), find(procedure), given, seed).lines()


def procedures(talk: Talk) -> list[dict[str, Any]]:
    """What there is to run, with what each may be told; of one that does not load its name and the fault."""
    from labcal.runner import catalogue

    def words(found: Found) -> dict[str, Any]:
        parameters = [asdict(p) for p in found.parameters]
        said = ("name", "title", "resumable", "needs", "lasts_min")
        return {name: getattr(found, name) for name in said} | {"parameters": parameters}

    found, broken = catalogue()
    return [words(one) for one in found.values()] + [{"name": name, "fault": str(e)} for name, e in broken.items()]


VERBS: dict[str, Callable[..., Any]] = {
    "bench": bench_facts,
    "greet": greet,
    "off": off,
    "run": run,
    "resume": resume,
    "plan": plan,
    "procedures": procedures,
}
