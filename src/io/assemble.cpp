// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/assemble.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <span>
#include <string>

#include "io/decode.hpp"

namespace planescope::io {
namespace {

/// What one block found; blocks are summed up in order afterwards.
struct BlockReport {
  std::size_t finite = 0;
  std::optional<std::size_t> bad;  ///< first point with a whole number out of range
  std::size_t bad_column = 0;
};

/// Decodes blocks into the parts of one cloud.
class Decoder {
 public:
  Decoder(const PointSource& source, const Selection& selection, Assembled& result)
      : source_(source), selection_(selection), result_(result) {}

  /// Makes room for all points.
  void resize(std::size_t points) {
    PointCloud& cloud = result_.cloud;
    cloud.positions.resize(points);
    if (selection_.has(Role::Packed) || selection_.has(Role::Red)) cloud.colors.resize(points);
    if (selection_.has(Role::NormalX)) cloud.normals.resize(points);
    if (selection_.has(Role::Label)) cloud.labels.resize(points);
    if (selection_.has(Role::Radius)) cloud.radii.resize(points);
    if (selection_.has(Role::Confidence)) cloud.confidences.resize(points);
    result_.extra.resize(selection_.extra.size());
    for (auto& column : result_.extra) column.resize(points);
  }

  BlockReport decode(std::size_t first, std::size_t count, Scratch& scratch) const {
    const std::vector<Column> columns = source_.block(first, count, scratch);
    PointCloud& cloud = result_.cloud;
    const auto part = [&](auto& values) { return std::span(values).subspan(first, count); };
    BlockReport report;
    report.finite = decode_positions(columns, selection_, cloud.origin, part(cloud.positions));
    if (cloud.has_colors()) decode_colors(columns, selection_, part(cloud.colors));
    if (cloud.has_normals()) decode_normals(columns, selection_, part(cloud.normals));
    const auto column_of = [&](Role role) -> const Column& {
      return columns[*selection_.role[static_cast<std::size_t>(role)]];
    };
    if (cloud.has_radii()) decode_numbers(column_of(Role::Radius), true, part(cloud.radii));
    if (cloud.has_confidences()) {
      decode_numbers(column_of(Role::Confidence), false, part(cloud.confidences));
    }
    const auto note = [&](std::size_t column, std::optional<std::size_t> bad) {
      if (!bad || (report.bad && *report.bad <= first + *bad)) return;
      report.bad = first + *bad;
      report.bad_column = column;
    };
    if (cloud.has_labels()) {
      const std::size_t column = *selection_.role[static_cast<std::size_t>(Role::Label)];
      note(column, decode_whole(columns[column], part(cloud.labels)));
    }
    for (std::size_t i = 0; i < result_.extra.size(); ++i) {
      const std::size_t column = selection_.extra[i];
      note(column, decode_whole(columns[column], part(result_.extra[i])));
    }
    return report;
  }

 private:
  const PointSource& source_;
  const Selection& selection_;
  Assembled& result_;
};

std::vector<BlockReport> decode_all(const Decoder& decoder, std::size_t points, std::size_t step) {
  std::vector<BlockReport> reports((points + step - 1) / step);
  tbb::enumerable_thread_specific<Scratch> scratch;
  tbb::parallel_for(std::size_t{0}, reports.size(), [&](std::size_t block) {
    const std::size_t first = block * step;
    reports[block] = decoder.decode(first, std::min(step, points - first), scratch.local());
  });
  return reports;
}

[[noreturn]] void fail_whole(const InputFile& file, const PointSource& source,
                             const Selection& selection, const BlockReport& report) {
  Scratch scratch;
  const Column column = source.block(*report.bad, 1, scratch)[report.bad_column];
  const std::string value = visit(
      column.type, [&]<class T>() { return std::to_string(load<T>(column.data, column.swapped)); });
  const auto& label = selection.role[static_cast<std::size_t>(Role::Label)];
  const bool is_label = label && *label == report.bad_column;
  file.fail("point " + std::to_string(*report.bad) + ": " +
            (is_label ? "label is " + value + "; expected a whole number from 0 to 4294967295"
                      : "an index is " + value + "; expected a signed 32-bit integer"));
}

std::optional<Eigen::Vector3f> sensor_of(const Frame& frame, const Eigen::Vector3d& origin) {
  if (!frame.viewpoint) return std::nullopt;
  const bool own_frame = frame.height > 1 && origin.isZero(0);
  if (frame.viewpoint->isZero(0) && !own_frame) return std::nullopt;
  return (*frame.viewpoint - origin).cast<float>();
}

}  // namespace

Assembled assemble(const InputFile& file, const PointSource& source, const Selection& selection,
                   const Frame& frame, const std::optional<Eigen::Vector3d>& origin) {
  Assembled result;
  PointCloud& cloud = result.cloud;
  cloud.origin = origin ? *origin : choose_origin(source, selection, frame.points);
  cloud.width = frame.width;
  cloud.height = frame.height;
  cloud.sensor = sensor_of(frame, cloud.origin);
  Decoder decoder(source, selection, result);
  decoder.resize(frame.points);
  const std::vector<BlockReport> reports = decode_all(decoder, frame.points, source.block_points());
  std::size_t finite = 0;
  for (const BlockReport& report : reports) {
    if (report.bad) fail_whole(file, source, selection, report);
    finite += report.finite;
  }
  if (finite == 0) {
    file.fail("none of the " + std::to_string(frame.points) +
              " points is finite; expected at least one with x, y and z");
  }
  return result;
}

}  // namespace planescope::io
