// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/record_writer.hpp"

#include <oneapi/tbb/parallel_pipeline.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include "io/output_file.hpp"
#include "planescope/error.hpp"

namespace planescope::io {
namespace {

constexpr std::size_t kLongestNumber = 26;  // characters, with the blank after it

template <class T>
char* print(char* to, const std::byte* from) {
  const T value = load<T>(from);
  if constexpr (std::is_floating_point_v<T>) {
    if (std::isnan(value)) return std::copy_n("nan", 3, to);  // never "-nan": one text for one fact
  }
  return std::to_chars(to, to + kLongestNumber, value).ptr;
}

/// Memory of a block, and what of it is to be written.
struct Block {
  std::string records, text;
  std::string_view bytes;
};

/// Makes blocks of records, as bytes or as lines.
class RecordMaker {
 public:
  RecordMaker(const std::vector<OutField>& fields, std::size_t points, CloudEncoding encoding)
      : fields_(fields), points_(points), encoding_(encoding) {
    for (const OutField& field : fields) stride_ += size_of(field.type);
    const std::size_t stride = std::max<std::size_t>(1, stride_);  // 0 of no field at all
    block_points_ = std::max<std::size_t>(1, (std::size_t{1} << 18) / stride);
  }

  std::size_t blocks() const { return (points_ + block_points_ - 1) / block_points_; }

  /// Makes block index; block's memory is used again. Returns what is to be written.
  std::string_view make(std::size_t index, Block& block) const {
    const std::size_t first = index * block_points_;
    const std::size_t count = std::min(block_points_, points_ - first);
    block.records.resize(count * stride_);
    std::size_t offset = 0;
    for (const OutField& field : fields_) {
      field.fill(first, count, reinterpret_cast<std::byte*>(block.records.data()) + offset,
                 stride_);
      offset += size_of(field.type);
    }
    if (encoding_ == CloudEncoding::Binary) return block.records;
    block.text.resize(count * fields_.size() * kLongestNumber);
    return {block.text.data(), print_lines(block, count)};
  }

 private:
  /// Prints the records, one line each; the length of the text.
  std::size_t print_lines(Block& block, std::size_t count) const {
    char* to = block.text.data();
    const auto* from = reinterpret_cast<const std::byte*>(block.records.data());
    for (std::size_t i = 0; i < count; ++i) {
      for (const OutField& field : fields_) {
        to = visit(field.type, [&]<class T>() { return print<T>(to, from); });
        from += size_of(field.type);
        *to++ = ' ';
      }
      to[-1] = '\n';
    }
    return static_cast<std::size_t>(to - block.text.data());
  }

  const std::vector<OutField>& fields_;
  std::size_t points_, stride_ = 0, block_points_ = 1;
  CloudEncoding encoding_;
};

/// A component of each vector, as float.
OutField component(std::string name, const std::vector<Eigen::Vector3f>& vectors, int axis) {
  return make_field<float>(std::move(name), Scalar::F32,
                           [&vectors, axis](std::size_t i) { return vectors[i][axis]; });
}

}  // namespace

std::vector<OutField> position_fields(const PointCloud& cloud) {
  constexpr std::array<const char*, 3> names = {"x", "y", "z"};
  std::vector<OutField> fields;
  for (int axis = 0; axis < 3; ++axis) {
    const char* name = names[static_cast<std::size_t>(axis)];
    if (cloud.origin.isZero(0)) {
      fields.push_back(component(name, cloud.positions, axis));
    } else {
      fields.push_back(make_field<double>(name, Scalar::F64, [&cloud, axis](std::size_t i) {
        return cloud.origin[axis] + double{cloud.positions[i][axis]};
      }));
    }
  }
  return fields;
}

std::vector<OutField> normal_fields(const PointCloud& cloud, const char* x, const char* y,
                                    const char* z) {
  if (!cloud.has_normals()) return {};
  return {component(x, cloud.normals, 0), component(y, cloud.normals, 1),
          component(z, cloud.normals, 2)};
}

std::vector<OutField> label_fields(const PointCloud& cloud) {
  if (!cloud.has_labels()) return {};
  return {make_field<std::uint32_t>("label", Scalar::U32,
                                    [&cloud](std::size_t i) { return cloud.labels[i]; })};
}

std::vector<OutField> surfel_fields(const PointCloud& cloud) {
  std::vector<OutField> fields;
  const auto add = [&](const char* name, const std::vector<float>& values) {
    if (values.empty()) return;
    fields.push_back(
        make_field<float>(name, Scalar::F32, [&values](std::size_t i) { return values[i]; }));
  };
  add("radius", cloud.radii);
  add("confidence", cloud.confidences);
  return fields;
}

void append_number(std::string& text, double value) {
  std::array<char, 32> buffer;
  text.append(buffer.data(), std::to_chars(buffer.data(), buffer.data() + 32, value).ptr);
}

void check_writable(const PointCloud& cloud) {
  const auto fail = [](const std::string& what) { throw Error(Error::Kind::Usage, what); };
  const std::size_t points = cloud.size();
  if (points == 0) fail("a cloud without points cannot be written; expected at least one");
  const auto check = [&](std::size_t size, const char* part) {
    if (size == 0 || size == points) return;
    fail("the cloud has " + std::to_string(points) + " points, but " + std::to_string(size) + " " +
         part + "; expected as many, or none");
  };
  check(cloud.colors.size(), "colours");
  check(cloud.normals.size(), "normals");
  check(cloud.labels.size(), "labels");
  check(cloud.radii.size(), "radii");
  check(cloud.confidences.size(), "confidences");
  if (cloud.organised() && std::uint64_t{cloud.width} * cloud.height != points) {
    fail("the cloud is " + std::to_string(cloud.width) + " x " + std::to_string(cloud.height) +
         ", but has " + std::to_string(points) + " points; expected their product");
  }
}

void write_records(const std::filesystem::path& file, const std::string& header,
                   const std::vector<OutField>& fields, std::size_t points, CloudEncoding encoding,
                   std::string_view tail) {
  constexpr std::size_t kBlocksAtOnce = 8;  // bounds the memory
  OutputFile out(file);
  out.write(header);
  const RecordMaker maker(fields, points, encoding);
  // Blocks on their way are consecutive and at most as many as these: none shares its memory. They
  // are owned here, not by the pipeline, which leaks what is on its way when the disk is full.
  std::array<Block, kBlocksAtOnce> ring;
  std::size_t next = 0;
  const auto number = tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order,
                                                          [&](tbb::flow_control& control) {
                                                            if (next == maker.blocks())
                                                              control.stop();
                                                            return next++;
                                                          });
  const auto make = tbb::make_filter<std::size_t, std::size_t>(
      tbb::filter_mode::parallel, [&](std::size_t index) {
        Block& block = ring[index % kBlocksAtOnce];
        block.bytes = maker.make(index, block);
        return index;
      });
  const auto write = tbb::make_filter<std::size_t, void>(
      tbb::filter_mode::serial_in_order,
      [&](std::size_t index) { out.write(ring[index % kBlocksAtOnce].bytes); });
  tbb::parallel_pipeline(kBlocksAtOnce, number & make & write);
  out.write(tail);
  out.commit();
}

}  // namespace planescope::io
