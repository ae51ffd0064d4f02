"""What a push costs the server grows with what is new, not with the square of what is there."""

from __future__ import annotations

from conftest import rows_of
from made_up import Years, fill
from postgres import Server

from labcal.archive.push import known
from labcal.session.opened_archive import opened

RUNS = 3000  # each compared with each: 9 million, some seconds of the server
AT_MOST_S = 0.5


def test_what_is_known_is_asked_before_the_server_has_counted_its_rows(
    postgres: Server, database: str, url: str
) -> None:
    fill(postgres, database, Years(20, 50))  # it has counted these, and not what comes now
    with postgres.connect(database) as connection:
        columns = "site, sha256, run_id, started_utc, status, simulated, dut_serial, dut_model, dut_unit, operator, "
        columns += "procedure, reference_kind, reference_serial, n_samples, bundle_sha256, bundle_bytes"
        values = "'vm', n, n, now(), 'finished', true, '', '', '', '', '', '', '', 1, '', 1"
        made = f"FROM (SELECT lpad(i::text, 64, '0') AS n FROM generate_series(1, {RUNS}) AS i) AS made"
        connection.execute(f"INSERT INTO labcal.run ({columns}) SELECT {values} {made}")
        connection.execute(f"INSERT INTO labcal.kept_head SELECT 'vm', 'head of ' || n, n {made}")
        connection.execute("INSERT INTO labcal.kept_head VALUES ('vm', 'of no run', 'gone')")
    begun = postgres.busy_s()
    with opened(url) as archive:
        found = known(archive, "vm")
    assert postgres.busy_s() - begun < AT_MOST_S
    assert len(found.heads) == RUNS
    assert "of no run" not in found.heads
    assert len(rows_of(postgres, database)["kept_head"]) == RUNS + 1
