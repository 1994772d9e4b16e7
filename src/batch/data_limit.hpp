// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sys/resource.h>

#include <algorithm>
#include <cstdint>

namespace planescope {

/// Whether limit_data() does anything: false in a build with the address or thread sanitizer, whose
/// shadow of terabytes is beyond every limit.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kLimitsData = false;
#elif defined(__has_feature)  // clang
inline constexpr bool kLimitsData = !__has_feature(address_sanitizer);
#else
inline constexpr bool kLimitsData = true;
#endif

/// Refuses this process, and what it becomes, data of more than `bytes` in all: allocations beyond
/// throw std::bad_alloc. Safe between fork and exec.
/// \param lasting true: it cannot be raised again.
inline void limit_data(std::uint64_t bytes, bool lasting) {
  if (!kLimitsData) return;
  rlimit limit{};
  if (::getrlimit(RLIMIT_DATA, &limit) != 0) return;
  limit.rlim_cur = std::min<rlim_t>(bytes, limit.rlim_max);
  if (lasting) limit.rlim_max = limit.rlim_cur;
  ::setrlimit(RLIMIT_DATA, &limit);
}

}  // namespace planescope
