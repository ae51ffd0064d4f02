"""What other people's programs are run with: the served benches, and the table of what was shown.

Files whose packages are not installed are left out, so that `make test` runs those it can; `make clients` leaves out
none.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from importlib.util import find_spec
from pathlib import Path

import pytest
from met import NEEDS, Check, told, write
from served_benches import Lab, Line

WHOLE = "LABCAL_CLIENTS"  # in the environment: no file is left out, and the table is printed; a page to write it into
collect_ignore = [
    file for file, packages in NEEDS.items() if WHOLE not in os.environ and not all(map(find_spec, packages))
]
checks: dict[str, Check] = {}
passed: set[str] = set()


@pytest.fixture(scope="session")
def lab(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Lab]:
    """Every bench, served."""
    served = Lab(tmp_path_factory.mktemp("benches"))
    yield served
    served.close()


@pytest.fixture
def line(lab: Lab, request: pytest.FixtureRequest) -> Line:
    """Of the instrument that the check meets."""
    return lab.line(checks[request.node.nodeid].instrument)


@pytest.fixture
def line_of(lab: Lab) -> Callable[[str], Line]:
    """Of any instrument."""
    return lab.line


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Each check states what it meets."""
    for item in items:
        if item.path.parent == Path(__file__).parent and (mark := item.get_closest_marker("met")):
            checks[item.nodeid] = Check(*mark.args, **mark.kwargs)


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    """Remember what passed."""
    if report.when == "call" and report.passed and report.nodeid in checks:
        passed.add(report.nodeid)


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """The table, where every check was asked for."""
    if WHOLE not in os.environ:
        return
    terminalreporter.section("met by other people's programs")
    for line in told([checks[node] for node in checks if node in passed]):
        terminalreporter.write_line(line)
    terminalreporter.write_line(f"{len(passed)} of {len(checks)} checks passed")
    if os.environ[WHOLE].endswith(".md") and len(passed) == len(checks):
        write(Path(os.environ[WHOLE]), [checks[node] for node in sorted(passed)])
