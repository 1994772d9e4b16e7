// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.hpp"
#include "geometry_files.hpp"

/// \file A VTP file of a result folder, as VTK reads it behind our checks.
namespace planescope::fuzzing {

void fuzz(std::string_view bytes) {
  static const ScratchFolder folder;
  const auto file = folder.write("a.vtp", bytes);
  refused_or_taken([&] {
    draw::VtpContract contract{draw::VtpContract::Columns::OfCells, {{"on", 1}}, -1};
    contract.max_points = 1'000'000;
    draw::read_vtp(file, Eigen::Vector3d::Zero(), contract);
  });
}

}  // namespace planescope::fuzzing
