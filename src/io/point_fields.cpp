// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/point_fields.hpp"

#include <algorithm>

#include "io/numbers.hpp"

namespace planescope::io {
namespace {

std::string describe(const Field& field) {
  if (field.list) return std::string("a list of ") + words(field.type);
  return std::to_string(field.count) + " x " + words(field.type);
}

/// Fields by name, checked for the role they are to play.
class Finder {
 public:
  Finder(const InputFile& file, const std::vector<Field>& fields) : file_(file), fields_(fields) {}

  std::optional<std::size_t> find(const std::string& name) const {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      if (fields_[i].name != name) continue;
      if (found) file_.fail("the field " + name + " is declared twice; expected it once");
      found = i;
    }
    return found;
  }

  /// The field, if it is there and `fits` it; `expected` says in words what would.
  template <class Fits>
  std::optional<std::size_t> find(const std::string& name, const char* expected, Fits fits) const {
    const std::optional<std::size_t> found = find(name);
    if (!found) return found;
    const Field& field = fields_[*found];
    if (field.list || field.count != 1 || !fits(field.type)) {
      file_.fail("the field " + name + " is " + describe(field) + "; expected " + expected);
    }
    return found;
  }

  /// Three fields that are only of use together: all of them, or none.
  template <class Fits>
  std::optional<std::array<std::size_t, 3>> find_three(const std::array<std::string, 3>& names,
                                                       const char* expected, Fits fits) const {
    std::array<std::size_t, 3> found{};
    std::size_t present = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::optional<std::size_t> one = find(names[i], expected, fits);
      found[i] = one.value_or(0);
      present += one ? 1 : 0;
    }
    if (present == 0) return std::nullopt;
    if (present == 3) return found;
    file_.fail("of the fields " + names[0] + ", " + names[1] + " and " + names[2] + " only " +
               std::to_string(present) + " are declared; expected all of them or none");
  }

 private:
  const InputFile& file_;
  const std::vector<Field>& fields_;
};

using Three = std::optional<std::array<std::size_t, 3>>;

Three find_positions(const InputFile& file, const Finder& finder) {
  for (const char* name : {"x", "y", "z"}) {
    if (!finder.find(name)) {
      file.fail(std::string("the field ") + name + " is missing; a cloud needs x, y and z");
    }
  }
  return finder.find_three({"x", "y", "z"}, "one float or double, in metres", is_real);
}

std::optional<std::size_t> find_packed(const Finder& finder) {
  const auto four_bytes = [](Scalar type) { return size_of(type) == 4; };
  for (const char* name : {"rgb", "rgba"}) {
    if (const auto found = finder.find(name, "one number of four bytes", four_bytes)) return found;
  }
  return std::nullopt;
}

Three find_channels(const Finder& finder) {
  return finder.find_three(
      {"red", "green", "blue"},
      "one unsigned 8-bit integer, unsigned 16-bit integer, or float in [0, 1]",
      [](Scalar type) { return type == Scalar::U8 || type == Scalar::U16 || is_real(type); });
}

Three find_normals(const Finder& finder) {
  if (const Three found =
          finder.find_three({"normal_x", "normal_y", "normal_z"}, "one float or double", is_real)) {
    return found;
  }
  return finder.find_three({"nx", "ny", "nz"}, "one float or double", is_real);
}

void place(Selection& selection, Role role, std::optional<std::size_t> field) {
  selection.role[static_cast<std::size_t>(role)] = field;
}

void place(Selection& selection, Role first, const Three& fields) {
  for (std::size_t i = 0; fields && i < 3; ++i) {
    selection.role[static_cast<std::size_t>(first) + i] = (*fields)[i];
  }
}

/// Replaces indices into the header's fields by indices into `used`.
void number(Selection& selection) {
  std::vector<std::size_t>& used = selection.used;
  for (const auto& field : selection.role) {
    if (field) used.push_back(*field);
  }
  used.insert(used.end(), selection.extra.begin(), selection.extra.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  const auto position = [&](std::size_t field) {
    return static_cast<std::size_t>(std::lower_bound(used.begin(), used.end(), field) -
                                    used.begin());
  };
  for (auto& field : selection.role) {
    if (field) field = position(*field);
  }
  for (std::size_t& field : selection.extra) field = position(field);
}

}  // namespace

Selection select_fields(const InputFile& file, const std::vector<Field>& fields,
                        const std::vector<std::string>& extra) {
  const Finder finder(file, fields);
  Selection selection;
  place(selection, Role::X, find_positions(file, finder));
  const std::optional<std::size_t> packed = find_packed(finder);
  place(selection, Role::Packed, packed);
  if (!packed) place(selection, Role::Red, find_channels(finder));
  place(selection, Role::NormalX, find_normals(finder));
  place(selection, Role::Label,
        finder.find("label", "one whole number", [](Scalar) { return true; }));
  const auto any = [](Scalar) { return true; };
  place(selection, Role::Radius, finder.find("radius", "one number, in metres", any));
  place(selection, Role::Confidence, finder.find("confidence", "one number", any));
  for (const std::string& name : extra) {
    const auto found = finder.find(name, "one integer", [](Scalar type) { return !is_real(type); });
    if (!found) file.fail("the field " + name + " is missing");
    selection.extra.push_back(*found);
  }
  number(selection);
  return selection;
}

}  // namespace planescope::io
