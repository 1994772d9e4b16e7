#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the planescope authors
# SPDX-License-Identifier: BSD-3-Clause
# Installs what is missing, builds what is out of date, and runs all tests; arguments go to ctest (tests/run.sh -R cli).
# PLANESCOPE_PRESET=asan-ubsan tests/run.sh runs them under the sanitizers (presets: release, dev, asan-ubsan).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
preset=${PLANESCOPE_PRESET:-release}

say() { echo "== $1 ($SECONDS s)" >&2; }  # on CI the log then says where the time went

say "packages"
bash .ci/install-packages.sh
say "configure"
cmake --preset "$preset" >/dev/null
say "build"
cmake --build --preset "$preset"
say "tests"
ctest --preset "$preset" -j "$(nproc)" "$@"
