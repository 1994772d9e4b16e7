// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace planescope {

/// Runs `work` to its end on a thread with at least `bytes` of stack and passes on what it throws.
/// PCL's LCCP walks a segment by recursion, one frame a patch: on an ordinary stack of 8 MB that is
/// the end of the process at some 10^5 patches. Pages are only taken when touched.
/// \throws Error{Kind::Computation} the system gives no such thread.
void run_with_stack(std::size_t bytes, const std::function<void()>& work);

}  // namespace planescope
