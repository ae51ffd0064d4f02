"""A doubt about a zero on a bench with real lines: no session energises over it; it is measured again and lifted."""

from __future__ import annotations

import json

import pytest
from served_lab import Served, beginning, until

from labcal import session
from labcal.bench import open_bench
from labcal.bench.coils.doubt import Doubt, StoredDoubt
from labcal.bench.coils.state import AT_ZERO
from labcal.bench.config import read_config
from labcal.bench.look_again import look_again
from labcal.cli import main
from labcal.errors import InstrumentError, Stopped
from labcal.record.stream import Event, Item, Prompt
from labcal.runner.prompts import first_choice

AMBIENT = (20_400.0, 1_150.0, -43_700.0)
ELSEWHERE = (20_400.0, 1_150.0, 40_000.0)


def doubted(lab: Served, ambient: tuple[float, float, float]) -> StoredDoubt:
    latch = StoredDoubt(read_config(lab.file).guarded_links)
    latch.set(Doubt("2026-01-01 00:00 UTC", "it sees 99 µT too much", (0.0, 0.0, 0.0), ambient))
    return latch


def test_no_session_energises_over_a_doubt_and_one_that_agrees_again_lifts_it(lab: Served) -> None:
    doubted(lab, AMBIENT)
    refused = beginning(lab)
    assert "NOT at zero by the reference, at 2026-01-01" in refused.stderr
    assert max(lab.currents().values()) < 0.005
    until(lambda: (looked := look_again(lab.file)) is not None and looked.lifted)
    assert StoredDoubt(read_config(lab.file).guarded_links).doubt is None
    assert look_again(lab.file) is None


def test_what_still_disagrees_is_lifted_by_name_alone(
    lab: Served, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    latch = doubted(lab, ELSEWHERE)
    for words, code, says in (
        ([], 3, "NOT at zero by the reference: it sees 20"),
        ([], 3, "First seen 2026-01-01 00:00 UTC, it sees 99"),
        (["--clear-as", "Ada Obi"], 0, "Ada Obi answers for it: the coils may be energised again."),
        (["--clear-as", "Ada Obi"], 0, "there is nothing to clear"),
    ):
        monkeypatch.setattr("sys.argv", ["labcal", "bench", "check", str(lab.file), *words])
        with pytest.raises(SystemExit) as ended:
            main()
        said = " ".join(capsys.readouterr().out.split())
        assert ended.value.code == code, said
        assert says in said
    kept = json.loads(latch._paths[0].read_text())
    assert kept["lifted"].startswith("Ada Obi answers for it, ")
    assert "the reference sees 20" in kept["lifted"]
    assert "coil x zero, open" in kept["lifted"]


def test_a_run_measures_a_doubt_before_any_question_and_goes_on_where_it_is_a_zero(lab: Served) -> None:
    asked, said = list[str](), list[str]()

    def answer(prompt: Prompt) -> str:
        asked.append(prompt.key)
        raise Stopped("enough")

    def tell(item: Item) -> None:
        said.append(getattr(item, "kind", ""))

    doubted(lab, ELSEWHERE)
    with pytest.raises(InstrumentError, match="NOT at zero by the reference: it sees 20") as caught:
        session.run("field-hold", lab.file, {"duration_s": "10"}, answer=answer, operator="x", on_item=tell)
    assert asked == []
    assert "2026-01-01" not in caught.value.what  # what was seen then is no word of now
    assert "2026-01-01" in caught.value.mends
    doubted(lab, AMBIENT)
    outcome = session.run("field-hold", lab.file, {"duration_s": "10"}, answer=answer, operator="x", on_item=tell)
    assert asked
    assert outcome.status == "stopped"
    assert StoredDoubt(read_config(lab.file).guarded_links).doubt is None


def test_a_silent_supply_is_named_and_not_a_reference_that_sees_the_zero(lab: Served) -> None:
    doubted(lab, AMBIENT)
    mute = lab.emulator("supply_y")
    mute.emit = lambda until_s: []
    try:
        looked = look_again(lab.file)
    finally:
        vars(mute).pop("emit", None)
    assert looked is not None
    assert not looked.lifted
    assert looked.words.startswith("coils NOT confirmed at zero: coil y: ")


@pytest.mark.slow
def test_an_honest_bench_on_real_lines_ends_with_a_zero_that_was_seen(lab: Served) -> None:
    said = list[str]()

    def tell(item: Item) -> None:
        if isinstance(item, Event) and item.kind in ("read-back", "stream"):
            said.append(item.text)

    outcome = session.run("field-hold", lab.file, {"duration_s": "10"}, answer=first_choice, operator="x", on_item=tell)
    assert outcome.status == "finished", outcome.status
    assert outcome.lab is not None
    assert outcome.lab.guardian is True
    assert said[-1] == AT_ZERO
    assert not [text for text in said if "NOT" in text]
    assert outcome.lab.reference.verdict == "agrees"
    assert all(one.heard_s is not None and not one.fault for one in outcome.lab.instruments), outcome.lab.instruments


@pytest.mark.slow
def test_contacts_that_are_pulled_at_rest_are_told_within_seconds(lab: Served) -> None:
    with open_bench(lab.file) as bench:
        bench.start()
        bench.stream_until(bench.clock.now() + 3.0)
        assert bench.news() == []
        lab.emulator("reversers").take = lambda *_: None  # hears nothing any more
        begun, told = bench.clock.now(), list[Event]()
        while not told:
            bench.stream_until(bench.clock.now() + 0.5)
            told = [event for event in bench.news() if event.text.startswith("reversers")]
            assert bench.clock.now() - begun < 60.0
        assert told[0].kind == "stream"
        assert next(one for one in bench.state().instruments if one.name == "reversers").fault
