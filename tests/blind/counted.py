"""What answers to blind runs come to: rates with 95 % intervals, program by program, and what was taken for what."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from score import rate

Row = dict[str, Any]
STRONG = 2.0  # noise standard deviations


def strong_causes(row: Row) -> set[str]:
    """Ids whose effect sticks out of the noise by twice its standard deviation or more."""
    return {cause for cause, size in row["truth"]["rms_over_noise"].items() if size >= STRONG} & {
        *row["truth"]["cause"]
    }


def held(row: Row) -> list[set[str]]:
    """Each accepted name with the rivals that were stated beside it."""
    return [{name, *rivals} for name, rivals in zip(row["named"], row["rivals"], strict=True)]


def right(row: Row) -> bool:
    """Every strong cause is named, or in a stated set of at most three rivals."""
    return all(any(cause in group and len(group) <= 3 for group in held(row)) for cause in strong_causes(row))


def wrong(row: Row) -> list[str]:
    """Names that are neither at work, nor beside a rival that is, nor a part of what has no name."""
    fair = {*row["truth"]["cause"], *row["truth"]["not_wrong"]}
    return [name for name, group in zip(row["named"], held(row), strict=True) if not fair & group]


def decoys_named(row: Row) -> list[str]:
    """Channels that drive nothing and stand in an accepted effect."""
    named = {channel for channels in row["channels"] for channel in channels}
    return sorted(named & {*row["truth"]["decoys"]})


def quantiles(values: Sequence[float], at: Sequence[float]) -> str:
    """Quantiles in words; a dash where there is nothing."""
    return " to ".join(f"{v:.3f}" for v in np.quantile(values, at)) if values else "—"


def figures(rows: Sequence[Row]) -> dict[str, str]:
    """Each line of the table for some runs."""
    told = [r for r in rows if "error" not in r]
    known = [r for r in told if strong_causes(r) and not r["truth"]["unnamed"]]
    single = [r for r in known if len(r["truth"]["kinds"]) == 1]
    pairs = [r for r in known if len(r["truth"]["kinds"]) > 1]
    weak = [r for r in told if r["truth"]["cause"] and not strong_causes(r)]
    nothing = [r for r in told if not r["truth"]["kinds"]]
    unnamed = [r for r in told if r["truth"]["unnamed"]]
    offered = [(r, d) for r in told for d in r["truth"]["decoys"]]
    claims = [r["after"] / r["fresh"] for r in told if r["verdict"] in ("clean", "explained")]
    over = [r["fresh"] / r["knew"] for r in known]
    within = [r["fresh_within"] / r["knew"] for r in known if np.isfinite(r.get("fresh_within", np.nan))]
    stated = [r for r in told if np.isfinite(r["over_stated"])]
    whole = [r["over_stated"] for r in stated if r["verdict"] in ("clean", "explained")]
    structured = [r["over_stated"] for r in stated if r["verdict"] not in ("clean", "explained")]
    seconds = [r["seconds"] for r in told]
    return {
        "runs (ended in an error)": f"{len(rows)} ({len(rows) - len(told)})",
        "right cause where its rms ≥ 2 noise sd": _of(known, right),
        "of these, one cause alone": _of(single, right),
        "of these, weak beside strong": _of(pairs, right),
        "right cause, weaker than that": _of(weak, lambda r: {*r["truth"]["cause"]} <= {n for g in held(r) for n in g}),
        "a wrong name accepted, all runs": _of(told, lambda r: bool(wrong(r))),
        "something added to nothing": _of(nothing, lambda r: bool(r["named"])),
        "decoys named, of all offered": _of(offered, lambda pair: pair[1] in decoys_named(pair[0])),
        "what has no name given a wrong one": _of(unnamed, lambda r: bool(wrong(r))),
        "`ambiguous` where one cause is at work": _of(single, lambda r: r["verdict"] == "ambiguous"),
        "claimed over fresh error, 10 to 90 % (`clean`, `explained`)": quantiles(claims, (0.1, 0.9)),
        "fresh error over a fit that knew, median to 90 %": quantiles(over, (0.5, 0.9)),
        "rows without a flag over a fit that knew of all rows, median to 90 %": quantiles(within, (0.5, 0.9)),
        "fresh error over u_nT, rows without a flag, 10 to 90 % (`clean`, `explained`)": quantiles(whole, (0.1, 0.9)),
        "the same where structure is left": quantiles(structured, (0.1, 0.9)),
        "seconds of processor a run, median to largest": quantiles(seconds, (0.5, 1.0)),
    }


def _of(rows: Sequence[Any], test: Callable[[Any], bool]) -> str:
    return rate(rows, test).replace(" of ", "/").replace(": ", ", ")


def table(each: dict[str, list[Row]]) -> str:
    """One column for each program, and all together; then its confusion matrix."""
    columns = {**each, "all": [row for rows in each.values() for row in rows]}
    counted = {name: figures(rows) for name, rows in columns.items()}
    lines = [f"| | {' | '.join(counted)} |", f"|---|{'---|' * len(counted)}"]
    for line in next(iter(counted.values())):
        lines.append(f"| {line} | {' | '.join(c[line] for c in counted.values())} |")
    for name, rows in each.items():
        lines += ["", f"**{name}**", "", *confusion([r for r in rows if "error" not in r])]
    return "\n".join(lines)


def confusion(rows: Sequence[Row]) -> list[str]:
    """At work against named; a pair's order tells which is the strong one."""
    counts: dict[str, Counter[str]] = {}
    for row in rows:
        names = " + ".join(sorted(set(row["named"]))) or f"nothing ({row['verdict']})"
        kinds = " + ".join(row["truth"]["kinds"]) or "nothing"
        ids = " + ".join(sorted(row["truth"]["cause"]))
        what = f"{kinds} ({ids})" if ids and ids != kinds else kinds
        counts.setdefault(what, Counter())[names + (" ?" if row["verdict"] == "ambiguous" else "")] += 1
    lines = ["| at work | named (? with rivals) |", "|---|---|"]
    for what in sorted(counts):
        lines.append(f"| {what} | {', '.join(f'{name} × {n}' for name, n in counts[what].most_common())} |")
    return lines
