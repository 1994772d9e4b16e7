#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the planescope authors
# SPDX-License-Identifier: BSD-3-Clause
# From a fresh Debian 12 to pictures: installs what is missing, builds planescope, makes a furnished room with ground truth,
# segments and draws it, and scores the result.   bash examples/quickstart.sh [OUTDIR]
set -euo pipefail
out=$(realpath -m "${1:-out/quickstart}")
cd "$(dirname "${BASH_SOURCE[0]}")/.."

bash .ci/install-packages.sh
cmake --preset release >/dev/null
cmake --build --preset release --target planescope
planescope=build/release/src/cli/planescope

mkdir -p "$out"
"$planescope" synthesize -o "$out/room.ply" --points 500000
"$planescope" segment "$out/room.ply" -o "$out/room"
echo
"$planescope" evaluate "$out/room" --truth "$out/room.ply" --truth-planes "$out/room.truth.json"
echo
echo "Pictures:"
ls "$out"/room/*.png
