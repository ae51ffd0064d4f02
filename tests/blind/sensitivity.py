"""How far answers hang on each judgement of `labcal.loop.policy`: `sensitivity.py OUT`.

Each judgement is moved by 30 % down and up, on 24 blind runs that are hard to judge and on faulty copies of two of
them; counted are the runs whose answer changes: verdict, named causes, findings. Results go to OUT/answers.jsonl as
they come, and a second call goes on where the first one ended; another policy starts anew.

Each run is first put through with judgements that know where they would be if they were moved. Where no comparison
comes out otherwise, the answer stays as it is; for the other moves the run is put through again.
"""

from __future__ import annotations

import argparse
import json
import operator
import os
import sys
from collections.abc import Callable, Iterator
from dataclasses import asdict, replace
from functools import cache
from pathlib import Path
from typing import Any

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # the matrices are small; two processes share the cores

import numpy as np

from labcal.loop import close, parallel, policy
from labcal.loop.selection import proof
from labcal.record import Run
from labcal.store import load_bundle

MOVES = (0.7, 1.3)
HERE = Path(__file__).parent
Answer = list[Any]
Move = tuple[str, float]  # a judgement and the factor
Task = tuple[Path, str]  # a run and what is done to it


class Probe(float):
    """A number that rests on judgements: its comparisons note whose move by 30 % would turn them round."""

    if_moved: dict[Move, Any]
    note: Callable[[Move], None]

    @classmethod
    def of(cls, value: float, if_moved: dict[Move, Any], note: Callable[..., None]) -> Probe:
        """The value, and what it would be after each move."""
        made = cls(value)
        made.if_moved, made.note = if_moved, note
        return made

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *args: Any, **words: Any) -> Any:
        """Of arrays: what is done with the result is not followed, so a move matters where the result is another."""
        usual = getattr(ufunc, method)(*map(_bare, args), **words)
        for move in {move for v in args if isinstance(v, Probe) for move in v.if_moved}:
            there = [v.if_moved.get(move, float(v)) if isinstance(v, Probe) else v for v in args]
            if not np.array_equal(getattr(ufunc, method)(*there, **words), usual):
                self.note(move)
        return usual


def _pairs(one: Any, other: Any) -> Iterator[tuple[Move, Any, Any]]:
    """Each move that either rests on, and both values after it."""
    moves = [v.if_moved if isinstance(v, Probe) else {} for v in (one, other)]
    for move in {**moves[0], **moves[1]}:
        yield move, *(m.get(move, _bare(v)) for m, v in zip(moves, (one, other), strict=True))


def _bare(value: Any) -> Any:
    return float(value) if isinstance(value, Probe) else value


def _compared(operation: Callable[[Any, Any], Any]) -> Callable[[Probe, Any], Any]:
    def compare(self: Probe, other: Any) -> Any:
        usual = operation(float(self), _bare(other))
        for move, one, two in _pairs(self, other):
            if not np.array_equal(operation(one, two), usual):
                self.note(move)
        return usual

    return compare


def _computed(operation: Callable[[Any, Any], Any]) -> Callable[[Probe, Any], Any]:
    def compute(self: Probe, other: Any) -> Any:
        usual, moves = operation(float(self), _bare(other)), list(_pairs(self, other))
        if np.ndim(usual) == 0:
            return Probe.of(usual, {move: operation(one, two) for move, one, two in moves}, self.note)
        for move, _, _ in moves:
            self.note(move)  # what becomes of an array is not followed
        return usual

    return compute


def _negated(self: Probe) -> Probe:
    return Probe.of(-float(self), {move: -value for move, value in self.if_moved.items()}, self.note)


Probe.__neg__ = _negated  # type: ignore[method-assign]  # float's own would forget the moves
for _name in ("lt", "le", "gt", "ge"):
    setattr(Probe, f"__{_name}__", _compared(getattr(operator, _name)))
for _name in ("add", "sub", "mul", "truediv", "pow"):
    _operation = getattr(operator, _name)
    setattr(Probe, f"__{_name}__", _computed(_operation))
    setattr(Probe, f"__r{_name}__", _computed(lambda a, b, of=_operation: of(b, a)))


class Watch:
    """The policy as the loop sees it: as it is, or one judgement moved; and which moves would have mattered."""

    def __init__(self) -> None:
        self.forget()

    def forget(self) -> None:
        """As for a run that nobody has seen."""
        self.read, self.mattering = set[str](), set[Move]()
        self.move_to(None)

    def move_to(self, move: Move | None) -> None:
        """One judgement moved, or none."""
        usual = policy.Policy()
        self.moved = move is not None
        self.policy = usual if move is None else replace(usual, **{move[0]: moved(*move)})

    def __getattr__(self, name: str) -> Any:
        derived = getattr(policy.Policy, name, None)
        if isinstance(derived, property) and derived.fget is not None:
            return derived.fget(self)
        value = getattr(self.policy, name)
        if self.moved:
            return value
        self.read.add(name)
        return Probe.of(value, {(name, factor): moved(name, factor) for factor in MOVES}, self.mattering.add)


@cache
def watch_the_loop() -> Watch:
    """The loop with its policy watched; in this process, for good."""
    # what is ignored below is meant: this process does nothing else
    watch = Watch()
    policy.POLICY = watch  # type: ignore[assignment]
    parallel.CORES = 1  # two processes share the cores
    proof.null_distribution = lambda *_: np.zeros(1)  # p-values are reported, and decide nothing
    return watch


def answer(run: Run) -> Answer:
    """Verdict, named causes, kinds of findings; an error's first words."""
    try:
        closed = close.close_loop(run)
    except Exception as error:
        return ["error", str(error)[:60], []]
    named = sorted([e.effect, *e.channels] for e in closed.accepted)
    return [closed.verdict, named, sorted({f.kind for f in closed.findings})]


def moved(name: str, factor: float) -> float:
    """A judgement 30 % away from where it would decide nothing: a ratio from one, all else from zero.

    A count is moved by one at least.
    """
    stated = policy.judgements()[name]
    if isinstance(stated.value, int):
        return stated.value + int(np.sign(factor - 1)) * max(1, round(abs(factor - 1) * stated.value))
    return stated.about + factor * (stated.value - stated.about)


def answers(task: Task) -> dict[str, Any]:
    """Of one run: its answer, the answers that change, and the judgements that were read."""
    folder, fault = task
    watch = watch_the_loop()
    watch.forget()
    run = FAULTS[fault](load_bundle(folder / "bundle").run())
    usual, changed = answer(run), {}
    read, mattering = sorted(watch.read), sorted(watch.mattering)
    for move in mattering:
        watch.move_to(move)
        if (now := answer(run)) != usual:
            changed[f"{move[0]} {move[1]}"] = now
    seen = {"run": folder.name, "fault": fault, "answer": usual, "changed": changed, "read": read}
    return {**seen, "turned": sorted({name for name, _ in mattering})}


def _turned(run: Run, P: list[int]) -> Run:
    assert run.reference_vector is not None
    return replace(run, reference_vector=run.reference_vector[:, P])


def _late(run: Run) -> Run:
    assert run.reference_vector is not None
    at = np.stack([np.interp(run.t_s - 4.0, run.t_s, v) for v in run.reading.T], axis=1)
    return replace(run, reading=at)


def _radians(run: Run) -> Run:
    return run if run.angle_deg is None else replace(run, angle_deg=np.radians(run.angle_deg))


def _one_axis(run: Run) -> Run:
    return run.select(np.isin(run.segment_index, [i for i, s in enumerate(run.segments) if s.axis_body == (0, 0, 1)]))


FAULTS: dict[str, Callable[[Run], Run]] = {
    "": lambda run: run,
    "axes exchanged": lambda run: _turned(run, [1, 0, 2]),
    "angle in radians": _radians,
    "clock 4 s late": _late,
    "another unit": lambda run: replace(run, reading=run.reading / 1000),
    "about one axis alone": _one_axis,
    "noise not declared": lambda run: replace(run, dut=replace(run.dut, noise_nT=None)),
    "twice the noise declared": lambda run: replace(run, dut=replace(run.dut, noise_nT=2 * (run.dut.noise_nT or 1.0))),
}


def tasks(runs: Path) -> list[Task]:
    """The runs as they are, and faulty copies of two of them."""
    folders = sorted(p for p in runs.iterdir() if (p / "bundle").is_dir())
    stated = {f: json.loads((f / "bundle" / "run.json").read_text()) for f in folders}
    vectors = [f for f in folders if stated[f]["reference"]["kind"] == "vector"]
    return [(f, "") for f in folders] + [(f, fault) for f in vectors[:2] for fault in FAULTS if fault]


def table(rows: list[dict[str, Any]]) -> str:
    """Runs whose answer changes, for each judgement and move, the most telling first; in Markdown."""
    found = {}
    for name in asdict(policy.Policy()):
        each = [[r for r in rows if f"{name} {factor}" in r["changed"]] for factor in MOVES]
        found[name] = [*(sum(name in r[how] for r in rows) for how in ("read", "turned")), *map(len, each)]
    lines = [
        "| judgement | value | runs that read it | a comparison turns in | answers that change at −30 % | at +30 % |"
    ]
    lines += ["|---|---|---|---|---|---|"]
    for name, counts in sorted(found.items(), key=lambda item: -sum(item[1][2:])):
        lines.append(f"| {name} | {getattr(policy.Policy(), name):.4g} | {' | '.join(map(str, counts))} |")
    return "\n".join([*lines, "", f"{len(rows)} runs, {len(found)} judgements."])


def finished(kept: Path) -> list[dict[str, Any]]:
    """The answers in a file; a line that was cut short is none, and goes."""
    whole = kept.read_bytes().rpartition(b"\n")
    kept.write_bytes(whole[0] + whole[1])
    return [json.loads(line) for line in whole[0].splitlines()]


def main(out: Path, seed: str, processes: int) -> None:
    """Write what is missing of the answers, then print the table."""
    from concurrent.futures import ProcessPoolExecutor, as_completed

    kept, stated = out / "answers.jsonl", out / "policy.json"
    now = json.dumps([asdict(policy.Policy()), seed])
    if not stated.exists() or stated.read_text() != now:
        out.mkdir(parents=True, exist_ok=True)
        kept.write_text("")
        stated.write_text(now)
    if not (out / "runs").exists():
        import subprocess

        subprocess.run([sys.executable, HERE / "simulate.py", out / "runs", "delicate", seed], check=True)
    rows = finished(kept)
    done = {(r["run"], r["fault"]) for r in rows}
    with ProcessPoolExecutor(processes) as pool:
        left = [t for t in tasks(out / "runs") if (t[0].name, t[1]) not in done]
        for future in as_completed([pool.submit(answers, t) for t in left]):
            rows.append(future.result())
            with kept.open("a") as file:
                file.write(json.dumps(rows[-1]) + "\n")
            print(f"{len(rows)} of {len(done) + len(left)}", file=sys.stderr)
    print(table(rows))


if __name__ == "__main__":
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("out", type=Path)
    asked.add_argument("--seed", default="4242")
    asked.add_argument("--processes", type=int, default=2)
    main(**vars(asked.parse_args()))
