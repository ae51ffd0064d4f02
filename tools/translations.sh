#!/usr/bin/env bash
# Brings every labcal/gui/translations/*.ts up to the words that stand in the window, and makes the .qm of each language.
set -euo pipefail
bin="${BIN:-.venv/bin}" folder=labcal/gui/translations
mapfile -t sources < <(find labcal/gui -name '*.py' | sort)
"$bin/pyside6-lupdate" "${sources[@]}" -locations none -no-obsolete -source-language en -ts "$folder"/labcal*.ts
# A window that is open has the .qm in its memory: one that is written anew in place would end it.
for one in "$folder"/labcal_*.ts; do
    "$bin/pyside6-lrelease" "$one" -qm "${one%.ts}.new" && mv "${one%.ts}.new" "${one%.ts}.qm"
done
