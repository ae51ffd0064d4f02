#!/usr/bin/env bash
# Every check, quiet ones first: style, types, who may know whom, then the tests. `make test` calls it.
set -euo pipefail
BIN=${BIN:-.venv/bin}
export QT_QPA_PLATFORM=${QT_QPA_PLATFORM:-offscreen} OPENBLAS_NUM_THREADS=1
QT_LIBRARIES="libglib2.0-0 libgl1 libegl1 libfontconfig1 libxkbcommon0 libdbus-1-3"

if ! "$BIN/python" -c "import PySide6.QtWidgets" 2>/dev/null; then
    if [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
        echo "Installing the system libraries that the window needs: $QT_LIBRARIES"
        apt-get update -qq >/dev/null && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq $QT_LIBRARIES >/dev/null
    else
        echo "The window's tests will be skipped: install its system libraries with 'sudo apt-get install $QT_LIBRARIES'." >&2
    fi
fi

"$BIN/ruff" check .
"$BIN/ruff" format --check --quiet .
"$BIN/mypy"
"$BIN/lint-imports" --no-cache
exec "$BIN/pytest" -m "not slow" "$@"
