// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

/// \file Four floats at once. SSE2 is what every x86-64 has; elsewhere the same in plain C++, which
/// compilers vectorise as they can. Results are the same: no operation here is fused or reordered.
namespace planescope {

#if defined(__SSE2__)

struct Float4 {
  __m128 v;

  Float4() : v(_mm_setzero_ps()) {}
  Float4(__m128 value) : v(value) {}
  explicit Float4(float value) : v(_mm_set1_ps(value)) {}
  static Float4 load(const float* from) { return _mm_loadu_ps(from); }
  /// Three floats, and 0 in the last lane.
  static Float4 load3(const float* from) {
    const __m128 xy = _mm_castsi128_ps(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(from)));
    return _mm_movelh_ps(xy, _mm_load_ss(from + 2));
  }
  void store(float* to) const { _mm_storeu_ps(to, v); }

  friend Float4 operator+(Float4 a, Float4 b) { return _mm_add_ps(a.v, b.v); }
  friend Float4 operator-(Float4 a, Float4 b) { return _mm_sub_ps(a.v, b.v); }
  friend Float4 operator*(Float4 a, Float4 b) { return _mm_mul_ps(a.v, b.v); }
  friend Float4 operator/(Float4 a, Float4 b) { return _mm_div_ps(a.v, b.v); }
  Float4& operator+=(Float4 b) { return *this = *this + b; }
  friend Float4 max(Float4 a, Float4 b) { return _mm_max_ps(a.v, b.v); }
  friend Float4 min(Float4 a, Float4 b) { return _mm_min_ps(a.v, b.v); }
  /// Towards zero, to whole numbers; lanes beyond 32 bits give any number.
  friend void truncate(Float4 a, std::int32_t* to) {
    _mm_storeu_si128(reinterpret_cast<__m128i*>(to), _mm_cvttps_epi32(a.v));
  }
  friend Float4 abs(Float4 a) { return _mm_andnot_ps(_mm_set1_ps(-0.0f), a.v); }
  /// Comparisons and masks are all bits of a lane, or none.
  friend Float4 operator<(Float4 a, Float4 b) { return _mm_cmplt_ps(a.v, b.v); }
  friend Float4 operator<=(Float4 a, Float4 b) { return _mm_cmple_ps(a.v, b.v); }
  friend Float4 operator>=(Float4 a, Float4 b) { return _mm_cmpge_ps(a.v, b.v); }
  friend Float4 operator&(Float4 a, Float4 b) { return _mm_and_ps(a.v, b.v); }
  friend Float4 operator^(Float4 a, Float4 b) { return _mm_xor_ps(a.v, b.v); }
  /// Bit i is the sign of lane i.
  friend unsigned sign_bits(Float4 a) { return static_cast<unsigned>(_mm_movemask_ps(a.v)); }
  friend Float4 sqrt(Float4 a) { return _mm_sqrt_ps(a.v); }
  /// Lanes of a where the mask is set, else of b.
  friend Float4 select(Float4 mask, Float4 a, Float4 b) {
    return _mm_or_ps(_mm_and_ps(mask.v, a.v), _mm_andnot_ps(mask.v, b.v));
  }
  friend Float4 yzxw(Float4 a) { return _mm_shuffle_ps(a.v, a.v, _MM_SHUFFLE(3, 0, 2, 1)); }
  friend Float4 wwww(Float4 a) { return _mm_shuffle_ps(a.v, a.v, _MM_SHUFFLE(3, 3, 3, 3)); }
  friend void transpose(Float4& a, Float4& b, Float4& c, Float4& d) {
    _MM_TRANSPOSE4_PS(a.v, b.v, c.v, d.v);
  }
};

#else

struct Float4 {
  float v[4] = {0, 0, 0, 0};

  Float4() = default;
  explicit Float4(float value) : v{value, value, value, value} {}
  static Float4 load(const float* from) {
    Float4 a;
    std::memcpy(a.v, from, sizeof a.v);
    return a;
  }
  static Float4 load3(const float* from) {
    Float4 a;
    std::memcpy(a.v, from, 3 * sizeof(float));
    return a;
  }
  void store(float* to) const { std::memcpy(to, v, sizeof v); }

  template <typename F>
  static Float4 each(Float4 a, Float4 b, F f) {
    for (int i = 0; i < 4; ++i) a.v[i] = f(a.v[i], b.v[i]);
    return a;
  }
  template <typename F>
  static Float4 bits(Float4 a, Float4 b, F f) {
    return each(a, b, [f](float s, float t) {
      std::uint32_t x, y;
      std::memcpy(&x, &s, sizeof x), std::memcpy(&y, &t, sizeof y);
      x = f(x, y);
      std::memcpy(&s, &x, sizeof x);
      return s;
    });
  }
  static float mask(bool set) {
    const std::uint32_t x = set ? 0xFFFFFFFFu : 0;
    float f;
    std::memcpy(&f, &x, sizeof x);
    return f;
  }
  friend Float4 operator+(Float4 a, Float4 b) {
    return each(a, b, [](float s, float t) { return s + t; });
  }
  friend Float4 operator-(Float4 a, Float4 b) {
    return each(a, b, [](float s, float t) { return s - t; });
  }
  friend Float4 operator*(Float4 a, Float4 b) {
    return each(a, b, [](float s, float t) { return s * t; });
  }
  friend Float4 operator/(Float4 a, Float4 b) {
    return each(a, b, [](float s, float t) { return s / t; });
  }
  Float4& operator+=(Float4 b) { return *this = *this + b; }
  friend Float4 max(Float4 a, Float4 b) {
    return each(a, b, [](float s, float t) { return s > t ? s : t; });
  }
  friend Float4 min(Float4 a, Float4 b) {
    return each(a, b, [](float s, float t) { return s < t ? s : t; });
  }
  friend void truncate(Float4 a, std::int32_t* to) {
    for (int i = 0; i < 4; ++i) to[i] = static_cast<std::int32_t>(a.v[i]);
  }
  friend Float4 abs(Float4 a) {
    return each(a, a, [](float s, float) { return std::abs(s); });
  }
  friend Float4 operator<(Float4 a, Float4 b) {
    return each(a, b, [](float s, float t) { return mask(s < t); });
  }
  friend Float4 operator<=(Float4 a, Float4 b) {
    return each(a, b, [](float s, float t) { return mask(s <= t); });
  }
  friend Float4 operator>=(Float4 a, Float4 b) {
    return each(a, b, [](float s, float t) { return mask(s >= t); });
  }
  friend Float4 operator&(Float4 a, Float4 b) {
    return bits(a, b, [](std::uint32_t s, std::uint32_t t) { return s & t; });
  }
  friend Float4 operator^(Float4 a, Float4 b) {
    return bits(a, b, [](std::uint32_t s, std::uint32_t t) { return s ^ t; });
  }
  friend unsigned sign_bits(Float4 a) {
    unsigned result = 0;
    for (unsigned i = 0; i < 4; ++i) result |= std::signbit(a.v[i]) ? 1u << i : 0u;
    return result;
  }
  friend Float4 sqrt(Float4 a) {
    return each(a, a, [](float s, float) { return std::sqrt(s); });
  }
  friend Float4 select(Float4 mask, Float4 a, Float4 b) {
    for (int i = 0; i < 4; ++i) a.v[i] = std::signbit(mask.v[i]) ? a.v[i] : b.v[i];
    return a;
  }
  friend Float4 yzxw(Float4 a) {
    Float4 r;
    r.v[0] = a.v[1], r.v[1] = a.v[2], r.v[2] = a.v[0], r.v[3] = a.v[3];
    return r;
  }
  friend Float4 wwww(Float4 a) { return Float4(a.v[3]); }
  friend void transpose(Float4& a, Float4& b, Float4& c, Float4& d) {
    Float4* rows[4] = {&a, &b, &c, &d};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j) std::swap(rows[i]->v[j], rows[j]->v[i]);
  }
};

#endif

/// True if the first three lanes are finite.
inline bool is_finite3(Float4 a) {
  const Float4 zero_or_nan = a - a;
  return (sign_bits(zero_or_nan >= Float4(0.0f)) & 7) == 7;
}

/// The four lanes, added in their order.
inline float sum(Float4 a) {
  float lanes[4];
  a.store(lanes);
  return lanes[0] + lanes[1] + lanes[2] + lanes[3];
}

/// All bits of lane i where bit i of `bits` (0 to 15) is set.
inline Float4 lane_mask(unsigned bits) {
#if defined(__SSE2__)
  const __m128i lanes = _mm_set_epi32(8, 4, 2, 1);
  const __m128i set = _mm_and_si128(_mm_set1_epi32(static_cast<int>(bits)), lanes);
  return _mm_castsi128_ps(_mm_cmpeq_epi32(set, lanes));
#else
  Float4 mask;
  for (unsigned i = 0; i < 4; ++i) mask.v[i] = Float4::mask((bits >> i & 1u) != 0);
  return mask;
#endif
}

}  // namespace planescope
