// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planes/labelling.hpp"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

namespace planescope {
namespace {

constexpr double kNoneCost = 2;       // U of "no plane" (Section IV-C)
constexpr std::size_t kChunk = 2048;  // patches a task

/// Calls visit(plane, cost) for each plane that is allowed for a patch.
template <typename Visit>
void for_each_choice(const Patch& patch, const std::vector<Plane>& planes,
                     const PlaneOptions& options, Visit visit) {
  const float sigma = static_cast<float>(options.sigma) * patch.scale;
  const auto gate = static_cast<float>(options.normal_gate);
  for (std::uint32_t p = 0; p < planes.size(); ++p) {
    const float cost = std::abs(planes[p].signed_distance(patch.centroid)) / sigma;
    const bool gated = std::abs(planes[p].normal.dot(patch.normal)) >= gate;
    if (!(gated && cost < static_cast<float>(kNoneCost))) continue;
    visit(p, static_cast<std::int32_t>(std::lround(static_cast<double>(cost) * kCostUnit)));
  }
}

template <typename Task>
void for_chunks(std::size_t size, Task task) {
  tbb::parallel_for(std::size_t{0}, (size + kChunk - 1) / kChunk, [&](std::size_t chunk) {
    for (std::size_t i = chunk * kChunk; i < std::min(size, (chunk + 1) * kChunk); ++i) task(i);
  });
}

void accumulate_offsets(std::vector<std::uint32_t>& offsets) {
  for (std::size_t i = 1; i < offsets.size(); ++i) offsets[i] += offsets[i - 1];
}

void fill_choices(LabellingProblem& problem, const std::vector<Patch>& patches,
                  const std::vector<Plane>& planes, const PlaneOptions& options) {
  auto& offsets = problem.choice_offsets;
  offsets.assign(patches.size() + 1, 0);
  for_chunks(patches.size(), [&](std::size_t i) {
    for_each_choice(patches[i], planes, options,
                    [&](std::uint32_t, std::int32_t) { ++offsets[i + 1]; });
  });
  accumulate_offsets(offsets);
  problem.choices.resize(offsets.back());
  for_chunks(patches.size(), [&](std::size_t i) {
    std::uint32_t next = offsets[i];
    for_each_choice(patches[i], planes, options, [&](std::uint32_t plane, std::int32_t cost) {
      problem.choices[next++] = {plane, cost};
    });
  });
}

/// The same pairs by plane.
void fill_members(LabellingProblem& problem, std::size_t planes) {
  auto& offsets = problem.member_offsets;
  offsets.assign(planes + 1, 0);
  for (const Choice& choice : problem.choices) ++offsets[choice.index + 1];
  accumulate_offsets(offsets);
  problem.members.resize(problem.choices.size());
  std::vector<std::uint32_t> next(offsets.begin(), offsets.end() - 1);
  for (std::uint32_t i = 0; i < problem.size(); ++i) {
    for (const Choice& c : problem.choices_of(i)) problem.members[next[c.index]++] = {i, c.cost};
  }
}

void fill_neighbours(LabellingProblem& problem, const PatchGraph& graph) {
  auto& offsets = problem.neighbour_offsets;
  offsets.assign(graph.patches.size() + 1, 0);
  for (const Adjacency& edge : graph.adjacency)
    ++offsets[edge.first + 1], ++offsets[edge.second + 1];
  accumulate_offsets(offsets);
  problem.neighbours.resize(2 * graph.adjacency.size());
  std::vector<std::uint32_t> next(offsets.begin(), offsets.end() - 1);
  for (const Adjacency& edge : graph.adjacency) {
    problem.neighbours[next[edge.first]++] = edge.second;
    problem.neighbours[next[edge.second]++] = edge.first;
  }
}

std::int32_t cost_of(const LabellingProblem& problem, std::size_t patch, std::int32_t label) {
  for (const Choice& choice : problem.choices_of(patch)) {
    if (static_cast<std::int32_t>(choice.index) == label) return choice.cost;
  }
  return problem.none_cost;
}

// Where relax_labels() counts a label: the first place is that of kNone, which is -1.
std::size_t place_of(std::int32_t label) {
  return static_cast<std::size_t>(std::int64_t{label} + 1);
}

}  // namespace

LabellingProblem make_labelling_problem(const PatchGraph& graph, const std::vector<Plane>& planes,
                                        const PlaneOptions& options) {
  LabellingProblem problem;
  problem.none_cost = static_cast<std::int32_t>(kNoneCost * kCostUnit);
  problem.potts = static_cast<std::int32_t>(std::lround(options.smoothness * kCostUnit));
  fill_choices(problem, graph.patches, planes, options);
  fill_members(problem, planes.size());
  fill_neighbours(problem, graph);
  return problem;
}

std::int64_t labelling_energy(const LabellingProblem& problem, const Labels& labels) {
  std::int64_t sum = 0, borders = 0;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    sum += cost_of(problem, i, labels[i]);
    for (const std::uint32_t j : problem.neighbours_of(i)) borders += labels[i] != labels[j];
  }
  return sum + borders / 2 * problem.potts;  // every edge was seen from both ends
}

Labels cheapest_labels(const LabellingProblem& problem) {
  Labels labels(problem.size(), kNone);
  for (std::size_t i = 0; i < problem.size(); ++i) {
    std::int32_t least = problem.none_cost;
    for (const Choice& choice : problem.choices_of(i)) {
      if (choice.cost < least)
        least = choice.cost, labels[i] = static_cast<std::int32_t>(choice.index);
    }
  }
  return labels;
}

Labels relax_labels(const LabellingProblem& problem, Labels labels) {
  std::vector<std::int32_t> agreeing(problem.labels() + 1, 0);  // neighbours by label + 1
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < problem.size(); ++i) {
      for (const std::uint32_t j : problem.neighbours_of(i)) ++agreeing[place_of(labels[j])];
      const auto local = [&](std::int32_t label, std::int32_t cost) {
        return std::int64_t{cost} - std::int64_t{problem.potts} * agreeing[place_of(label)];
      };
      std::int32_t best = labels[i];
      std::int64_t least = local(best, cost_of(problem, i, best));
      const auto offer = [&](std::int32_t label, std::int32_t cost) {
        if (local(label, cost) < least) best = label, least = local(label, cost);
      };
      for (const Choice& c : problem.choices_of(i))
        offer(static_cast<std::int32_t>(c.index), c.cost);
      offer(kNone, problem.none_cost);
      changed |= best != labels[i];
      labels[i] = best;
      for (const std::uint32_t j : problem.neighbours_of(i)) agreeing[place_of(labels[j])] = 0;
    }
  }
  return labels;
}

}  // namespace planescope
