// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "planescope/error.hpp"
#include "planescope/options.hpp"
#include "planescope/planes.hpp"

/// \file result.json as it is read back: every value is asked for by type and range, and a refusal
/// names it.
namespace planescope {

/// A value of result.json and how it is called, for messages.
class Node {
 public:
  Node(const nlohmann::json& json, const std::filesystem::path& file, std::string name)
      : json_(json), file_(file), name_(std::move(name)) {}

  [[noreturn]] void fail(const std::string& expected) const {
    throw Error(Error::Kind::Input, file_.string() + ": " + name_ + " should be " + expected +
                                        "; run `planescope segment` again");
  }

  Node operator[](const char* key) const {
    if (!json_.is_object() || !json_.contains(key))
      fail("an object with `" + std::string(key) + "`");
    return {json_.at(key), file_, name_.empty() ? key : name_ + "." + key};
  }

  bool has(const char* key) const { return json_.is_object() && json_.contains(key); }

  std::vector<Node> items() const {
    if (!json_.is_array()) fail("a list");
    std::vector<Node> all;
    for (const nlohmann::json& item : json_) {
      all.emplace_back(item, file_, name_ + "[" + std::to_string(all.size()) + "]");
    }
    return all;
  }

  std::vector<std::pair<std::string, Node>> members() const {
    if (!json_.is_object()) fail("an object");
    std::vector<std::pair<std::string, Node>> all;
    for (const auto& [key, item] : json_.items()) {
      all.emplace_back(key, Node(item, file_, name_ + "." + key));
    }
    return all;
  }

  std::uint32_t count(std::uint32_t limit = std::numeric_limits<std::int32_t>::max()) const {
    if (!json_.is_number_unsigned() || json_.get<std::uint64_t>() > limit) {
      fail("a whole number from 0 to " + std::to_string(limit));
    }
    return json_.get<std::uint32_t>();
  }

  double number() const {
    if (!json_.is_number() || !std::isfinite(json_.get<double>())) fail("a number");
    return json_.get<double>();
  }
  float real() const {
    const double value = number();
    if (std::abs(value) > double(std::numeric_limits<float>::max())) fail("within a float's range");
    return static_cast<float>(value);
  }

  Eigen::Vector3d vector() const {
    const auto parts = items();
    if (parts.size() != 3) fail("three numbers");
    return {parts[0].number(), parts[1].number(), parts[2].number()};
  }

  Eigen::Vector3f position() const {
    const auto parts = items();
    if (parts.size() != 3) fail("three numbers");
    return {parts[0].real(), parts[1].real(), parts[2].real()};
  }

  Eigen::Vector3f unit() const {
    Eigen::Vector3f v = position();
    if (!(std::abs(v.norm() - 1) < 1e-3f)) fail("a unit vector");
    return v;
  }

  std::string dump() const {
    return json_.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  }
  bool is_text() const { return json_.is_string(); }
  bool null() const { return json_.is_null(); }
  bool flag() const {
    if (!json_.is_boolean()) fail("true or false");
    return json_.get<bool>();
  }
  std::string text() const {
    if (!json_.is_string()) fail("a text");
    return json_.get<std::string>();
  }

 private:
  const nlohmann::json& json_;
  const std::filesystem::path& file_;
  std::string name_;
};

/// `options`: all that are there, by name. \throws Error{Kind::Input} one is unknown or bad.
Options read_options(const Node& node);

/// `hypotheses`: those that were accepted and those that were refused.
/// \throws Error{Kind::Input} malformed, or an index that is out of range.
PlaneSelection read_selection(const Node& node);

}  // namespace planescope
