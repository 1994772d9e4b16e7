// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/method_arguments.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "planescope/error.hpp"
#ifdef PLANESCOPE_PCL_VERSION
#include "baselines/peer_segmentation.hpp"
#endif

namespace planescope::cli {
namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& text,
                         const std::string& expected) {
  throw Error(Error::Kind::Usage, option + " is `" + text + "`; it takes " + expected);
}

}  // namespace

const std::vector<std::string>& method_names() {
  static const std::vector<std::string> names = {"ransac", "lccp", "cpc", "ours"};
  return names;
}

void check_method(const std::string& option, const std::string& method) {
  if (std::ranges::find(method_names(), method) == method_names().end()) {
    refuse(option, method, "ours | ransac | lccp | cpc");
  }
#ifndef PLANESCOPE_PCL_VERSION
  if (method != "ours") {
    refuse(option, method, "ours: this planescope was built without the peers (PCL)");
  }
#endif
}

std::vector<std::string> parse_methods(const std::string& option, const std::string& text) {
  std::vector<std::string> methods;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    const std::string method = text.substr(from, to - from);
    check_method(option, method);
    if (std::ranges::find(methods, method) != methods.end()) {
      refuse(option, text, "each method once");
    }
    methods.push_back(method);
    from = to + 1;
  }
  return methods;
}

#ifdef PLANESCOPE_PCL_VERSION

void MethodArguments::declare(CLI::App& command) {
  command
      .add_option("--peer-scale", scale_,
                  "Lengths of the peers: ours (our voxels, patches and sigma) | example (PCL's "
                  "example programs: 7.5 mm, 3 cm, 1 cm)")
      ->type_name("NAME")
      ->capture_default_str()
      ->group(kGroup);
  for (const PeerOptionInfo& info : peer_option_table()) {
    Given& given = given_.emplace_back(Given{info.name, {}});
    command.add_option("--" + info.name, given.text, info.meaning)
        ->type_name(info.unit == "1" ? "NUMBER" : info.unit)
        ->group(kGroup)
        ->each([&given](const std::string&) { given.seen = true; });
  }
}

void MethodArguments::check() const {
  if (scale_ != "ours" && scale_ != "example") refuse("--peer-scale", scale_, "ours | example");
  PeerOptions peers;
  for (const Given& given : given_) {
    if (given.seen) set_peer_option(peers, given.name, given.text);
  }
}

Segmentation MethodArguments::run(const std::string& method, const PointCloud& cloud,
                                  const Options& options, const Progress& progress) const {
  if (method == "ours") return segment(cloud, options, progress);
  PeerOptions peers = scale_ == "ours" ? PeerOptions::at_scale(options) : PeerOptions{};
  for (const Given& given : given_) {
    if (given.seen) set_peer_option(peers, given.name, given.text);
  }
  return peer_segmentation(method, cloud, options, peers);
}

#else

void MethodArguments::declare(CLI::App&) {}
void MethodArguments::check() const {}

Segmentation MethodArguments::run(const std::string&, const PointCloud& cloud,
                                  const Options& options, const Progress& progress) const {
  return segment(cloud, options, progress);
}

#endif

}  // namespace planescope::cli
