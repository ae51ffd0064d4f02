"""How far answers hang on each judgement of `labcal.loop.policy`: `sensitivity.py OUT [SEED]`.

Each judgement is moved by 30 % down and up, on 24 blind runs that are hard to judge and on faulty copies of two of
them; counted are the runs whose answer changes: verdict, named causes, findings. Results go to OUT/answers.jsonl as
they come, and a second call goes on where the first one ended; another policy starts anew.

Each run is first put through with judgements that know where they would be if they were moved. Where no comparison
comes out otherwise, the answer stays as it is. For the others the run is put through again, but only what the move
matters to: every result that the loop keeps is remembered with the moves that would have turned a comparison in it.
"""

from __future__ import annotations

import json
import operator
import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # the matrices are small; two processes share the cores

import numpy as np

from labcal.loop import assemble, close, parallel, policy
from labcal.loop.candidates.columns import Memo
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.selection import joint_fit, proof
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
        self.read, self.mattering = set[str](), [set[Move]()]
        self.move_to(None)

    def move_to(self, move: Move | None) -> None:
        """One judgement moved, or none."""
        usual = policy.Policy()
        self.move = move
        self.policy = usual if move is None else replace(usual, **{move[0]: moved(*move)})

    def __getattr__(self, name: str) -> Any:
        derived = getattr(policy.Policy, name, None)
        if isinstance(derived, property) and derived.fget is not None:
            return derived.fget(self)
        self.read.add(name)
        value, moves = getattr(self.policy, name), [(name, factor) for factor in MOVES]
        if self.move is None and isinstance(value, float):
            return Probe.of(value, {move: moved(*move) for move in moves}, self.note)
        for move in moves:
            self.note(move)
        return value

    def note(self, move: Move) -> None:
        """A move that matters to all that is being watched."""
        for level in self.mattering:
            level.add(move)

    @contextmanager
    def watching(self) -> Iterator[set[Move]]:
        """The moves that matter to what is done inside."""
        self.mattering.append(set())
        try:
            yield self.mattering[-1]
        finally:
            self.mattering.pop()


@dataclass(frozen=True, eq=False)
class Result:
    """What a function gave, the moves that matter to it, and what its key names by address: not to be freed."""

    value: Any
    mattering: set[Move]
    alive: Any


class Kept:
    """Results of pure functions by their arguments."""

    def __init__(self, watch: Watch) -> None:
        self.watch = watch
        self.known: dict[Any, Result] = {}
        self.under_move: dict[Any, Result] = {}

    def get(self, key: Any, make: Callable[[], Any], alive: Any) -> Any:
        """What `make` gives; made anew where the present move matters to it."""
        found = self.under_move.get(key)
        if found is None and (usual := self.known.get(key)) and self.watch.move not in usual.mattering:
            found = usual
        if found is None:
            with self.watch.watching() as mattering:
                found = Result(make(), mattering, alive)
            home = self.under_move if self.watch.move in mattering else self.known
            home[key] = found
        for move in found.mattering:
            self.watch.note(move)
        return found.value

    def function(self, of: Callable[..., Any]) -> Callable[..., Any]:
        """The function, its results kept."""

        def kept(*args: Any, **words: Any) -> Any:
            key = (of, *map(_key, args), *((name, _key(value)) for name, value in sorted(words.items())))
            return self.get(key, lambda: of(*args, **words), (args, words))

        return kept


def _key(value: Any) -> Any:
    """Arrays and numbers by what they are, sequences by their elements, all else by identity."""
    if isinstance(value, np.ndarray):
        return value.tobytes()
    if isinstance(value, (list, tuple)):
        return tuple(map(_key, value))
    return value if isinstance(value, (int, float, str, type(None))) else id(value)


@cache
def watch_the_loop() -> tuple[Watch, Kept]:
    """The loop with its policy watched and its results kept; in this process, for good."""
    # what is ignored below is meant: everything is replaced by itself, watched, and this process does nothing else
    watch = Watch()
    kept = Kept(watch)
    policy.POLICY = watch  # type: ignore[assignment]
    parallel.CORES = 1  # what one thread reads belongs to the result that it makes
    Memo.get = lambda self, what, about, make: kept.get((id(self), what, *map(id, about)), make, (self, about))  # type: ignore[method-assign,assignment]
    for name in ("prepare", "check_data", "joint_fit"):
        setattr(close, name, kept.function(getattr(close, name)))
    for module, name in ((proof, "joint_fit"), (assemble, "joint_fit"), (assemble, "residual_tests")):
        setattr(module, name, kept.function(getattr(module, name)))
    CandidateSet.of = kept.function(CandidateSet.of)  # type: ignore[method-assign]
    CandidateSet.without_rows = _method(kept, CandidateSet.without_rows)  # type: ignore[method-assign]
    joint_fit.JointFit.uncorrected = _method(kept, joint_fit.JointFit.uncorrected)  # type: ignore[method-assign]
    proof.null_distribution = lambda *_: np.zeros(1)  # p-values are told, and decide nothing
    return watch, kept


def _method(kept: Kept, of: Callable[..., Any]) -> Callable[..., Any]:
    function = kept.function(of)
    return lambda self, *args: function(self, *args)


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
    watch, kept = watch_the_loop()
    watch.forget()
    kept.known.clear()
    run = FAULTS[fault](load_bundle(folder / "bundle").run())
    usual, changed = answer(run), {}
    read, mattering = sorted(watch.read), sorted(watch.mattering[0])
    for move in mattering:
        watch.move_to(move)
        kept.under_move.clear()
        if (now := answer(run)) != usual:
            changed[f"{move[0]} {move[1]}"] = now
    told = {"run": folder.name, "fault": fault, "answer": usual, "changed": changed, "read": read}
    return {**told, "turned": sorted({name for name, _ in mattering})}


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


def main(out: Path, seed: str) -> None:
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
    rows = [json.loads(line) for line in kept.read_text().splitlines()]
    done = {(r["run"], r["fault"]) for r in rows}
    with ProcessPoolExecutor(2) as pool:
        left = [t for t in tasks(out / "runs") if (t[0].name, t[1]) not in done]
        for future in as_completed([pool.submit(answers, t) for t in left]):
            rows.append(future.result())
            with kept.open("a") as file:
                file.write(json.dumps(rows[-1]) + "\n")
            print(f"{len(rows)} of {len(done) + len(left)}", file=sys.stderr)
    print(table(rows))


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else "4242")
