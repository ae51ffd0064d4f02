"""In a sentence for people a link goes by the name of its instrument, once."""

from __future__ import annotations

import pytest

from labcal.bench.named_links import named_links

LINKS = {"stage": "serial:///dev/ttyS1", "supply_x": "tcp://a:1", "supply_y": "pair", "supply_z": "pair"}


@pytest.mark.parametrize(
    ("text", "named"),
    [
        ("tcp://a:1: no reply.", "supply_x (tcp://a:1): no reply."),
        ("supply_x: tcp://a:1: no reply.", "supply_x (tcp://a:1): no reply."),
        ("pair: no reply.", "the line of supply_y, supply_z (pair): no reply."),
        ("address 1 on pair: no reply.", "address 1 on the line of supply_y, supply_z (pair): no reply."),
        (
            "open the output of supply_x (PL303 12 at tcp://a:1).",
            "open the output of supply_x (PL303 12 at tcp://a:1).",
        ),
        ("open the output of supply_y (RD6006 at pair).", "open the output of supply_y (RD6006 at pair)."),
        ("nothing of a line", "nothing of a line"),
    ],
)
def test_the_name_stands_before_the_link_unless_it_is_told_already(text: str, named: str) -> None:
    assert named_links(text, LINKS) == named
