// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/questions.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "cli/values.hpp"
#include "planescope/error.hpp"
#include "planescope/io.hpp"
#include "planescope/truth_errors.hpp"

namespace planescope::cli {
namespace {

/// `I,J`
std::pair<std::uint32_t, std::uint32_t> parse_pair(const std::string& option,
                                                   const std::string& text,
                                                   const std::string& expected) {
  std::pair<std::uint32_t, std::uint32_t> pair;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, pair.first);
  const bool comma = first.ec == std::errc() && first.ptr != end && *first.ptr == ',';
  const auto second = std::from_chars(comma ? first.ptr + 1 : end, end, pair.second);
  if (!comma || second.ec != std::errc() || second.ptr != end)
    throw Error(Error::Kind::Usage, option + " is `" + text + "`; it takes " + expected);
  return pair;
}

}  // namespace

void Question::declare(CLI::App& command) {
  const std::string group = "Questions (one of them)";
  const auto text = [&](const char* name, std::string& value, const char* help, const char* type) {
    command.add_option(name, value, help)->type_name(type)->group(group);
  };
  const auto number = [&](const char* name, std::optional<std::uint32_t>& value, const char* help,
                          const char* type) {
    command.add_option(name, value, help)->type_name(type)->group(group);
  };
  text("--edge", edge_, "The edge between two patches", "I,J");
  number("--segment", segment_, "What holds a segment together, and what bounds it", "K");
  text("--between", between_,
       "What joined two places, or keeps them apart: two patches, or two places as "
       "X,Y,Z:X,Y,Z",
       "K,L");
  text("--near", near_, "The edges nearest to a place", "X,Y,Z");
  number("--weakest", weakest_, "The N edges that were decided most narrowly", "N");
  number("--wrong", wrong_, "The N worst errors; needs --truth", "N");
  number("--plane", plane_, "Why this plane was chosen", "K");
  text("--missing", missing_, "Why there is no plane here", "X,Y,Z");
  command.add_option("--count", count_, "Edges to tell of, with --near, --segment, --between")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command.add_flag("--no-flips", no_flips_, "Do not look for what would change it (quicker)");
  command.add_option("--truth", truth_, "Cloud with the true labels of the scene's points")
      ->type_name("CLOUD");
  policy_.declare(command);
}

void Question::check() {
  policy_.check();
  std::size_t asked = 0;
  const auto ask = [&](Kind kind, bool given) {
    if (given) kind_ = kind, ++asked;
  };
  ask(Kind::Edge, !edge_.empty());
  ask(Kind::Segment, segment_.has_value());
  ask(Kind::Between, !between_.empty());
  ask(Kind::Near, !near_.empty());
  ask(Kind::Weakest, weakest_.has_value());
  ask(Kind::Wrong, wrong_.has_value());
  ask(Kind::Plane, plane_.has_value());
  ask(Kind::Missing, !missing_.empty());
  if (asked != 1)
    throw Error(Error::Kind::Usage,
                "explain: ask one of --edge, --segment, --between, --near, --weakest, --wrong, "
                "--plane, --missing; " +
                    std::to_string(asked) + " were given");
  if (kind_ == Kind::Wrong && truth_.empty())
    throw Error(Error::Kind::Usage, "--wrong needs --truth CLOUD");
  if (kind_ == Kind::Edge) numbers_ = parse_pair("--edge", edge_, "two patches, I,J");
  if (kind_ == Kind::Segment) numbers_.first = *segment_;
  if (kind_ == Kind::Plane) numbers_.first = *plane_;
  if (kind_ == Kind::Weakest) count_ = *weakest_;
  if (kind_ == Kind::Wrong) count_ = *wrong_;
  if (kind_ == Kind::Near) places_.push_back(parse_vector("--near", near_));
  if (kind_ == Kind::Missing) places_.push_back(parse_vector("--missing", missing_));
  if (kind_ == Kind::Between) parse_between();
}

void Question::parse_between() {
  const std::size_t colon = between_.find(':');
  if (colon == std::string::npos) {
    numbers_ = parse_pair("--between", between_, "two patches, K,L, or two places, X,Y,Z:X,Y,Z");
    return;
  }
  places_.push_back(parse_vector("--between", between_.substr(0, colon)));
  places_.push_back(parse_vector("--between", between_.substr(colon + 1)));
}

Eigen::Vector3f Question::place(const StoredScene& stored, std::size_t end) const {
  return (places_.at(end) - stored.cloud.origin).cast<float>();
}

std::vector<std::uint32_t> Question::truth(const StoredScene& stored) const {
  if (truth_.empty()) return {};
  const std::vector<std::uint32_t> labels = read_cloud(truth_).labels;
  if (labels.empty())
    throw Error(Error::Kind::Input,
                truth_.string() + ": has no field `label`; name a cloud that has one");
  if (labels.size() != stored.cloud.size())
    throw Error(Error::Kind::Input, truth_.string() + ": has " + std::to_string(labels.size()) +
                                        " points, the scene has " +
                                        std::to_string(stored.cloud.size()) +
                                        "; name the cloud that the scene was made from");
  TruthPolicy undivided = policy_.policy;
  undivided.divide = 1;
  return object_labels(apply_policy(stored.scene.point_label, labels, undivided),
                       policy_.policy.divide);
}

}  // namespace planescope::cli
