#!/bin/sh
# Installs labcal from this folder for this user, without a network and without root. See install.py --help.
set -eu
here=$(CDPATH= cd -- "$(dirname -- "$0")" && pwd)
(cd "$here" && sha256sum --check --quiet --strict SHA256SUMS) ||
    { echo "install: this folder is not as it was packed: nothing was installed" >&2; exit 1; }
wanted=$(sed -n 's/.*"python": *"\([0-9.]*\)".*/\1/p' "$here/bundle.json")
for python in "${PYTHON:-}" "python$wanted" python3; do
    if [ -n "$python" ] && command -v "$python" >/dev/null &&
        [ "$("$python" -c 'import sys; print("%d.%d" % sys.version_info[:2])')" = "$wanted" ]; then
        exec "$python" -B "$here/install.py" "$@"
    fi
done
echo "install: Python $wanted is needed and not here; on Debian: apt-get install python3, or PYTHON=/path/to/python" >&2
exit 1
