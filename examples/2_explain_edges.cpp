// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
/// \file Says why edges of the patch graph are ON or OFF: how many by each rule, and the closest
/// decision of each rule in words.
#include <cstdio>
#include <string>

#include "planescope/error.hpp"
#include "planescope/pipeline.hpp"
#include "planescope/synthesize.hpp"

int main() try {
  const planescope::PointCloud cloud = planescope::synthesize({.points = 60'000}).cloud;
  const auto scene = planescope::segment(cloud, planescope::Options::automatic(cloud));

  const auto counts = planescope::count_rules(scene.edges);
  for (std::size_t rule = 0; rule < planescope::kEdgeRuleCount; ++rule) {
    const auto wanted = static_cast<planescope::EdgeRule>(rule);
    const planescope::Edge* closest = nullptr;
    for (const planescope::Edge& edge : scene.edges) {
      const bool candidate = edge.rule == wanted;
      if (candidate && (closest == nullptr || edge.margin < closest->margin)) closest = &edge;
    }
    std::printf("%-16s %6zu\n", std::string(planescope::name(wanted)).c_str(), counts[rule]);
    if (closest != nullptr) std::printf("  %s\n", planescope::explain(scene, *closest).c_str());
  }
  return 0;
} catch (const planescope::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return error.exit_code();
}
