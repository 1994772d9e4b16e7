#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the planescope authors
# SPDX-License-Identifier: BSD-3-Clause
# What the cases share: setup.sh PROGRAM SHARED makes a small room with truth, its result, and another cloud.
set -euo pipefail
program=$1 shared=$2
rm -rf "$shared"
mkdir -p "$shared"
"$program" synthesize -o "$shared/room.ply" --points 40000 --random-seed 5 -q
"$program" synthesize -o "$shared/other.ply" --points 1000 -q
"$program" segment "$shared/room.ply" -o "$shared/result" --no-pictures -q

# A level plane of 1 x 1 m, and a cloud that is in millimetres: 3 x 3 m as 3000 x 3000.
plane() { # NAME SIZE
  awk -v size="$2" 'BEGIN {
    printf "ply\nformat ascii 1.0\nelement vertex 10000\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
    for (i = 0; i < 100; ++i) for (j = 0; j < 100; ++j) print i * size / 100, j * size / 100, (i * 7 + j * 3) % 5 * size / 5000
  }' >"$shared/$1.ply"
}
plane plane 1
plane millimetres 3000
# A scanner's sentinel among the points.
sed 's/vertex 10000/vertex 10001/' "$shared/plane.ply" >"$shared/stray.ply"
echo '1e9 0 -1e9' >>"$shared/stray.ply"
