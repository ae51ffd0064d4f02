"""A bundle that is spoilt anywhere is read or refused in words; nothing worse happens."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from labcal.errors import InputError
from labcal.store import Bundle

GOLDEN = Path(__file__).parents[1] / "golden"


@settings(max_examples=100, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(data=st.data())
def test_spoilt_rows_are_read_or_refused_never_worse(data: st.DataObject, sample_rows: str) -> None:
    rows = bytearray(sample_rows.encode())
    for _ in range(data.draw(st.integers(1, 4))):
        place = data.draw(st.integers(0, len(rows)))
        rows[place : place + data.draw(st.integers(0, 5))] = data.draw(
            st.one_of(st.binary(max_size=4), st.sampled_from([b",", b"\n", b'"', b"nan", b"\r", b"-", b"e9", b"x"]))
        )
    header = (GOLDEN / "bundle-small.json").read_bytes()
    try:
        run = Bundle(header, bytes(rows)).run()
    except InputError:
        return
    assert np.all(np.diff(run.t_s) > 0)


json_values = st.recursive(
    st.none() | st.booleans() | st.floats() | st.integers() | st.text(max_size=5) | st.just("rotation"),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=5), inner, max_size=4),
    max_leaves=10,
)


@settings(max_examples=100, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(data=st.data())
def test_spoilt_headers_are_read_or_refused_never_worse(data: st.DataObject, sample_rows: str) -> None:
    header = json.loads((GOLDEN / "bundle-small.json").read_text())
    spot: Any = header
    while True:
        keys = list(spot) if isinstance(spot, dict) else list(range(len(spot)))
        key = data.draw(st.sampled_from(keys))
        if not isinstance(spot[key], dict | list) or not spot[key] or data.draw(st.booleans()):
            break
        spot = spot[key]
    spot[key] = data.draw(json_values)
    try:
        Bundle(json.dumps(header).encode(), sample_rows.encode()).run()
    except InputError:
        return
