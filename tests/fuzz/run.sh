#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the planescope authors
# SPDX-License-Identifier: BSD-3-Clause
# Fuzzes one target after the other: run.sh SECONDS [TARGET...]. Needs clang with its sanitizers (Debian: clang,
# libclang-rt-14-dev). The corpus grows in build/fuzz/corpus/TARGET, seeded with tests/malformed; what crashes, hangs or
# takes too much memory is left in build/fuzz/found/TARGET, and the script ends with 1.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
seconds=$1
shift
targets=("$@")
((${#targets[@]} > 0)) || targets=(pcd ply result options side_files geometry images sequence snapshot)

cmake --preset fuzz >/dev/null
cmake --build --preset fuzz --target "${targets[@]/#/fuzz_}" >&2
code=0
for target in "${targets[@]}"; do
  corpus=build/fuzz/corpus/$target found=build/fuzz/found/$target log=build/fuzz/$target.log
  mkdir -p "$corpus" "$found"
  dictionary=tests/fuzz/$target.dict
  extra=()
  [[ -f $dictionary ]] && extra+=("-dict=$dictionary")
  # None of our readers may leak; VTK's XML parser does where it gives up.
  leaks=1
  [[ $target != geometry ]] || leaks=0
  ASAN_OPTIONS=detect_leaks=$leaks:allocator_may_return_null=0 UBSAN_OPTIONS=print_stacktrace=1 \
    "build/fuzz/tests/fuzz/fuzz_$target" "$corpus" "tests/malformed/$target" "${extra[@]}" -max_total_time="$seconds" \
    -detect_leaks=$leaks -timeout=10 -rss_limit_mb=2048 -max_len=131072 -print_final_stats=1 -artifact_prefix="$found/" >"$log" 2>&1 || code=1
  echo "$target: $(grep -oE 'cov: [0-9]+ ft: [0-9]+' "$log" | tail -n 1)," \
    "$(sed -n 's/^stat::number_of_executed_units: *//p' "$log") executions," \
    "$(find "$corpus" -type f | wc -l) files in the corpus, $(find "$found" -type f | wc -l) found"
done
exit "$code"
