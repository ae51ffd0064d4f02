"""Judgements stand in one place, with their source and a test; what else is a number in the loop is listed by kind."""

from __future__ import annotations

import ast
import math
import re
from collections.abc import Iterator
from dataclasses import FrozenInstanceError, fields
from pathlib import Path

import numpy as np
import pytest

from labcal.loop import policy
from labcal.loop.data.outliers import hampel_outliers

ROOT = Path(__file__).parents[2]
LOOP = ROOT / "labcal" / "loop"
SPELT_OUT = (0, 0.5, 1, 2, 3)  # numbers that say no more than words do: none, half, all, both, the axes
TOLERANCE = 1e-3  # a smaller number is arithmetic's
TURN_deg = 360.0  # with 100 % and 1000 nT in a µT, which stand in sentences: units, and the only ones
UNITS_IN_SENTENCES = (100, 1000)
KINDS = {
    "budget of a search": (
        "candidates.changepoints:PEAKS EDGE APART", "candidates.angle_zeros:TRIED SWEEPS EVALUATIONS",
        "candidates.spectral_lines:PEAKS SKIRT BETWEEN",
        "data.checks:OFFSETS_S STEPS_S", "design.discrimination:NEW_ROWS CLEAR", "design.proposal:LISTED AMPLE",
        "selection.crossval:FOLDS BLOCKS CORRELATION_TIMES BLOCK_ROWS DRAWS TWO_BLOCKS INTERVAL_95",
        "selection.equivalents:MAX_TRIED", "selection.exchanged:MAX_TRIED",
        "selection.heldout_rules:ALTERNATIVES", "selection.pairs:SHORTLIST SCORED_IN_FULL",
        "selection.misfit:MOST_DIRECTIONS", "selection.discrepancy:NEAREST", "selection.select:MAX_ROUNDS OUT_OF_REACH",
        "selection.second_order:MOST_FORMS", "selection.stepwise:MAX_EFFECTS NEARLY_WHITE NEAREST",
        "selection.admission:LIKELIEST",
        "selection.surrogates:SURROGATES TAIL", "empirical.build:SHORTLIST HYPERPARAMETERS",
        "selection.time_or_channel:HYPERPARAMETERS",
        "candidates.folded_lines:HIGHEST_Hz MOST_ORDERS CONTRAST EXACT PER_RESOLUTION LOOKED_AT_CLOSELY BETWEEN",
        "empirical.inputs:MOST_CHANNELS", "noise.cross_correlation:MAX_LAG",
        "candidates.refine:BRACKETINGS TURNS FURTHER", "selection.final_fit:MAX_SEARCHES",
    ),
    "size of a sample": (
        "data.base_model:MIN_ROWS", "data.checks:QUICK_FIT_ROWS", "data.noise_floor:ROWS_EACH",
        "data.saturation:NEIGHBOUR_READINGS",
        "data.outliers:WINDOW LONGEST_OUTLIER WIDE_WINDOW",
        "findings.residual_tests:MIN_ROWS MIN_VISITS",
        "findings.run_findings:MIN_COMMON_ROWS", "noise.autocorrelation:LAGS LONGEST_LAG",
    ),
    "setting of an estimator": (
        "data.decimate:TARGET_ROWS MAX_TURN_RAD USUAL_TURN LINE_CONTRAST",
        "data.noise_floor:MIN_STEPS_PER_ROW MIN_CHANGING STEP_TOLERANCE ANGLE_DECIMALS", "data.resolution:NEAR OFF",
        "findings.residual_tests:CELLS SIZES", "noise.bands:BANDS_PER_OCTAVE CORNERS RATIOS INDISTINGUISHABLE",
        "selection.discrepancy:DEGREES HARMONICS",
        "selection.misfit:HARMONICS LATE_ROWS SMEARED_ROWS KEPT CUBIC SPLINES",
        "noise.bounded:CORNERS POWERS SIZES WHITE_ODDS BELOW_LOWEST IN_A_BAND", "noise.marginal:RATIOS",
        "empirical.splines:DEGREE SPLINES LENGTHS KEPT",
        "beginnings:SPREADS SMALLEST ANYWHERE_TOO MOST_SEGMENTS SEEN",
        "noise.periodogram:FINER MEDIAN_WIDTH LONGEST PADDING", "noise.cross_correlation:TAPERED",
        "selection.related:RANDOM_DIRECTIONS DECIMALS TINY COMMON", "selection.joint_fit:SLOPE_STEP_nT",
    ),
    "arithmetic and computing time": (
        "candidates.angle_zeros:HARMONICS NODES SAME FINE",
        "candidates.columns:GROUP_COLUMNS", "candidates.interpolated:ROWS NOT_NEW EXACT", "close:LONG_s STILL",
        "closures:SHARE SETTLED_S",
        "progress_report:SILENT_s",
        "candidates.refine:SECANT_ROUNDS ROUGHLY EXACTLY",
        "candidates.scorer:GROUP_SHARE LONG_RUN PRIMES CACHE_NUMBERS", "data.batch_fit:ALTERNATIONS SLACK",
        "data.checks:AXIS_ROUNDING MIN_FIELD_nT", "data.credible:WILD", "data.base_model:ITERATIONS",
        "noise.bands:LENGTHS_KEPT PRIMES", "findings.run_findings:ONE_SIGNAL", "findings.working_range:NOTHING",
        "noise.coloured:RIDGE PARALLEL_FROM", "noise.nuisance:MIN_NEW_SHARE RANK_TOLERANCE", "parallel:CORES",
        "noise.declared_directions:SHOWS",
        "selection.crossval:NEVER", "selection.proof:PLAYS",
        "selection.joint_fit:STEPS HALVINGS LEAST_FALL ROUNDS SETTLED_nT",
    ),
    "constant of mathematics": (
        "data.resolution:ROUNDING", "selection.moment:UNIFORM", "noise.differences:SIGMA_PER_MAD SECOND_DIFFERENCE",
        "findings.residual_tests:SPIRAL",
        "findings.own_colour:KURTOSIS VARIANCE_OF_SKEWNESS VARIANCE_OF_KURTOSIS",
    ),
    "run that is simulated": (
        "design.experiments:ROWS MIN_ROWS GAP_S WARMER_C CYCLES LADDER_nT LADDER_STEPS ROWS_A_FIELD "
        "ROWS_A_LEVEL ROWS_A_MODE WARM_ROW_S WARM_TURNS WEAK_FIELD OTHER "
        "LARGEST_nT",
        "findings.working_range:SETTLED_S DIRECTIONS",
    ),
    "words for what is left, beside the verdict": (
        "empirical.description:POINTS GRID NEARLY_ALL SHORT LEVEL FLAT RETURNS OTHER_WAY",
        "findings.declaration:MOST_NAMED WORTH_NAMING",
        "findings.confounded:LOCKED_SHARE MOVING MOSTLY ONE_RATE", "findings.working_range:AXIAL",
        "findings.residual_shape:DOMINANT_SHARE MIN_EXPLAINED CONCENTRATION STEEP SMOOTH SWITCHES TWO_LEVELS "
        "SURROGATES ALTERNATIONS MOST_STEPS MEMORY DIFFERENT_FIELDS SLOPE_ROWS PART_ROWS EDGE LOW_BAND QUARTERS_deg "
        "LEAST_EXCESS",
    ),
}  # fmt: skip


def _listed() -> set[str]:
    lines = (line.split(":") for lines in KINDS.values() for line in lines)
    return {f"{module}:{name}" for module, names in lines for name in names.split()}


def _is_number(node: ast.AST) -> bool:
    return isinstance(node, ast.Constant) and isinstance(node.value, (int, float)) and not isinstance(node.value, bool)


def _modules() -> Iterator[tuple[str, ast.Module]]:
    for path in sorted(LOOP.rglob("*.py")):
        if path.name != "policy.py":
            yield ".".join(path.relative_to(LOOP).with_suffix("").parts), ast.parse(path.read_text())


def _constants(tree: ast.Module) -> Iterator[str]:
    """Names that a module gives to numbers, or to what is made of numbers."""
    for node in tree.body:
        if isinstance(node, (ast.Assign, ast.AnnAssign)) and node.value and any(map(_is_number, ast.walk(node.value))):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            yield from (n.id for target in targets for n in ast.walk(target) if isinstance(n, ast.Name))


def _numbers(node: ast.AST, *, in_words: bool = False, index: bool = False) -> Iterator[ast.Constant]:
    """Numbers below `node` with a meaning of their own: neither an `index` nor a unit within a sentence."""
    if isinstance(node, ast.Constant):
        known = (*SPELT_OUT, TURN_deg, *(UNITS_IN_SENTENCES if in_words else ()))
        if _is_number(node) and not index and node.value not in known and abs(node.value) > TOLERANCE:
            yield node
    elif isinstance(node, ast.Subscript):
        yield from _numbers(node.value, in_words=in_words)
        yield from _numbers(node.slice, in_words=in_words, index=True)
    else:
        index = index and isinstance(node, ast.Slice | ast.Tuple | ast.UnaryOp)
        in_words = in_words or isinstance(node, ast.FormattedValue)
        for part in ast.iter_child_nodes(node):
            yield from _numbers(part, in_words=in_words, index=index)


def _anonymous(tree: ast.Module) -> Iterator[ast.Constant]:
    """Numbers of a module that nothing names: in comparisons, arithmetic, calls, and as what holds by default."""
    for statement in tree.body:
        if not isinstance(statement, (ast.Assign, ast.AnnAssign)):
            yield from _numbers(statement)


def test_no_number_in_the_loop_is_a_judgement_outside_the_policy() -> None:
    found = {f"{module}:{name}" for module, tree in _modules() for name in _constants(tree)}
    assert found - _listed() == set(), (
        "a judgement goes into labcal/loop/policy.py; any other constant is listed above, by its kind"
    )
    assert _listed() - found == set(), "listed above, and there no more"


def test_no_number_stands_anonymously_in_a_function() -> None:
    found = {module: [(number.lineno, number.value) for number in _anonymous(tree)] for module, tree in _modules()}
    nameless = {module: numbers for module, numbers in found.items() if numbers}
    assert nameless == {}, (
        "give each (line, number) a name: a judgement of labcal/loop/policy.py, or a constant listed above"
    )


@pytest.mark.parametrize("source", ["A = 1.5", "A: float = 3.0", "A, B = 7, 8", "A = np.arange(5)"])
def test_a_new_constant_is_seen(source: str) -> None:
    assert list(_constants(ast.parse(source))) in (["A"], ["A", "B"])


@pytest.mark.parametrize(
    "source",
    ["x > 0.7", "x < 4 * y", "0.1 <= x", "f(x, 12) == y", "x > 1.15 * level.nT", "max(5 * correlation_s, step)",
     "max(x, 0.3)", "def f(x, level=1.5): ...", "def f(*, rows=24): ...", "y[: len(y) // 4]", "np.zeros((12, n))",
     "f'{x:.0f} of {7 * n}'", "x > 100", "class A:\n    rows: int = 60"],
)  # fmt: skip
def test_an_anonymous_number_is_seen(source: str) -> None:
    assert len(list(_anonymous(ast.parse(source)))) == 1


@pytest.mark.parametrize(
    "source", ["x[5]", "x[:, 3:7]", "x[-4]", "0.5 * x**2", "x > 1e-9", "f'{100 * x:.0f} %'", "np.mod(x, 360.0)"]
)
def test_what_says_no_more_than_words_or_a_unit_is_let_be(source: str) -> None:
    assert not list(_anonymous(ast.parse(source)))


def test_every_judgement_is_read_somewhere() -> None:
    text = "\n".join(path.read_text() for path in LOOP.rglob("*.py"))
    unread = {name for name in policy.judgements() if not re.search(rf"(law|POLICY|self)\.{name}\b", text)}
    assert unread == set(), "nothing in labcal/loop reads these judgements: take them out of the policy"


@pytest.mark.parametrize("name", policy.judgements())
def test_every_judgement_says_what_it_decides_and_names_a_test_that_is_there(name: str) -> None:
    stated = policy.judgements()[name]
    file, function = stated.test.split("::")
    there = f"def {function}(" in (ROOT / "tests" / file).read_text(encoding="utf-8")
    assert there, f"{name} names a test that is not there: write {function} in tests/{file}"
    assert stated.decides
    assert stated.why
    assert stated.source in ("derived", "cited", "measured")
    assert getattr(policy.POLICY, name) == stated.value


def test_the_policy_is_frozen_and_what_is_derived_follows() -> None:
    with pytest.raises(FrozenInstanceError):
        policy.POLICY.min_evidence = 1.0  # type: ignore[misc]
    assert policy.Policy(floor_ratio=1.25).min_white_level == 0.8
    assert policy.POLICY.max_misfit_of_a_line == pytest.approx(0.0994, abs=1e-4)
    assert policy.Policy(min_evidence=20.0).saturation_significance == pytest.approx(math.exp(-20.0))
    assert len(fields(policy.Policy)) == len(policy.judgements()), "a judgement is declared by `_judged`, no other way"


def test_there_are_twenty_five_judgements_at_most() -> None:
    assert len(policy.judgements()) <= 25, (
        "one more than 25: take out one that no answer hangs on, use one that says the same, or derive it from others "
        "as a property of Policy (CONTRIBUTING.md, Change the decision's rule)"
    )


def test_a_policy_put_in_its_place_is_the_one_that_is_used(monkeypatch: pytest.MonkeyPatch) -> None:
    residual, segment = np.zeros((60, 3)), np.zeros(60, dtype=np.intp)
    residual[30] = 7.0
    assert hampel_outliers(residual, segment).any()
    monkeypatch.setattr(policy, "POLICY", policy.Policy(outlier_sigmas=8.0))
    assert not hampel_outliers(residual, segment).any()


def test_judgements_of_another_policy_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    assert policy.moved() == {}
    monkeypatch.setattr(policy, "POLICY", policy.Policy(min_evidence=20.0, max_equivalents=2))
    assert policy.moved() == {"min_evidence": 20.0, "max_equivalents": 2}


def test_nobody_keeps_a_policy_of_his_own() -> None:
    kept = {p.name for p in LOOP.rglob("*.py") if re.search(r"import .*POLICY|^\w+ = .*POLICY", p.read_text(), re.M)}
    assert kept - {"policy.py"} == set()
