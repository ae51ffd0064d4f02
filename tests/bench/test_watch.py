"""Silence, a stuck sensor, a hot winding: each has its name and its remedy."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from labcal.bench.coils.windings import Windings
from labcal.bench.streams.watch import FieldLimit, RestPoll, StreamWatch, TemperatureLimit
from labcal.errors import InstrumentError, LimitError
from labcal.record.stream import Block


def reference(t: np.ndarray, values: np.ndarray) -> Block:
    return Block("reference", "ref", ("ref_x", "ref_y", "ref_z"), t, values)


def test_a_silent_stream_is_noticed_and_a_slow_one_is_not() -> None:
    watch = StreamWatch("ref", 3.0, 60.0, 0.0)
    watch.see([reference(np.array([1.0]), np.ones((1, 3)))], 3.9)
    with pytest.raises(InstrumentError) as caught:
        watch.see([], 4.1)
    assert caught.value.fault == "silent"


def sends(watch: StreamWatch, times: np.ndarray, left_s: float) -> None:
    """A reading at each of these times, seen at once."""
    for t in times:
        watch.see([reference(np.array([t]), np.full((1, 3), t))], float(t), left_s=left_s)


@pytest.mark.parametrize(("period_s", "missed_s"), [(1.0, 1.2), (None, 2.0)])
def test_one_that_sends_once_a_second_is_missed_by_its_own_rate_where_that_is_stated(
    period_s: float | None, missed_s: float
) -> None:
    watch = StreamWatch("ref", 3.0, 60.0, 0.0, period_s)
    sends(watch, np.arange(10.0), 0.5)
    watch.see([], 9.0 + missed_s - 0.01, left_s=0.5)
    with pytest.raises(InstrumentError, match="no sample"):
        watch.see([], 9.0 + missed_s + 0.01, left_s=0.5)


def test_one_that_is_slower_than_stated_is_missed_by_the_longest_of_its_pauses() -> None:
    watch = StreamWatch("ref", 3.0, 60.0, 0.0, 1.0)
    sends(watch, np.array([0.0, 1.0, 2.1]), 0.5)
    watch.see([], 3.39, left_s=0.5)  # 1.1 s was not too long before
    sends(watch, np.array([3.4, 4.9]), math.inf)
    watch.see([], 6.59, left_s=0.5)
    with pytest.raises(InstrumentError, match="no sample"):
        watch.see([], 6.61, left_s=0.5)


def test_one_whose_message_was_spoilt_is_there() -> None:
    watch = StreamWatch("ref", 3.0, 60.0, 0.0, 1.0)
    sends(watch, np.arange(10.0), 0.5)
    watch.see([], 10.0, left_s=0.5, spoilt=1)
    watch.see([], 11.1, left_s=0.5, spoilt=1)
    with pytest.raises(InstrumentError, match="no sample"):
        watch.see([], 11.3, left_s=0.5, spoilt=1)


def quiet_after(watch: StreamWatch, last_s: float) -> float:
    """Seconds from the last sample until it is said to be silent, while a person is asked."""
    for pause_s in np.arange(0.0, 60.0, 0.25).tolist():
        watch.see([], last_s + pause_s, waited_for=True)
        if watch.wrong("ref"):
            return pause_s
    return math.inf


def test_one_long_pause_does_not_hide_a_silence_for_ever() -> None:
    watch = StreamWatch("ref", 30.0, 60.0, 0.0)
    sends(watch, np.array([0.0, 0.1, 8.1, *np.arange(8.2, 40.0, 0.1)]), math.inf)
    assert 2.0 <= quiet_after(watch, 40.0) < 3.0


def test_what_kept_it_from_sending_is_no_pause_of_its_own() -> None:
    watch = StreamWatch("ref", 30.0, 60.0, 0.0)
    sends(watch, np.array([0.0, 0.1, 0.2]), math.inf)
    watch.see([], 9.0, wrong="link lost")
    sends(watch, np.array([9.1, 9.2]), math.inf)
    assert 2.0 <= quiet_after(watch, 9.2) < 3.0


def test_one_that_was_never_heard_is_said_to_be_silent_at_a_question() -> None:
    assert 3.0 < quiet_after(StreamWatch("ref", 3.0, 60.0, 0.0), 0.0) < 3.5


def test_a_stuck_stream_is_noticed_however_it_is_cut() -> None:
    t = np.arange(0, 90, 0.1)
    values = np.where(t[:, None] < 20, np.sin(t)[:, None], 0.5) * np.ones(3)
    for cuts in (1, 9, 300):
        watch, noticed = StreamWatch("ref", 3.0, 60.0, 0.0), None
        for part in np.array_split(np.arange(len(t)), cuts):
            try:
                watch.see([reference(t[part], values[part])], float(t[part[-1]]))
            except InstrumentError as error:
                noticed = error
                break
        assert noticed is not None
        assert noticed.fault == "stuck"
        assert t[part[-1]] > 80.0


def test_a_sensor_that_changes_now_and_then_is_not_stuck() -> None:
    t = np.arange(0, 300, 0.1)
    values = np.floor(t / 50)[:, None] * np.ones(3)
    StreamWatch("ref", 3.0, 60.0, 0.0).see([reference(t, values)], 300.0)


def test_a_winding_bears_its_rms_current_for_ever_and_twice_that_for_a_while() -> None:
    windings = Windings((1.0, 1.0, 1.0), 600.0)
    for t in range(7200):
        windings.see(np.array([0.999, 0.0, 0.0]), float(t))
    hot = Windings((1.0, 1.0, 1.0), 600.0)
    hot.refuse(np.array([0.0, 2.0, 0.0]))
    enough = 600 * np.log(4 / 3)
    for t in range(int(enough)):
        hot.see(np.array([0.0, 2.0, 0.0]), float(t))
    with pytest.raises(InstrumentError, match="coil y") as caught:
        hot.see(np.array([0.0, 2.0, 0.0]), enough + 1)
    assert caught.value.fault == "limit reached"
    with pytest.raises(LimitError, match="nothing was set"):
        hot.refuse(np.array([0.0, 2.0, 0.0]))
    hot.refuse(np.array([0.0, 0.5, 0.0]))


def housekeeping(t: list[float], *temperatures: float) -> Block:
    values = np.column_stack([np.full(len(t), 99.0), temperatures])
    return Block("channel", "dut", ("i_eps", "temp_dut"), np.array(t), values)


def test_a_dut_too_warm_is_a_limit_reached() -> None:
    limit = TemperatureLimit((-20.0, 60.0), ("temp_dut",), "wait.", 0.0)
    limit.see([housekeeping([1.0, 2.0], 59.0, np.nan)], 2.0)
    with pytest.raises(InstrumentError, match=r"temp_dut is 60\.5 degC.*60 degC") as caught:
        limit.see([housekeeping([3.0], 60.5)], 3.0)
    assert caught.value.fault == "limit reached"
    with pytest.raises(InstrumentError, match=r"temp_dut is -21 degC.*-20 degC"):
        limit.see([housekeeping([3.0], -21.0)], 3.0)


def test_a_temperature_that_has_a_limit_and_is_not_told_any_more_is_silent() -> None:
    limit = TemperatureLimit((-20.0, 60.0), ("temp_dut",), "wait.", 0.0)
    limit.see([housekeeping([50.0, 55.0], 20.0, np.nan)], 109.0)
    with pytest.raises(InstrumentError, match="temp_dut: no temperature for 61 s") as caught:
        limit.see([housekeeping([110.0], np.nan)], 111.0)
    assert caught.value.fault == "silent"


def test_a_field_seen_beyond_the_limit_is_a_limit_reached() -> None:
    limit = FieldLimit(100_000.0)
    limit.see([reference(np.array([1.0]), np.array([[0.0, 0.0, -104_900.0]]))], 48_000.0)
    with pytest.raises(InstrumentError, match=r"105100 nT is seen, the limit is 100000 nT") as caught:
        limit.see([reference(np.array([2.0]), np.array([[105_100.0, 0.0, 0.0]]))], 48_000.0)
    assert caught.value.fault == "limit reached"
    FieldLimit(20_000.0).see([reference(np.array([1.0]), np.array([[0.0, 0.0, -48_500.0]]))], 48_000.0)


def samples_until(end_s: float, period_s: float = 0.05) -> Block:
    t = np.arange(0.0, end_s, period_s)
    return Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), t, np.random.default_rng(0).normal(size=(len(t), 3)))


def test_a_silence_is_told_at_once_and_so_is_its_end() -> None:
    watch = StreamWatch("dut", 30.0, 120.0, 0.0)
    watch.see([samples_until(5.0)], 5.0)
    watch.see([], 6.5)
    assert (watch.news(), watch.wrong("dut")) == ([], "")
    watch.see([], 7.2)
    (event,) = watch.news()
    assert (event.kind, event.data["fault"], event.t_s) == ("stream", "silent", 7.2)
    assert (watch.wrong("dut"), watch.wrong("reference"), watch.news()) == ("silent", "", [])
    late = samples_until(5.0)
    watch.see([replace(late, t_s=late.t_s + 9.0)], 14.0)
    assert [event.data["fault"] for event in watch.news()] == ["heard again"]
    assert watch.wrong("dut") == ""
    with pytest.raises(InstrumentError, match="no sample for"):
        watch.see([], 45.0)


def test_while_something_else_is_known_to_keep_it_from_sending_it_is_not_called_silent() -> None:
    watch = StreamWatch("dut", 60.0, 120.0, 0.0)
    watch.see([samples_until(5.0)], 5.0)
    for now in np.arange(5.5, 12.0, 0.5).tolist():
        watch.see([], now, "link lost")
    watch.see([], 13.0)
    assert (watch.news(), watch.wrong("dut")) == ([], "")
    watch.see([], 14.0)  # it answers, and sends nothing
    (event,) = watch.news()
    assert event.text == "dut: no sample for 2.5 s"


def test_a_slow_stream_is_given_its_time() -> None:
    watch = StreamWatch("dut", 60.0, 120.0, 0.0)
    watch.see([samples_until(50.0, 10.0)], 50.0)
    watch.see([], 80.0)
    assert watch.news() == []
    watch.see([], 92.0)
    assert len(watch.news()) == 1


def test_what_rests_is_looked_at_every_second_and_its_loss_is_told_once() -> None:
    asked, faults = list[str](), [InstrumentError("reversers: gone.", fault="link lost")] * 2

    def ask(name: str) -> None:
        asked.append(name)
        if len(asked) > 1 and faults:
            raise faults.pop()

    look, told = RestPoll(["reversers"], ask), list[tuple[float, str]]()
    for t in np.arange(0.0, 9.0, 0.5).tolist():
        look.at(t)
        told += [(event.t_s, event.data["fault"]) for event in look.news()]
    assert len(asked) == 9
    assert told == [(1.0, "link lost"), (3.0, "heard again")]
    assert look.wrong("reversers") == ""


def test_another_instrument_in_its_place_is_refused() -> None:
    def another(name: str) -> None:
        raise InstrumentError("reversers: another.", fault="another instrument")

    with pytest.raises(InstrumentError, match="another"):
        RestPoll(["reversers"], another).at(0.0)


def test_what_is_gone_is_asked_until_it_answers_and_no_longer() -> None:
    asked = list[str]()
    look = RestPoll([], asked.append)
    look.gone("stage", InstrumentError("the link was lost.", fault="link lost"), 0.0)
    assert look.wrong("stage") == "link lost"
    for t in (0.0, 0.5, 2.0, 4.0):
        look.at(t)
    assert asked == ["stage"]
    assert [event.text for event in look.news()] == ["stage: the link was lost.", "stage: it answers again"]


def test_of_several_that_are_gone_one_is_waited_for_at_a_look_and_each_in_its_turn() -> None:
    """Three plugs out: who answers was read once every 4.5 s."""
    asked = list[str]()

    def ask(name: str) -> None:
        asked.append(name)
        if name != "contacts":
            raise InstrumentError(f"{name}: no reply.", fault="silent")

    look = RestPoll(["contacts"], ask)
    for name in ("x", "y", "z"):
        look.gone(name, InstrumentError(f"{name}: no reply.", fault="silent"), 0.0)
    for t in (0.0, 1.0, 2.0, 3.0):
        asked.append(f"at {t:.0f}")
        look.at(t)
    looks = " ".join(asked).split("at ")[1:]
    assert [one.split()[1:] for one in looks] == [["contacts", name] for name in ("x", "y", "z", "x")]


def test_nothing_is_missed_while_it_is_waited_for_and_patience_begins_anew() -> None:
    watch, hot = StreamWatch("dut", 3.0, 60.0, 0.0), TemperatureLimit((-20.0, 60.0), ("temp",), "", 0.0)
    for t in np.arange(0.0, 100.0, 0.5).tolist():
        watch.see([], t, waited_for=True)
        hot.see([], t, waited_for=True)
    watch.see([], 102.0)
    hot.see([], 102.0)
    with pytest.raises(InstrumentError, match="no sample for 103"):
        watch.see([], 103.0)
    with pytest.raises(InstrumentError, match="no temperature for 61 s"):
        hot.see([], 99.5 + 61.0)
