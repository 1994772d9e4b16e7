#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the planescope authors
# SPDX-License-Identifier: BSD-3-Clause
# Static analysis of include, src and render: cppcheck with tests/cppcheck.supp, clang-tidy with .clang-tidy. lint.sh [FILE...]
# looks at those files only. Ends with 1 where either has something to say. Needs cppcheck and clang-tidy.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
files=("$@")
((${#files[@]} > 0)) || mapfile -t files < <(find src render -name '*.cpp' | sort)
code=0
cppcheck --enable=warning,performance,portability --inline-suppr --std=c++20 --language=c++ --quiet \
  --suppress=missingIncludeSystem --suppressions-list=tests/cppcheck.supp -I include -I src -I render --error-exitcode=1 \
  "${files[@]}" || code=1
cmake --preset dev >/dev/null
printf '%s\n' "${files[@]}" | xargs -P "$(nproc)" -n 1 clang-tidy -p build/dev --quiet --warnings-as-errors='*' || code=1
exit "$code"
