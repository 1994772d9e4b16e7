// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
// A race put here on purpose: a sum without a lock. The preset `tsan` expects a report of it; were
// there none, silence over the other tests would say nothing.
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <cstdio>

int main() {
  int sum = 0;
  tbb::parallel_for(tbb::blocked_range<int>(0, 64), [&](const tbb::blocked_range<int>& range) {
    for (int i = range.begin(); i != range.end(); ++i) sum += i;
  });
  std::printf("%d\n", sum);
}
