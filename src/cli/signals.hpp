// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace planescope::cli {

/// From now on SIGINT, SIGTERM and SIGHUP end the process as they do by default, but after what is
/// half done was put right (io/ending.hpp); SIGPIPE and SIGXFSZ make the write fail that caused
/// them, which then says so. Those that are ignored already (nohup) stay so. To be called before
/// any thread is made.
void handle_signals();

}  // namespace planescope::cli
