"""The table of docs/reliability.md from a campaign's results, and its sentences for people to read.

`… add campaign-out docs/reliability.md` counts more trials of the kinds that stand there, of other seeds (`--first` of
the campaign), once: a row is then of all of them.

`python tests/campaign/reliability.py table campaign-out docs/reliability.md` writes the table between its two marks.
Rows of kinds that these results do not have stay as they are, with what was said below the table of earlier ones.
`… words campaign-out 20` prints twenty trials of each kind word for word, with what flowed when each was said.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from campaign import results
from kinds import Kind, kinds
from verdict import faults, in_time_can_be_told

SAID_WRONGLY = {"current not told", "traceback"}
BEGINS, ENDS = "<!-- campaign: begin -->", "<!-- campaign: end -->"
HEAD = (
    "| kind | n | at zero in time | worst, s | zero heard in time | worst, s | energised again | rows lost "
    "| false zero | otherwise said wrongly | read by people: true |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|\n"
)


Read = Mapping[tuple[str, int], bool]


def table(records: Sequence[dict[str, Any]], read: Read, before: str = "", *, more: bool = False) -> str:
    """A row for each kind that was tried; `read`: whether people found all words of a trial true.

    `before`: a table whose rows, and words below it, stay where these results have none of their own; with `more`
    these results are counted with theirs. Raises ValueError where that was done already.
    """
    tried = [record for record in records if "not_tried" not in record]
    of_kind = {name: [r for r in tried if r["kind"] == name] for name in kinds()}
    rows = {name: _row(kinds()[name], found, read) for name, found in of_kind.items() if found}
    if more and _in_all(tried).strip() in before:
        raise ValueError("these results are counted there already")
    kept = {line.split("|")[1].strip(): f"{line}\n" for line in before.splitlines() if line.startswith("| ")}
    if more:
        rows = {name: _together(kept[name], row) if name in kept else row for name, row in rows.items()}
    rows = {name: row for name in kinds() if (row := rows.get(name, kept.get(name)))}
    last = _in_all(tried)
    words = [line for line in before.splitlines() if line and not line.startswith("|") and line != last.strip()]
    return HEAD + "".join(rows.values()) + "\n" + "\n".join([*words, last])


def _row(kind: Kind, found: Sequence[dict[str, Any]], read: Read) -> str:
    wrong = [faults(record) for record in found]
    told = [record for record in found if in_time_can_be_told(record)]
    in_time = _share(told, {"never at zero", "late at zero"}) if not kind.never else "never"
    heard = "never" if kind.never or kind.cut else _share(told, {"zero heard late"})
    cells = [
        kind.name, str(len(found)), in_time, _worst(r["at_zero_s"] for r in found), heard,
        _worst(r["heard_s"] for r in found), str(sum("energised again" in w for w in wrong)),
        str(sum(r["rows_lost"] for r in found)), str(sum("false zero" in w for w in wrong)),
        str(sum(bool(SAID_WRONGLY & set(w)) for w in wrong)), _by_people(found, read),
    ]  # fmt: skip
    return f"| {' | '.join(cells)} |\n"


def _together(one: str, other: str) -> str:
    """One row of two: what was counted is added, of times the worst stands."""
    cells = zip(*([cell.strip() for cell in row.strip().strip("|").split("|")] for row in (one, other)), strict=True)
    name, *rest = (a if a == b and k == 0 else _sum(a, b) for k, (a, b) in enumerate(cells))
    return f"| {' | '.join([name, *rest])} |\n"


def _sum(a: str, b: str) -> str:
    if "never" in (a, b):
        return "never"
    if "none read" in (a, b):
        return b if a == "none read" else a
    if " of " in a:
        (well, n), (more, m) = (map(int, cell.split(" of ")) for cell in (a, b))
        return f"{well + more} of {n + m}"
    return f"{max(float(a), float(b)):.2f}" if "." in a + b else str(int(a) + int(b))


def _by_people(found: Sequence[dict[str, Any]], read: Read) -> str:
    true = [read[r["kind"], r["seed"]] for r in found if (r["kind"], r["seed"]) in read]
    return f"{sum(true)} of {len(true)}" if true else "none read"


def read_by_people(path: Path) -> Read:
    """What stands in `path`: one line a trial, KIND, SEED, true or false, and why, apart by tabs."""
    lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
    cells = [line.split("\t") for line in lines if line.strip()]
    return {(kind, int(seed)): verdict == "true" for kind, seed, verdict, *_ in cells}


def _share(told: Sequence[dict[str, Any]], bad: set[str]) -> str:
    """How many of those that the machine let be in time were."""
    well = sum(not bad & set(faults(record)) for record in told)
    return f"{well} of {len(told)}"


def _worst(times: Iterable[float | None]) -> str:
    known = list(times)
    return "never" if None in known else f"{max(t for t in known if t is not None):.2f}"


def _in_all(tried: Sequence[dict[str, Any]]) -> str:
    load = sorted(record["load"] for record in tried)
    untold = sum(not in_time_can_be_told(record) for record in tried)
    at = f"load {load[0]:.1f} to {load[-1]:.1f}, median {load[len(load) // 2]:.1f}, on two cores"
    of = ", ".join(sorted({record.get("of") or "unknown" for record in tried}))
    return f"- {len(tried)} faults of the code {of} ({at}), {untold} of them judged by all but the time\n"


def words(records: Sequence[dict[str, Any]], of_each: int) -> str:
    """What was said in some trials of each kind, for people to read."""
    text = list[str]()
    for name in kinds():
        for record in [r for r in records if r["kind"] == name and "not_tried" not in r][:of_each]:
            zero = ", ".join(f"{axis} {t}" for axis, t in record["zero_of"].items())
            wrong = ", ".join(faults(record)) or "well"
            text.append(f"\n## {name}, seed {record['seed']} on {record['bench']}, coil {record['axis']}: {wrong}")
            due = f"zero due {record['due_after_deed_s']} s after the deed, exit {record['code']}"
            text.append(f"{due}; s from there to zero: {zero}")
            text += [f"{t_s:8.2f}  {said}" for t_s, said in record["words"]]
    return "\n".join(text)


def between_marks(report: Path) -> str:
    """What stands between the marks of the report now."""
    return report.read_text(encoding="utf-8").partition(BEGINS)[2].partition(ENDS)[0]


def put(report: Path, between: str) -> None:
    """Replace what stands between the marks of the report."""
    before, _, rest = report.read_text(encoding="utf-8").partition(BEGINS)
    after = rest.partition(ENDS)[2]
    report.write_text(f"{before}{BEGINS}\n{between}{ENDS}{after}", encoding="utf-8")


if __name__ == "__main__":
    found = results(Path(sys.argv[2]) / "results.jsonl")
    if sys.argv[1] in ("table", "add"):
        report, read = Path(sys.argv[3]), read_by_people(Path(sys.argv[2]) / "read.tsv")
        put(report, table(found, read, between_marks(report), more=sys.argv[1] == "add"))
    else:
        print(words(found, int(sys.argv[3])))
