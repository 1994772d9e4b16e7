#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the planescope authors
# SPDX-License-Identifier: BSD-3-Clause
# The long tests, which tests/run.sh leaves out: many runs in one process, many in child processes, many kills.
# soak.sh [RUNS] [KILLS]; about a quarter of an hour by default. Prints the figures.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
runs=${1:-300} kills=${2:-200}
build=build/release program=$PWD/build/release/src/cli/planescope
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --preset release >/dev/null
cmake --build --preset release --target planescope planescope_soak osmesa_stub >&2

echo "== $runs segmentations and pictures in one process"
"$build/tests/soak/planescope_soak" "$runs" "$work/soak.png"

echo "== $runs scenes by batch, a process each"
mkdir "$work/scenes"
for ((seed = 1; seed <= runs; ++seed)); do
  "$program" synthesize -o "$work/scenes/$seed.ply" --points $((10000 + 5000 * (seed % 5))) --random-seed "$seed" -q
done
"$program" batch "$work/scenes/*.ply" -o "$work/batch" --methods ours --pictures --jobs 2 >"$work/table.md"
head -n 3 "$work/table.md"
[[ $(find "$work/batch" -name overview.png | wc -l) == "$runs" && -z $(find "$work/batch" -name '.*' -mindepth 1) ]]

bash tests/cli/setup.sh "$program" "$work/shared"
for fault in killed signalled together; do
  echo "== $fault, $kills times"
  bash tests/cli/faults.sh "$program" "$work/shared" "$work" "$build/tests/cli/libosmesa_stub.so" "$fault" "$kills"
done
echo "== all of it held"
