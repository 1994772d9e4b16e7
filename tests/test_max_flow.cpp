// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/push_relabel_max_flow.hpp>

#include "planes/max_flow.hpp"
#include "planes/random.hpp"

namespace planescope {
namespace {

struct Network {
  struct Edge {
    std::uint32_t a, b;
    std::int32_t forward, backward;
  };
  std::vector<std::int64_t> source, sink;
  std::vector<Edge> edges;

  /// The capacity from the nodes with in[i], and the source, to all others.
  std::int64_t cut(const std::vector<bool>& in) const {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < source.size(); ++i) sum += in[i] ? sink[i] : source[i];
    for (const Edge& e : edges) {
      if (in[e.a] && !in[e.b]) sum += e.forward;
      if (in[e.b] && !in[e.a]) sum += e.backward;
    }
    return sum;
  }
};

Network random_network(std::mt19937_64& random, std::size_t nodes, std::size_t edges,
                       std::uint64_t largest) {
  const auto capacity = [&] { return static_cast<std::int32_t>(uniform_index(random, largest)); };
  Network net;
  for (std::size_t i = 0; i < nodes; ++i) {  // a third each: at the source, at the sink, at both
    const std::uint64_t kind = uniform_index(random, 3);
    net.source.push_back(kind == 1 ? 0 : 2 * capacity());
    net.sink.push_back(kind == 0 ? 0 : 2 * capacity());
  }
  for (std::size_t k = 0; k < edges && nodes > 1; ++k) {
    const auto a = static_cast<std::uint32_t>(uniform_index(random, nodes));
    const auto step = static_cast<std::uint32_t>(1 + uniform_index(random, nodes - 1));
    const auto b = static_cast<std::uint32_t>((a + step) % nodes);
    net.edges.push_back({a, b, capacity(), uniform_index(random, 2) == 0 ? 0 : capacity()});
  }
  return net;
}

std::int64_t solve(MaxFlow& flow, const Network& net) {
  flow.reset(net.source.size());
  for (std::uint32_t i = 0; i < net.source.size(); ++i) {
    flow.add_terminal(i, net.source[i], net.sink[i]);
  }
  for (const auto& e : net.edges) flow.add_edge(e.a, e.b, e.forward, e.backward);
  return flow.solve();
}

std::vector<bool> source_side(const MaxFlow& flow, std::size_t nodes) {
  std::vector<bool> in(nodes);
  for (std::uint32_t i = 0; i < nodes; ++i) in[i] = flow.on_source_side(i);
  return in;
}

TEST(MaxFlow, SolvesAChainByHand) {
  MaxFlow flow;
  flow.reset(3);
  flow.add_terminal(0, 10, 0);
  flow.add_terminal(2, 0, 7);
  flow.add_edge(0, 1, 5, 0);
  flow.add_edge(1, 2, 4, 0);
  EXPECT_EQ(flow.solve(), 4);
  EXPECT_TRUE(flow.on_source_side(0));
  EXPECT_TRUE(flow.on_source_side(1));
  EXPECT_FALSE(flow.on_source_side(2));
}

TEST(MaxFlow, PassesThroughOneNodeAndAddsUp) {
  MaxFlow flow;
  flow.reset(1);
  flow.add_terminal(0, 3, 1);
  flow.add_terminal(0, 0, 5);
  EXPECT_EQ(flow.solve(), 3);
  EXPECT_FALSE(flow.on_source_side(0));
}

TEST(MaxFlow, OfNothingIsZero) {
  MaxFlow flow;
  flow.reset(0);
  EXPECT_EQ(flow.solve(), 0);
}

/// Value and cut against all 2^n cuts; the source side has to be the smallest of the minimum ones.
TEST(MaxFlow, EqualsTheLeastOfAllCuts) {
  std::mt19937_64 random(1);
  MaxFlow flow;
  for (int trial = 0; trial < 400; ++trial) {
    const std::size_t nodes = 1 + uniform_index(random, 9);
    const Network net = random_network(random, nodes, 3 * nodes, trial % 2 == 0 ? 4 : 1000);
    const std::int64_t value = solve(flow, net);
    const std::vector<bool> side = source_side(flow, nodes);
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    std::vector<bool> common(nodes, true), in(nodes);
    for (std::uint32_t code = 0; code < (1u << nodes); ++code) {
      for (std::size_t i = 0; i < nodes; ++i) in[i] = ((code >> i) & 1) != 0;
      const std::int64_t cut = net.cut(in);
      if (cut < least) least = cut, common.assign(nodes, true);
      for (std::size_t i = 0; i < nodes && cut == least; ++i) common[i] = common[i] && in[i];
    }
    EXPECT_EQ(value, least) << "trial " << trial;
    EXPECT_EQ(net.cut(side), least) << "trial " << trial;
    EXPECT_EQ(side, common) << "trial " << trial;
  }
}

/// Another algorithm by other people: Boost.Graph's push-relabel.
std::int64_t push_relabel(const Network& net) {
  using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
  using Graph = boost::adjacency_list<
      boost::vecS, boost::vecS, boost::directedS, boost::no_property,
      boost::property<
          boost::edge_capacity_t, std::int64_t,
          boost::property<boost::edge_residual_capacity_t, std::int64_t,
                          boost::property<boost::edge_reverse_t, Traits::edge_descriptor>>>>;
  const std::size_t n = net.source.size();
  Graph graph(n + 2);
  auto capacity = boost::get(boost::edge_capacity, graph);
  auto reverse = boost::get(boost::edge_reverse, graph);
  const auto add = [&](std::size_t a, std::size_t b, std::int64_t there, std::int64_t back) {
    const auto e = boost::add_edge(a, b, graph).first, r = boost::add_edge(b, a, graph).first;
    capacity[e] = there, capacity[r] = back;
    reverse[e] = r, reverse[r] = e;
  };
  for (std::size_t i = 0; i < n; ++i) {
    add(n, i, net.source[i], 0);
    add(i, n + 1, net.sink[i], 0);
  }
  for (const auto& e : net.edges) add(e.a, e.b, e.forward, e.backward);
  return boost::push_relabel_max_flow(graph, n, n + 1);
}

TEST(MaxFlow, EqualsPushRelabelOnRandomGraphs) {
  std::mt19937_64 random(2);
  MaxFlow flow;
  for (int trial = 0; trial < 100; ++trial) {
    const std::size_t nodes = 2 + uniform_index(random, 400);
    const std::size_t edges = nodes * (1 + uniform_index(random, 6));
    const Network net = random_network(random, nodes, edges, trial % 2 == 0 ? 10 : 100000);
    const std::int64_t value = solve(flow, net);
    EXPECT_EQ(value, push_relabel(net)) << "trial " << trial;
    EXPECT_EQ(net.cut(source_side(flow, nodes)), value) << "trial " << trial;
  }
}

/// Long paths, where trees are deep and orphans many: a grid with terminals at opposite sides.
TEST(MaxFlow, EqualsPushRelabelOnGrids) {
  std::mt19937_64 random(8);
  MaxFlow flow;
  constexpr std::uint32_t kSide = 24;
  for (int trial = 0; trial < 20; ++trial) {
    Network net;
    net.source.assign(kSide * kSide, 0);
    net.sink.assign(kSide * kSide, 0);
    for (std::uint32_t i = 0; i < kSide; ++i) {
      net.source[i] = 1000;
      net.sink[kSide * kSide - 1 - i] = 1000;
    }
    const auto capacity = [&] { return static_cast<std::int32_t>(uniform_index(random, 20)); };
    for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
      if (i % kSide + 1 < kSide) net.edges.push_back({i, i + 1, capacity(), capacity()});
      if (i / kSide + 1 < kSide) net.edges.push_back({i, i + kSide, capacity(), capacity()});
    }
    const std::int64_t value = solve(flow, net);
    EXPECT_EQ(value, push_relabel(net)) << "trial " << trial;
    EXPECT_EQ(net.cut(source_side(flow, net.source.size())), value) << "trial " << trial;
  }
}

}  // namespace
}  // namespace planescope
