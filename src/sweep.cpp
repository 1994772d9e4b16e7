// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/sweep.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "border_points.hpp"
#include "patches/smoothing.hpp"
#include "planescope/error.hpp"
#include "segment_graph.hpp"
#include "what_if.hpp"

namespace planescope {
namespace {

constexpr std::size_t kMostValues = 1000;

[[noreturn]] void refuse(const std::string& text) {
  throw Error(Error::Kind::Usage,
              "--option is `" + text + "`; it takes NAME=FROM:TO:STEP or NAME=VALUE,VALUE,...");
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

double number(const std::string& part, const std::string& text) {
  double value = 0;
  const char* end = part.data() + part.size();
  const auto [stop, failure] = std::from_chars(part.data(), end, value);
  if (failure != std::errc() || stop != end || !std::isfinite(value)) refuse(text);
  return value;
}

std::vector<std::string> range_values(const std::string& values, const std::string& text) {
  const std::vector<std::string> parts = split(values, ':');
  if (parts.size() != 3) refuse(text);
  const double from = number(parts[0], text), to = number(parts[1], text);
  const double step = number(parts[2], text);
  const double count = std::floor((to - from) / step + 1e-9) + 1;
  if (!(step != 0 && count >= 1 && count <= static_cast<double>(kMostValues))) refuse(text);
  std::vector<std::string> all;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    char value[32];
    std::snprintf(value, sizeof value, "%.10g", from + i * step);
    all.emplace_back(value);
  }
  return all;
}

/// The labels of the points, borders cut point by point as segment() does.
std::vector<std::uint32_t> point_labels(const Segmentation& scene, const PointCloud& cloud,
                                        Outcome&& outcome, const Options& options) {
  Segmentation then;
  then.options = options;
  then.graph = scene.graph;
  if (!outcome.graph.patches.empty()) then.graph.patches = std::move(outcome.graph.patches);
  then.planes = std::move(outcome.planes);
  then.patch_plane = std::move(outcome.patch_plane);
  then.patch_face = std::move(outcome.patch_face);
  then.edges = std::move(outcome.edges);
  then.segments = std::move(outcome.segments);
  const double smoothing = options.patches.smoothing;
  label_points(then, recut_borders(then, smoothing > 0 ? smooth_points(cloud, smoothing) : cloud));
  return then.point_label;
}

void count_edges(SweepRow& row, const std::vector<Edge>& edges) {
  row.edges_on = static_cast<std::size_t>(std::ranges::count(edges, true, &Edge::on));
  row.edges_off = edges.size() - row.edges_on;
}

void score(SweepRow& row, const std::vector<std::uint32_t>& labels, const Segmentation& scene,
           const std::vector<std::uint32_t>& truth) {
  row.agreement = score_labels(labels, scene.point_label).weighted_overlap;
  if (!truth.empty()) row.scores = score_labels(labels, truth);
}

/// The stages behind the patches.
SweepRow run_behind(const Segmentation& scene, const PointCloud& cloud, const Options& options,
                    const std::vector<std::uint32_t>& truth) {
  Outcome outcome = rerun(scene, options);
  SweepRow row;
  row.patches = scene.graph.patches.size();
  row.planes = outcome.planes.size();
  row.segments = outcome.segments.segments.size();
  count_edges(row, outcome.edges);
  row.switched_on = row.switched_off = 0;
  for (std::size_t e = 0; e < outcome.edges.size(); ++e) {
    const bool now = outcome.edges[e].on, before = scene.edges[e].on;
    *row.switched_on += now && !before ? 1 : 0;
    *row.switched_off += !now && before ? 1 : 0;
  }
  score(row, point_labels(scene, cloud, std::move(outcome), options), scene, truth);
  return row;
}

/// The whole method.
SweepRow run_whole(const Segmentation& scene, const PointCloud& cloud, const Options& options,
                   const std::vector<std::uint32_t>& truth) {
  const Segmentation then = segment(cloud, options);
  SweepRow row;
  row.patches = then.graph.patches.size();
  row.planes = then.planes.size();
  row.segments = then.segments.segments.size();
  count_edges(row, then.edges);
  score(row, then.point_label, scene, truth);
  return row;
}

void check_reproduces(const Segmentation& scene, const PointCloud& cloud) {
  if (segment(cloud, scene.options).point_label == scene.point_label) return;
  throw Error(Error::Kind::Input,
              "sweep: the stored points do not give the stored segments again, because the input "
              "had normals or the folder is of another version; sweep planes.*, edges.* or "
              "segments.*, or segment the scene again");
}

}  // namespace

SweepRange parse_sweep(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) refuse(text);
  SweepRange range{text.substr(0, equals), {}};
  const std::string values = text.substr(equals + 1);
  range.values =
      values.find(':') != std::string::npos ? range_values(values, text) : split(values, ',');
  for (const std::string& value : range.values) {
    Options checked;
    set_option(checked, range.option, value);
  }
  return range;
}

std::vector<SweepRow> sweep(const Segmentation& scene, const PointCloud& cloud,
                            const SweepRange& range, const std::vector<std::uint32_t>& truth,
                            const Progress& progress) {
  if (!scene.method.is_ours())
    throw Error(Error::Kind::Usage, "sweep: the result is of method `" + scene.method.name +
                                        "`, whose options are not ours; segment with ours");
  std::vector<Options> all;
  for (const std::string& value : range.values) {
    all.push_back(scene.options);
    set_option(all.back(), range.option, value);
    all.back().validate();
  }
  const bool whole = range.option.starts_with("patches.");
  if (whole) check_reproduces(scene, cloud);
  std::vector<SweepRow> rows;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (progress) progress("sweep", static_cast<double>(i) / static_cast<double>(all.size()));
    rows.push_back(whole ? run_whole(scene, cloud, all[i], truth)
                         : run_behind(scene, cloud, all[i], truth));
    rows.back().value = range.values[i];
  }
  return rows;
}

std::string sweep_csv(const SweepRange& range, const std::vector<SweepRow>& rows) {
  std::string csv = range.option +
                    ",patches,planes,segments,edges_on,edges_off,switched_on,switched_off,"
                    "agreement,weighted_overlap,overlap,over_segmentation,under_segmentation\n";
  const auto add = [&](const std::string& text) { csv.append(",").append(text); };
  const auto add_share = [&](double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6f", value);
    add(text);
  };
  for (const SweepRow& row : rows) {
    csv += row.value;
    for (const std::size_t n : {row.patches, row.planes, row.segments, row.edges_on, row.edges_off})
      add(std::to_string(n));
    add(row.switched_on ? std::to_string(*row.switched_on) : "");
    add(row.switched_off ? std::to_string(*row.switched_off) : "");
    add_share(row.agreement);
    if (row.scores) {
      add_share(row.scores->weighted_overlap);
      add_share(row.scores->overlap);
      add_share(row.scores->over_segmentation);
      add_share(row.scores->under_segmentation);
    } else {
      csv += ",,,,";
    }
    csv += "\n";
  }
  return csv;
}

}  // namespace planescope
