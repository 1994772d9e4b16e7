// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "planes/random.hpp"
#include "planes/solvers.hpp"
#include "planescope/error.hpp"
#include "planescope/planes.hpp"

namespace planescope {
namespace {

TEST(DataCost, IsOneAtNothingZeroAtLambdaAndTendsToMinusOne) {
  EXPECT_DOUBLE_EQ(data_cost(0, 50), 1);
  EXPECT_DOUBLE_EQ(data_cost(25, 50), 0.5);
  EXPECT_DOUBLE_EQ(data_cost(50, 50), 0);
  EXPECT_DOUBLE_EQ(data_cost(100, 50), std::exp(-1.0) - 1);
  EXPECT_NEAR(data_cost(150, 50), -0.8646647, 1e-7);
  EXPECT_NEAR(data_cost(1e6, 50), -1, 1e-12);
}

TEST(DataCost, IsSmoothAtLambda) {
  const double h = 1e-4, left = (data_cost(50, 50) - data_cost(50 - h, 50)) / h,
               right = (data_cost(50 + h, 50) - data_cost(50, 50)) / h;
  EXPECT_NEAR(left, -1.0 / 50, 1e-6);
  EXPECT_NEAR(right, left, 1e-6);
}

Eigen::Vector3f at(double degrees) {
  const double a = degrees * std::acos(-1.0) / 180;
  return {static_cast<float>(std::cos(a)), static_cast<float>(std::sin(a)), 0};
}

TEST(ManhattanDeviation, IsTheLesserOfTheAngleAndItsComplement) {
  EXPECT_NEAR(manhattan_deviation(at(0), at(0)), 0, 1e-5);
  EXPECT_NEAR(manhattan_deviation(at(0), at(10)), 10, 1e-5);
  EXPECT_NEAR(manhattan_deviation(at(0), at(45)), 45, 1e-5);
  EXPECT_NEAR(manhattan_deviation(at(0), at(80)), 10, 1e-5);
  EXPECT_NEAR(manhattan_deviation(at(0), at(90)), 0, 1e-5);
  EXPECT_NEAR(manhattan_deviation(at(0), at(170)), 10, 1e-5);  // normals have no side here
  EXPECT_NEAR(manhattan_deviation(at(0), at(180)), 0, 1e-5);
  EXPECT_NEAR(manhattan_deviation(at(0), at(0.01)), 0.01, 1e-5);
}

TEST(SelectionEnergy, CountsEachPairOnce) {
  const SelectionEnergy energy{{-1, -2, 3}, {0, 0.5, 7, 0.5, 0, 11, 7, 11, 0}};
  EXPECT_DOUBLE_EQ(energy({false, false, false}), 0);
  EXPECT_DOUBLE_EQ(energy({true, false, false}), -1);
  EXPECT_DOUBLE_EQ(energy({true, true, false}), -2.5);
  EXPECT_DOUBLE_EQ(energy({true, true, true}), 18.5);
}

/// Energies like those of rooms: D in (-1, 0.1), half of the pairs in harmony, the others at odds.
SelectionEnergy random_energy(std::mt19937_64& random, std::size_t n) {
  SelectionEnergy energy;
  energy.pairwise.assign(n * n, 0);
  for (std::size_t m = 0; m < n; ++m) {
    energy.unary.push_back(0.1 - 1.1 * uniform_unit(random));
    for (std::size_t k = 0; k < m; ++k) {
      const double scale = uniform_unit(random) < 0.5 ? 0.1 : 1.5;
      energy.pairwise[m * n + k] = energy.pairwise[k * n + m] = scale * uniform_unit(random);
    }
  }
  return energy;
}

/// The least energy by evaluating every subset with operator(): the oracle of the oracle.
double least_energy(const SelectionEnergy& energy) {
  double least = 0;
  for (std::uint32_t code = 0; code < (1u << energy.size()); ++code) {
    std::vector<bool> x(energy.size());
    for (std::size_t m = 0; m < x.size(); ++m) x[m] = ((code >> m) & 1) != 0;
    least = std::min(least, energy(x));
  }
  return least;
}

TEST(Exhaustive, FindsTheLeastOfAllSubsets) {
  std::mt19937_64 random(3);
  for (std::size_t n = 0; n <= 10; ++n) {
    const SelectionEnergy energy = random_energy(random, n);
    const auto x = minimise_selection(energy, PlaneSolver::Exhaustive, 0);
    EXPECT_NEAR(energy(x), least_energy(energy), 1e-12);
  }
}

TEST(Exhaustive, RefusesMoreThan24) {
  std::mt19937_64 random(4);
  try {
    minimise_selection(random_energy(random, 25), PlaneSolver::Exhaustive, 0);
    FAIL() << "25 hypotheses were taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Usage);
    EXPECT_NE(std::string(error.what()).find("25"), std::string::npos);
  }
}

TEST(LsaTrTabu, FindsTheOptimumOf200SmallCases) {
  std::mt19937_64 random(5);
  int lsa_tr_optimal = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const SelectionEnergy energy = random_energy(random, 2 + uniform_index(random, 13));
    const double least = energy(minimise_selection(energy, PlaneSolver::Exhaustive, 0));
    const double first = energy(minimise_selection(energy, PlaneSolver::LsaTr, 0));
    const double better = energy(minimise_selection(energy, PlaneSolver::LsaTrTabu, 3000));
    EXPECT_NEAR(better, least, 1e-9) << "trial " << trial << ", n = " << energy.size();
    EXPECT_GE(first, least - 1e-9);
    EXPECT_LE(better, first + 1e-9);
    lsa_tr_optimal += first < least + 1e-9;
  }
  RecordProperty("lsa_tr_optimal_of_200", lsa_tr_optimal);
  EXPECT_LT(lsa_tr_optimal, 200) << "the cases are too easy to tell the solvers apart";
}

TEST(LsaTr, LowersTheEnergyWithEachStepAndEndsWhereNoFlipPays) {
  std::mt19937_64 random(6);
  for (int trial = 0; trial < 50; ++trial) {
    const SelectionEnergy energy = random_energy(random, 40);
    const SolverRun run = lsa_tr(energy);
    for (std::size_t i = 1; i < run.energies.size(); ++i) {
      EXPECT_LT(run.energies[i], run.energies[i - 1]);
    }
    EXPECT_NEAR(energy(run.x), run.energies.back(), 1e-9);
    for (std::size_t m = 0; m < energy.size(); ++m) {
      std::vector<bool> other = run.x;
      other[m] = !other[m];
      EXPECT_GE(energy(other), energy(run.x) - 1e-9);
    }
  }
}

TEST(TabuSearch, KeepsItsIncrementalEnergyTrue) {
  std::mt19937_64 random(7);
  const SelectionEnergy energy = random_energy(random, 120);
  const SolverRun run = tabu_search(energy, 3000);
  EXPECT_NEAR(energy(run.x), run.energies.back(), 1e-9);
  for (std::size_t i = 1; i < run.energies.size(); ++i) {
    EXPECT_LT(run.energies[i], run.energies[i - 1]);
  }
}

TEST(Solvers, BreakTiesTowardsTheLowerIndex) {
  // Two equal planes that exclude each other.
  const SelectionEnergy energy{{-0.5, -0.5}, {0, 2, 2, 0}};
  const std::vector<bool> first = {true, false};
  EXPECT_EQ(exhaustive_search(energy).x, first);
  EXPECT_EQ(tabu_search(energy, 100).x, first);
  const SelectionEnergy three{{-0.5, -0.5, -0.5}, {0, 2, 2, 2, 0, 2, 2, 2, 0}};
  EXPECT_EQ(tabu_search(three, 100).x, (std::vector<bool>{true, false, false}));
  EXPECT_EQ(exhaustive_search(three).x, (std::vector<bool>{true, false, false}));
}

TEST(Solvers, TakeNoneOneAndAllInHarmony) {
  for (const auto solver : {PlaneSolver::LsaTr, PlaneSolver::LsaTrTabu, PlaneSolver::Exhaustive}) {
    EXPECT_TRUE(minimise_selection({}, solver, 3000).empty());
    EXPECT_EQ(minimise_selection({{-0.3}, {0}}, solver, 3000), std::vector<bool>{true});
    EXPECT_EQ(minimise_selection({{0.3}, {0}}, solver, 3000), std::vector<bool>{false});
    const SelectionEnergy parallel{{-0.3, -0.2, -0.1}, std::vector<double>(9, 0)};
    EXPECT_EQ(minimise_selection(parallel, solver, 3000), std::vector<bool>(3, true));
  }
}

}  // namespace
}  // namespace planescope
