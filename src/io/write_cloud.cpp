// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cctype>
#include <string>

#include "io/pcd_writer.hpp"
#include "io/ply_writer.hpp"
#include "planescope/error.hpp"
#include "planescope/io.hpp"

namespace planescope {

void write_cloud(const PointCloud& cloud, const std::filesystem::path& file,
                 CloudEncoding encoding) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".pcd") return io::write_pcd(file, cloud, encoding);
  if (extension == ".ply") return io::write_ply(file, cloud, encoding);
  throw Error(Error::Kind::Input,
              file.string() + ": the extension is \"" + extension + "\"; expected .pcd or .ply");
}

}  // namespace planescope
