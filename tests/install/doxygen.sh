#!/usr/bin/env bash
# The public headers of the engine as pages, without a warning: all that they declare is documented.
#
#   doxygen.sh SOURCE_FOLDER [FOLDER]     pages into FOLDER/html, or nowhere; ends with 77 (skipped) without doxygen
set -euo pipefail
cd "$1"

command -v doxygen > /dev/null || {
    echo "skipped: doxygen is not installed (Debian: doxygen)"
    exit 77
}
if (($# > 1)); then
    folder=$2
    mkdir -p "$folder"
else
    folder=$(mktemp -d)
    trap 'rm -rf "$folder"' EXIT
fi
{
    cat docs/Doxyfile
    printf 'OUTPUT_DIRECTORY = "%s"\n' "$folder"
} | doxygen -
[[ -f $folder/html/classrunout_1_1Simulation.html ]]
