// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "simd.hpp"

namespace planescope {
namespace {

using Lanes = std::array<float, 4>;

Lanes lanes(Float4 a) {
  Lanes result{};
  a.store(result.data());
  return result;
}

TEST(Float4, EachLaneDoesWhatAFloatDoes) {
  const Lanes a = {1.5f, -2.25f, 0.1f, 7.0f}, b = {-3.0f, -2.25f, 0.3f, 0.7f};
  const Float4 x = Float4::load(a.data()), y = Float4::load(b.data());
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(lanes(x + y)[i], a[i] + b[i]);
    EXPECT_EQ(lanes(x - y)[i], a[i] - b[i]);
    EXPECT_EQ(lanes(x * y)[i], a[i] * b[i]);
    EXPECT_EQ(lanes(x / y)[i], a[i] / b[i]);
    EXPECT_EQ(lanes(max(x, y))[i], std::max(a[i], b[i]));
    EXPECT_EQ(lanes(min(x, y))[i], std::min(a[i], b[i]));
    EXPECT_EQ(lanes(abs(x))[i], std::abs(a[i]));
    EXPECT_EQ(lanes(sqrt(abs(x)))[i], std::sqrt(std::abs(a[i])));
    EXPECT_EQ(lanes(select(x < y, x, y))[i], a[i] < b[i] ? a[i] : b[i]);
    EXPECT_EQ(sign_bits(x < y) >> i & 1, a[i] < b[i] ? 1u : 0u);
    EXPECT_EQ(sign_bits(x <= y) >> i & 1, a[i] <= b[i] ? 1u : 0u);
    EXPECT_EQ(sign_bits(x >= y) >> i & 1, a[i] >= b[i] ? 1u : 0u);
    EXPECT_EQ(lanes(x ^ (y & Float4(-0.0f)))[i], b[i] < 0 ? -a[i] : a[i]);
  }
  EXPECT_EQ(sum(x), 1.5f + -2.25f + 0.1f + 7.0f);
  std::array<std::int32_t, 4> whole{};
  truncate(x, whole.data());
  EXPECT_EQ(whole, (std::array<std::int32_t, 4>{1, -2, 0, 7}));
}

TEST(Float4, MovesLanes) {
  const Lanes a = {1, 2, 3, 4};
  const Float4 x = Float4::load(a.data());
  EXPECT_EQ(lanes(Float4::load3(a.data())), (Lanes{1, 2, 3, 0}));
  EXPECT_EQ(lanes(yzxw(x)), (Lanes{2, 3, 1, 4}));
  EXPECT_EQ(lanes(wwww(x)), (Lanes{4, 4, 4, 4}));
  Float4 r0 = x, r1 = x * Float4(10), r2 = x * Float4(100), r3 = x * Float4(1000);
  transpose(r0, r1, r2, r3);
  EXPECT_EQ(lanes(r1), (Lanes{2, 20, 200, 2000}));
  EXPECT_EQ(lanes(r3), (Lanes{4, 40, 400, 4000}));
  for (unsigned bits = 0; bits < 16; ++bits) {
    EXPECT_EQ(sign_bits(lane_mask(bits)), bits);
    EXPECT_EQ(lanes(lane_mask(bits) & x)[2], (bits & 4) != 0 ? 3.0f : 0.0f);
  }
}

TEST(Float4, KnowsWhatIsFinite) {
  const float infinity = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(is_finite3(Float4::load(Lanes{0, -1e30f, 3e38f, nan}.data())));
  for (const float bad : {infinity, -infinity, nan}) {
    EXPECT_FALSE(is_finite3(Float4::load(Lanes{bad, 1, 2, 3}.data())));
    EXPECT_FALSE(is_finite3(Float4::load(Lanes{1, bad, 2, 3}.data())));
    EXPECT_FALSE(is_finite3(Float4::load(Lanes{1, 2, bad, 3}.data())));
  }
}

}  // namespace
}  // namespace planescope
