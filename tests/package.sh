#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the planescope authors
# SPDX-License-Identifier: BSD-3-Clause
# Installs planescope, builds the consumer project against it, and runs what came out: package.sh BUILD_DIR SOURCE_DIR
set -euo pipefail
build=$1 source=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build" --prefix "$work/prefix" >"$work/log"
compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$build/CMakeCache.txt")
flags=$(sed -n 's/^CMAKE_CXX_FLAGS:[A-Z]*=//p' "$build/CMakeCache.txt")
# The sources are copied, so that nothing but the installed package can be found.
cp -r "$source/examples" "$work/examples"
cmake -S "$work/examples/consumer" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_CXX_FLAGS="$flags" -DCMAKE_PREFIX_PATH="$work/prefix" >>"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
cmake --build "$work/build" 2>&1 | tail -n 20

"$work/build/segment_room" | tee "$work/out"
grep -q '^plane ' "$work/out"
grep -q '^segment   1 ' "$work/out"
# Not grep -q: it closes the pipe at the first match, and the program would end by SIGPIPE.
"$work/build/explain_edges" | grep '^same_plane' >/dev/null
"$work/build/track_walk" | grep '^frame [0-9]*: new 1$' >/dev/null
if [[ -x $work/prefix/bin/planescope ]]; then  # drawing was built: it is in the package too
  "$work/build/draw_room" "$work/room.png"
  [[ -s $work/room.png ]]
  "$work/prefix/bin/planescope" --version
  "$work/prefix/bin/planescope" synthesize -o "$work/room.ply" --points 40000 -q
  "$work/build/vtk_filter" "$work/room.ply" "$work/off.vtp" | tee "$work/out"
  grep -q 'planes, .* edges, .* of them OFF' "$work/out"
  [[ -s $work/off.vtp ]]
fi
