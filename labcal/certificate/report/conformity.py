"""Is it in specification, and what changed since the calibration before: tables and marks of a printed page."""

from __future__ import annotations

from collections.abc import Sequence

from labcal.certificate.report.page import Block, Mark, Prose, Table, Tone
from labcal.certificate.report.style import number, printed_unit, with_uncertainty
from labcal.record.specification import Specification
from labcal.uncertainty.conformity import WORDS, Change, Changes, Judged, ratio_in_words, risk_in_words

MARKS: dict[str, tuple[str, Tone]] = {
    "pass": ("IN SPECIFICATION", "good"),
    "conditional-pass": ("IN SPECIFICATION, CONDITIONALLY", "warning"),
    "conditional-fail": ("NOT IN SPECIFICATION, CONDITIONALLY", "warning"),
    "fail": ("NOT IN SPECIFICATION", "bad"),
}
RISK = (
    "U is the expanded uncertainty, k = 2 or what the budget states for few degrees of freedom. Risk: the probability "
    "that the true value is beyond its limit, so that of a false acceptance (specific risk, JCGM 106:2012, from this "
    "measurement alone, its distribution normal or Student's t). TUR: limit / U."
)
E_N = (
    "U is that of the difference, k = 2 or more where few degrees of freedom are behind it. E_n = (as left − as found) "
    "/ U: beyond ±1 the sensor has changed. Errors that both calibrations have in common, as those of one reference, "
    "count twice in U. |b| is worked out by either calibration from the readings of the strongest field, without "
    "effects."
)


def conformity_marks(lines: Sequence[Judged]) -> tuple[Mark, ...]:
    """The worst result of all lines as a mark; none without lines."""
    worst = max((line.result for line in lines), key=list(MARKS).index, default=None)
    return () if worst is None else (Mark(*MARKS[worst]),)


def conformity_blocks(
    lines: Sequence[Judged], specification: Specification | None = None, *, recorded: bool = False
) -> list[Block | None]:
    """The table of the specification's lines and the rule that decided; nothing where there are none.

    `specification` is what the run stated, which has the title (ISO/IEC 17025:2017, 7.8.6.2 b). Where the run was
    `recorded` in a chain, the specification was in it before the first sample; else nothing shows when it was chosen.
    """
    if not lines:
        return []
    header = ("Figure", "Value", "U", "Limit ±", "Unit", "Result", "Risk", "TUR")
    rules = dict.fromkeys(line.rule for line in lines)
    when = "chosen before the measurement" if recorded else "as its run states it (when it was chosen is not shown)"
    said = f"Decision rule, {when}: {'; '.join(rules)}."
    which = () if specification is None else (f"Specification: {title_of(specification)}.",)
    return [Table(header, tuple(map(_line, lines)), frozenset({1, 2, 3, 6, 7}), RISK), Prose((*which, said))]


def title_of(specification: Specification) -> str:
    """Which specification it is, in words."""
    return specification.title.rstrip(".") or "without a title; its limits are those that are stated here"


def _line(line: Judged) -> tuple[str, ...]:
    value, U = with_uncertainty(line.value, line.U)
    risk, tur = risk_in_words(line.risk), ratio_in_words(line.tur)
    limit = f"{line.limit:,g}".replace(",", "\u202f")
    return line.quantity, value, U, limit, printed_unit(line.unit), WORDS[line.result], risk, tur


def change_blocks(found: Changes | None) -> list[Block | None]:
    """What changed from the calibration before to this one; nothing where there is none before."""
    if found is None:
        return []
    said = f"As found by the calibration of run {found.found}, as left by this one. {found.in_words()}"
    header = ("Figure", "As found", "As left", "Change", "U", "Unit", "E_n", "")
    table = Table(header, tuple(map(_change, found.rows)), frozenset({1, 2, 3, 4, 6}), E_N)
    return [Prose((said, *found.remarks)), table]


def _change(row: Change) -> tuple[str, ...]:
    U = row.U or float("nan")
    numbers = (with_uncertainty(value, U)[0] for value in (row.found, row.left, row.left - row.found))
    e_n = number(row.e_n, 2)
    return (
        row.quantity.replace(" -", " −"),
        *numbers,
        with_uncertainty(U, U)[1],
        printed_unit(row.unit),
        e_n,
        "changed" if row.changed else "",
    )
