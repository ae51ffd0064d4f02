"""The judgements of the loop: every threshold that a verdict, a name or a finding hangs on, and where it comes from.

A judgement is a number that somebody could choose otherwise with good reason and get another answer from the same
data. What is none stays where it is used and is listed by kind in `tests/loop/test_policy.py`: tolerances of
arithmetic, grids and budgets of a search, sizes of samples, settings of an estimator.

`make sensitivity` moves each by 30 % and counts the answers that change.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, fields
from typing import Any, Literal

Source = Literal["derived", "cited", "measured"]


@dataclass(frozen=True, slots=True)
class Judgement:
    """One threshold: its value and unit, what it decides, where it comes from, and the test that holds it."""

    value: float
    unit: str
    decides: str
    source: Source
    why: str
    test: str  # file::function below tests/
    about: float = 0.0  # the value at which it would decide nothing: 1 for a ratio to something else


def _judged(value: float, unit: str, decides: str, source: Source, why: str, test: str, about: float = 0.0) -> Any:
    return field(default=value, metadata={"judgement": Judgement(value, unit, decides, source, why, test, about)})


@dataclass(frozen=True)
class Policy:
    """All judgements as plain numbers; `judgements` tells of each what stands beside it."""

    # evidence: may a candidate be named at all?
    min_evidence: float = _judged(
        12.0, "nats",
        "a cause with less is not named",
        "measured", "odds of 1.6e5 to one; coloured noise beside twenty smooth channels stays below",
        "loop/test_judgements.py::test_a_cause_with_less_than_twelve_nats_is_not_named",
    )  # fmt: skip
    material_share: float = _judged(
        0.03, "of a mean square",
        "a smaller part, of the noise's or of what effects explain, is a detail",
        "derived", "1.5 % of an rms: no noise is declared more closely",
        "loop/test_decision.py::test_what_leaves_more_than_its_share_is_no_drift",
    )  # fmt: skip
    clear_share: float = _judged(
        0.25, "of the noise's mean square",
        "a second cause that takes off as much is no detail, however strong the first",
        "derived", "half the noise's amplitude, the weakest effect that blind runs hold",
        "loop/test_decision.py::test_a_second_effect_brings_a_quarter_of_the_noises_square_at_least",
    )  # fmt: skip
    min_share_of_excess: float = _judged(
        0.08, "of what is above the noise",
        "the least that a second cause takes off, beside all forms of the first",
        "measured", "blind runs with two causes",
        "loop/test_judgements.py::test_a_second_cause_takes_a_twelfth_of_what_is_left",
    )  # fmt: skip

    # held-out data: does the selection stand?
    floor_ratio: float = _judged(
        1.15, "of the noise floor's rms", "an rms up to here reaches the noise, and a base needs no larger one",
        "cited", "the contract's verdict `clean`",
        "loop/test_judgements.py::test_up_to_1_15_of_the_floor_nothing_is_left", about=1.0,
    )  # fmt: skip
    min_explained: float = _judged(
        0.75, "of the excess over the noise",
        "effects that explain less together are not named",
        "measured", "strange blind runs, of which a curve or a drift takes a part",
        "loop/test_judgements.py::test_effects_together_take_most_of_the_excess",
    )  # fmt: skip
    min_explained_by_switches: float = _judged(
        0.5, "of the excess over the noise",
        "the same where all effects follow channels that somebody switches",
        "derived", "most of it: no unnamed process resembles a switched load",
        "loop/test_judgements.py::test_effects_together_take_most_of_the_excess",
    )  # fmt: skip
    max_misfit_of_later: float = _judged(
        1 / 3, "of what it took off",
        "a later cause that leaves more took misfit of an earlier one's form",
        "measured", "blind runs whose strong cause has a form that the library lacks",
        "loop/test_decision.py::test_a_later_cause_that_leaves_a_third_of_what_it_took_is_misfit_of_the_first",
    )  # fmt: skip

    max_share_of_field: float = _judged(
        0.5, "of the field",
        "an effect that follows the reference and is larger, or would have to be to take the residual off, is none",
        "derived", "no iron, tilt or gradient of a lab makes half of the field that drives it",
        "loop/test_final_fit.py::test_an_effect_that_undoes_one_direction_of_the_field_is_no_effect",
    )  # fmt: skip

    # equivalent models
    equivalent_nats: float = _judged(
        8.0, "nats",
        "a cause that lacks less is equivalent",
        "derived", "odds of 3000 to one: less is no lead among thousands of forms",
        "loop/test_judgements.py::test_a_cause_within_eight_nats_is_as_likely",
    )  # fmt: skip
    equivalent_rms: float = _judged(
        1.03, "of the better one's rms",
        "models, and faults of the data, that leave no more are equivalent",
        "derived", "no use of a calibration hangs on 3 % of its error",
        "loop/test_judgements.py::test_a_held_out_error_within_3_per_cent_is_as_good", about=1.0,
    )  # fmt: skip
    max_equivalents: int = _judged(
        3, "models",
        "an effect with more that misses the noise is not named",
        "derived", "whatever resembles an unknown shape a little is among more",
        "loop/test_decision.py::test_where_the_noise_is_missed_a_name_that_most_others_could_take_is_not_told",
    )  # fmt: skip

    # rows, base and noise
    outlier_sigmas: float = _judged(
        6.0, "robust standard deviations", "a row farther from its neighbours is an outlier", "derived",
        "Hampel's identifier; chance gives one in 5e8 normal rows",
        "loop/test_judgements.py::test_a_row_six_deviations_from_its_neighbours_is_an_outlier",
    )  # fmt: skip
    gross_outlier_sigmas: float = _judged(
        10.0, "standard deviations",
        "rows set aside that lie nearer are not named as a cause",
        "derived", "nearer rows may be a detail that an effect's form lacks",
        "loop/test_judgements.py::test_rows_set_aside_within_ten_deviations_are_no_cause",
    )  # fmt: skip
    min_set_aside: int = _judged(
        3, "rows", "fewer rows set aside are not named as a cause", "derived", "two may be one event of the recording",
        "loop/test_judgements.py::test_three_gross_rows_set_aside_are_a_cause",
    )  # fmt: skip
    max_outlier_share: float = _judged(
        0.05, "of the rows", "a run with more outliers is never `explained`", "cited", "the contract",
        "loop/test_judgements.py::test_a_run_with_more_than_5_per_cent_outliers_is_never_explained",
    )  # fmt: skip
    min_white_level_measured: float = _judged(
        0.5, "of the measured noise",
        "the white noise is taken to be no smaller, where none is declared",
        "derived", "what is measured at rest or from row to row holds more than white noise",
        "loop/test_judgements.py::test_white_noise_is_half_of_what_was_measured_at_least",
    )  # fmt: skip
    max_noise_ratio: float = _judged(
        1.3, "of the declared noise", "measured noise that differs by more is a finding", "cited", "the contract",
        "loop/test_judgements.py::test_noise_that_differs_by_a_factor_of_1_3_is_a_finding", about=1.0,
    )  # fmt: skip
    still_share: float = _judged(
        0.002, "of the field",
        "a stretch whose field spreads less stands still, and shows the noise",
        "derived", "100 nT in 50 µT: more than noise, less than a step of the field",
        "loop/test_judgements.py::test_a_field_that_spreads_by_two_per_mille_stands_still",
    )  # fmt: skip
    significance: float = _judged(
        0.01, "", "a residual without structure fails a test this often, and chance piles readings up", "cited",
        "convention (Ljung 16.6)",
        "loop/test_judgements.py::test_errors_as_declared_are_called_larger_in_one_run_of_a_hundred",
    )  # fmt: skip

    # data checks
    max_field_uncertainty: float = _judged(
        0.02, "of the field",
        "a base this uncertain is not determined; one that misses less is not checked",
        "derived", "a tenth of what is incoherent",
        "loop/test_judgements.py::test_a_map_of_two_per_cent_of_the_field_is_not_determined",
    )  # fmt: skip
    gross_factor: float = _judged(
        5.0, "times",
        "a misfit of so many noise floors is gross, a fault explains it that leaves a fifth, a fifth of the "
        "field is incoherent, a gain below a fifth of the largest is no axis",
        "derived", "more than any effect of a sensor leaves",
        "loop/test_judgements.py::test_a_fifth_of_the_field_is_gross",
    )  # fmt: skip
    unit_factor: float = _judged(
        100.0, "times",
        "readings so far from the field are in another unit",
        "derived", "G, mG, µT and nT lie at least as far apart",
        "loop/test_judgements.py::test_readings_a_hundred_times_off_are_in_another_unit",
    )  # fmt: skip

    # what repeats
    min_cycles: float = _judged(
        3.0, "periods",
        "fewer of them in the run, or in a segment that they keep step with, are a drift",
        "derived", "fewer are like the curve of a drift",
        "loop/test_judgements.py::test_three_periods_are_a_line",
    )  # fmt: skip
    phase_locked: float = _judged(
        0.7, "resultant length",
        "a line with such phases at the starts of segments keeps step with them",
        "derived", "a turn there and back repeats at twice its rate",
        "loop/test_judgements.py::test_a_line_that_segments_begin_alike_with_is_their_own_motion",
    )  # fmt: skip

    @property
    def min_white_level(self) -> float:
        """The white noise is taken to be no smaller, of the declared one: as far below as the floor may be missed."""
        return 1 / self.floor_ratio

    @property
    def max_misfit_of_a_line(self) -> float:
        """Of what it took off, what a line with its harmonics may leave: a square wave's share beyond its third."""
        return 1 - 8 / math.pi**2 * (1 + 1 / 9)

    @property
    def saturation_significance(self) -> float:
        """The chance of a pile-up of readings below which the device saturates: the odds that a name needs."""
        chance: float = math.e**-self.min_evidence
        return chance


def judgements() -> dict[str, Judgement]:
    """Every judgement by its name."""
    return {f.name: f.metadata["judgement"] for f in fields(Policy)}


POLICY = Policy()


def moved() -> dict[str, float]:
    """The judgements that somebody's own policy in the place of POLICY has otherwise, with their values there."""
    return {name: value for name, stated in judgements().items() if (value := getattr(POLICY, name)) != stated.value}
