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
