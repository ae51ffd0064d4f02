"""Numbers of samples.csv: the text is that of `repr`, whatever writes it, for a run's hash is that of the text."""

from __future__ import annotations

import csv
import io
import json
from dataclasses import replace
from math import isfinite

import numpy as np
import pytest

from labcal.record import Segment
from labcal.store import number_text
from labcal.store.number_text import number_texts
from labcal.store.samples_csv import write_samples
from labcal.testing.made_up_runs import made_up_run

DRAW = np.random.default_rng(12)
POWERS = np.ldexp(1.0, np.arange(-1074, 1024))
TIES = (np.ldexp(1.0, DRAW.integers(44, 53, 20_000)) * DRAW.uniform(1, 2, 20_000)).round() + 0.25
NUMBERS = {
    "any bits": DRAW.integers(0, 2**64, 200_000, dtype=np.uint64).view(np.float64),
    "as measured": DRAW.normal(0, 3e4, 100_000),
    "of few digits": DRAW.normal(0, 3e4, 100_000).round(1),
    "whole": DRAW.normal(0, 3e4, 10_000).round(),
    "of all sizes": 10.0 ** DRAW.uniform(-20, 20, 100_000),
    "powers of two": np.concatenate([POWERS, np.nextafter(POWERS, 0), np.nextafter(POWERS, np.inf)]),
    "powers of ten": np.array([float(f"1e{n}") for n in range(-320, 309)]),
    "halfway": np.concatenate([TIES, TIES + 0.5]),
    "others": np.array([0.0, -0.0, np.nan, np.inf, -np.inf]),
}


@pytest.mark.parametrize("kind", NUMBERS)
def test_the_text_is_that_of_repr(kind: str) -> None:
    values = np.concatenate([NUMBERS[kind], -NUMBERS[kind]])
    expected = [repr(one).removesuffix(".0") if isfinite(one) else "" for one in values.tolist()]
    assert number_texts(values) == expected
    assert number_texts(values[:0]) == []


@pytest.mark.parametrize("other", ["%.17g", "%.1f", "%r0"])
def test_another_program_that_writes_numbers_otherwise_is_not_used(other: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(number_text, "to_json", lambda numbers: f"[{','.join(other % n for n in numbers)}]".encode())
    assert number_texts(np.array([0.1, 2.0, 1 / 3])) == ["0.1", "2", "0.3333333333333333"]


def test_words_are_quoted_as_csv_has_it() -> None:
    run = made_up_run(rows=6).run
    words = ['x, "up"', "plain", "two\nlines"]
    segments = tuple(Segment(word, "free") for word in words)
    modes = np.array([words[n % 3] for n in range(len(run))])
    run = replace(run, segments=segments, segment_index=np.arange(len(run)) % 3, row_mode=modes)
    rows = list(csv.reader(io.StringIO(write_samples(run).decode(), newline="")))
    again = io.StringIO()
    csv.writer(again, lineterminator="\n").writerows(rows)
    assert again.getvalue().encode() == write_samples(run)
    assert [row[rows[0].index("segment")] for row in rows[1:4]] == words
    assert [row[rows[0].index("mode")] for row in rows[1:4]] == words
    assert json.loads(rows[1][0]) == run.t_s[0]
