#!/usr/bin/env bash
# Every check, quiet ones first: style, types, who may know whom, then the tests. `make test` calls it.
set -euo pipefail
BIN=${BIN:-.venv/bin}
unset PYTHONDONTWRITEBYTECODE  # the tests start some thousand processes: each would compile labcal anew
export QT_QPA_PLATFORM=${QT_QPA_PLATFORM:-offscreen} OPENBLAS_NUM_THREADS=1
QT_LIBRARIES=$("$BIN/python" -m labcal.system.qt_packages)

if ! "$BIN/python" -c "import PySide6.QtWidgets" 2>/dev/null; then
    if [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
        echo "Installing the system libraries that the window needs: $QT_LIBRARIES"
        apt-get update -qq >/dev/null && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq $QT_LIBRARIES >/dev/null
    else
        echo "The window's tests will be skipped: install its system libraries with 'sudo apt-get install $QT_LIBRARIES'." >&2
    fi
fi

# README names Debian 12's packages; elsewhere they may be called otherwise.
if grep -qs '^VERSION_CODENAME=bookworm' /etc/os-release && command -v dpkg-query >/dev/null && command -v readelf >/dev/null; then
    "$BIN/python" tools/qt_libraries.py --check
fi
if ! command -v initdb >/dev/null && ! compgen -G "/usr/lib/postgresql/*/bin/initdb" >/dev/null; then
    if [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
        echo "Installing the PostgreSQL that the archive's tests start: postgresql"
        { apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends postgresql; } >/dev/null ||
            echo "It could not be installed: the archive's tests will be skipped." >&2
    else
        echo "The archive's tests will be skipped: install its server with 'sudo apt-get install postgresql'." >&2
    fi
fi

"$BIN/ruff" check .
"$BIN/ruff" format --check --quiet .
"$BIN/lint-imports" --no-cache
"$BIN/mypy" --num-workers 2

# Three processes share the tests, whole files each, where there are two cores or more; `PROCESSES=1 make test`: one.
# A process waits a quarter of its time for a line or a guardian: two would leave two cores idle.
SHARED=$(PROCESSES=${PROCESSES:-} "$BIN/python" -c 'from importlib.util import find_spec; import os
processes = int(os.environ["PROCESSES"] or (3 if (os.cpu_count() or 1) > 1 else 1))
print(f"-n {processes} --dist loadfile --no-loadscope-reorder --max-worker-restart 0" if processes > 1 and find_spec("xdist") else "")')
# A test that hangs is named and ends its process after ten minutes (the longest takes one). A process that ends ends
# the whole: one started in its place may wait for ever for the files that it was to take over (pytest-xdist 3.8).
# shellcheck disable=SC2086  # several words
exec "$BIN/pytest" $SHARED -m "not slow" --timeout 600 --timeout-method thread "$@"
