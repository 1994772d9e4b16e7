// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "planescope/compare.hpp"
#include "planescope/compare_pictures.hpp"
#include "planescope/error.hpp"
#include "planescope/render.hpp"
#include "planescope/result.hpp"

namespace planescope::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr double kResultTolerance = 0.01;

struct Arguments {
  Console console;
  fs::path a, b, difference;
  std::optional<double> tolerance;
  CompareOptions planes;
};

Json edges_json(const EdgeChanges& edges) {
  Json rules = Json::array();
  for (std::size_t from = 0; from < kEdgeRuleCount; ++from) {
    for (std::size_t to = 0; to < kEdgeRuleCount; ++to) {
      const std::size_t count = edges.by_rule[from][to];
      if (from == to || count == 0) continue;
      rules.push_back({{"from", name(static_cast<EdgeRule>(from))},
                       {"to", name(static_cast<EdgeRule>(to))},
                       {"edges", count}});
    }
  }
  return {{"compared", edges.compared},
          {"on_to_off", edges.on_to_off},
          {"off_to_on", edges.off_to_on},
          {"same_state_other_rule", edges.same_state},
          {"gone", edges.gone},
          {"new", edges.added},
          {"rule_changes", std::move(rules)}};
}

Json result_json(const ResultComparison& r) {
  Json segments = Json::array(), planes = Json::array();
  for (const SegmentMatch& m : r.segments)
    segments.push_back({{"a", m.first}, {"b", m.second}, {"overlap", m.overlap}});
  for (const PlaneMatch& m : r.planes)
    planes.push_back({{"a", m.first},
                      {"b", m.second},
                      {"angle", m.angle},
                      {"offset", m.offset},
                      {"moved", m.moved}});
  return {
      {"same_input", r.same_input},
      {"same_options", r.same_options},
      {"changed_points", r.changed_points},
      {"changed_planes", r.changed_planes},
      {"changed_edges", r.changed_edges},
      {"segments",
       {{"matched", std::move(segments)}, {"gone", r.gone_segments}, {"new", r.new_segments}}},
      {"planes", {{"matched", std::move(planes)}, {"gone", r.gone_planes}, {"new", r.new_planes}}},
      {"edges", edges_json(r.edges)},
      {"scores",
       {{"weighted_overlap", r.scores.weighted_overlap},
        {"overlap", r.scores.overlap},
        {"adjusted_rand", r.scores.adjusted_rand},
        {"variation_of_information", r.scores.variation_of_information}}}};
}

void print_result(const ResultComparison& r) {
  if (!r.same_input) std::printf("the inputs differ\n");
  if (!r.same_options) std::printf("the options differ\n");
  std::printf("segments  %zu the same, %zu gone, %zu new; %.3f %% of the points changed\n",
              r.segments.size(), r.gone_segments.size(), r.new_segments.size(),
              100 * r.changed_points);
  std::size_t moved = 0;
  double angle = 0, offset = 0;
  for (const PlaneMatch& m : r.planes) {
    moved += m.moved ? 1 : 0;
    angle = std::max(angle, m.angle);
    offset = std::max(offset, m.offset);
  }
  std::printf(
      "planes    %zu the same, %zu of them moved, %zu gone, %zu new; at most %.3f deg, "
      "%.4f m; %.3f %% of their points changed\n",
      r.planes.size(), moved, r.gone_planes.size(), r.new_planes.size(), angle, offset,
      100 * r.changed_planes);
  const EdgeChanges& e = r.edges;
  std::printf(
      "edges     %zu compared: %zu from ON to OFF, %zu from OFF to ON, %zu by another "
      "rule; %zu gone, %zu new; %.3f %% changed\n",
      e.compared, e.on_to_off, e.off_to_on, e.same_state, e.gone, e.added, 100 * r.changed_edges);
  for (std::size_t from = 0; from < kEdgeRuleCount; ++from) {
    for (std::size_t to = 0; to < kEdgeRuleCount; ++to) {
      if (from == to || e.by_rule[from][to] == 0) continue;
      std::printf("          %6zu from %s to %s\n", e.by_rule[from][to],
                  std::string(name(static_cast<EdgeRule>(from))).c_str(),
                  std::string(name(static_cast<EdgeRule>(to))).c_str());
    }
  }
  std::printf("scores    of B with A as the truth: WO %.4f, UO %.4f, ARI %.4f, VI %.4f bit\n",
              r.scores.weighted_overlap, r.scores.overlap, r.scores.adjusted_rand,
              r.scores.variation_of_information);
}

void demand(double difference, double tolerance, const std::string& what) {
  if (difference <= tolerance) return;
  std::array<char, 96> numbers{};
  std::snprintf(numbers.data(), numbers.size(), "differ by %.4g; --tolerance is %.4g", difference,
                tolerance);
  throw Error(Error::Kind::Mismatch, what + " " + numbers.data());
}

/// \throws Error{Kind::Input} also where a file is not the one that result.json was written with.
Result load_whole(const fs::path& folder) {
  Result result = load_result(folder);
  for (const auto& [name, hash] : result.file_hashes) check_file(result, folder, name);
  return result;
}

void compare_folders(const Arguments& a) {
  if (!a.difference.empty())
    throw Error(Error::Kind::Usage,
                "-o draws the difference of pictures; result folders have none");
  const Result first = load_whole(a.a), second = load_whole(a.b);
  const ResultComparison found =
      compare_results(first, stored_edges(first, a.a), second, stored_edges(second, a.b), a.planes);
  const double tolerance = a.tolerance.value_or(kResultTolerance);
  if (a.console.json) {
    Json json = result_json(found);
    json["tolerance"] = tolerance;
    json["within"] = found.worst() <= tolerance;
    std::printf("%s\n", json.dump(1).c_str());
  } else if (!a.console.quiet) {
    print_result(found);
  }
  demand(found.worst(), tolerance, "the results " + a.a.string() + " and " + a.b.string());
}

void compare_files(const Arguments& a) {
  const PictureComparison found = compare_pictures(a.a, a.b, a.difference);
  const double tolerance = a.tolerance.value_or(kPictureTolerance);
  if (a.console.json) {
    const Json json = {{"worst", found.worst},
                       {"worst_at", {found.worst_at[0], found.worst_at[1]}},
                       {"square", kCompareSquare},
                       {"mean", found.mean},
                       {"changed_pixels", found.changed},
                       {"pixels", found.pixels},
                       {"tolerance", tolerance},
                       {"within", found.worst <= tolerance}};
    std::printf("%s\n", json.dump(1).c_str());
  } else if (!a.console.quiet) {
    if (found.identical()) {
      std::printf("the same pixels\n");
    } else {
      std::printf(
          "worst square (%d x %d pixels) %.4f, around pixel %d,%d; mean %.6f; %.3f %% of "
          "the pixels changed (FLIP error, 0 to 1)\n",
          kCompareSquare, kCompareSquare, found.worst, found.worst_at[0], found.worst_at[1],
          found.mean, 100 * static_cast<double>(found.changed) / static_cast<double>(found.pixels));
    }
  }
  demand(found.worst, tolerance, "the pictures " + a.a.string() + " and " + a.b.string());
}

void run(const Arguments& a) {
  const bool folder = fs::is_directory(a.a);
  if (folder != fs::is_directory(a.b) && fs::exists(a.a) && fs::exists(a.b))
    throw Error(Error::Kind::Usage, "one of " + a.a.string() + " and " + a.b.string() +
                                        " is a folder; name two pictures or two result folders");
  if (!a.difference.empty() && a.difference.extension() != ".png")
    throw Error(Error::Kind::Usage,
                "-o is `" + a.difference.string() + "`; it takes a name that ends in .png");
  folder ? compare_folders(a) : compare_files(a);
}

}  // namespace

Command add_compare(CLI::App& program) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand(
      "compare", "Tell what differs between two pictures, or two results; exit with 6 if too much");
  command->add_option("A", a->a, "Picture (PNG), or result folder")->required();
  command->add_option("B", a->b, "The same kind")->required();
  command
      ->add_option(
          "--tolerance", a->tolerance,
          "Pictures: FLIP error of the worst square of 16x16 pixels (0.03). Results: share "
          "of points, planes' points, or edges that changed (0.01)")
      ->check(CLI::Range(0.0, 1.0))
      ->type_name("0..1");
  command->add_option("-o,--output", a->difference, "Draw the difference of two pictures")
      ->type_name("PNG");
  command
      ->add_option("--plane-angle", a->planes.plane_angle, "A plane that turned further has moved")
      ->check(CLI::Range(0.0, 90.0))
      ->capture_default_str()
      ->type_name("DEG");
  command->add_option("--plane-offset", a->planes.plane_offset, "So has one that went further")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str()
      ->type_name("M");
  a->console.declare(*command);
  return {command, [a] { run(*a); }};
}

}  // namespace planescope::cli
