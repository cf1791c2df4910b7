#!/usr/bin/env bash
# Installs the project's build tree into a folder of its own and builds a program against it, once by its CMake package
# and once by pkg-config. No library but the engine's may be needed.
#   slab.sh BUILD SOURCE
set -euo pipefail
build=$1
source=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build" --prefix "$work/installed" > "$work/install.log"
for file in bin/runout share/man/man1/runout.1 include/runout/engine/simulation.h include/runout/core/vec2.h; do
    [[ -s "$work/installed/$file" ]] || { echo "not installed: $file" >&2; exit 1; }
done
"$work/installed/bin/runout" --version

cmake -S "$source/slab" -B "$work/slab" -D CMAKE_BUILD_TYPE=Release -D CMAKE_PREFIX_PATH="$work/installed" > "$work/slab.log"
cmake --build "$work/slab" --verbose > "$work/build.log" || { cat "$work/build.log" >&2; exit 1; }
if grep -Ei 'gdal|cgal|toml|sqlite' "$work/build.log"; then
    echo "a library that the engine does not need is on the line" >&2
    exit 1
fi
"$work/slab/slab"

command -v pkg-config > /dev/null || exit 0
export PKG_CONFIG_PATH
PKG_CONFIG_PATH=$(dirname "$(find "$work/installed" -name runout.pc)")
# shellcheck disable=SC2046  # the flags are words
"${CXX:-c++}" -O2 "$source/slab/slab.cpp" $(pkg-config --cflags --libs runout) -o "$work/by_pkg_config"
"$work/by_pkg_config"
