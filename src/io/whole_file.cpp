// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/whole_file.hpp"

#include "io/output_file.hpp"

namespace planescope {

void write_whole(const std::filesystem::path& target, std::string_view bytes) {
  io::OutputFile file(target);
  file.write(bytes);
  file.commit();
}

}  // namespace planescope
