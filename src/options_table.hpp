// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <variant>

#include "planescope/options.hpp"

/// \file The one table of options. Validation, JSON, TOML, command line and help are all read off
/// it, so that an option that is added here is everywhere.
namespace planescope {

/// A member of Options that holds a number or a flag.
template <class T>
using OptionMember = T& (*)(Options&);

/// A member of Options that is an enumeration, by the index of its value.
struct OptionChoice {
  std::span<const std::string_view> names;  ///< index = value of the enumeration
  int (*get)(Options&);
  void (*set)(Options&, int);
};

/// One option: how it is called, what it takes, what it means, and where it lives.
struct OptionEntry {
  std::string_view name;     ///< `planes.sigma`
  std::string_view unit;     ///< as in OptionInfo
  double low = 0, high = 0;  ///< inclusive; unused for choices, flags and random_seed
  std::string_view meaning;
  std::variant<OptionMember<double>, OptionMember<std::uint32_t>, OptionMember<std::uint64_t>,
               OptionMember<bool>, OptionChoice>
      member;
};

/// All entries, in the order of the structs.
std::span<const OptionEntry> option_entries();

}  // namespace planescope
