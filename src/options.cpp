// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/options.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "nearest_name.hpp"
#include "options_table.hpp"
#include "planescope/error.hpp"

namespace planescope {
namespace {

template <class... Ts>
struct Overloaded : Ts... {
  using Ts::operator()...;
};
template <class... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;  // clang 14 cannot deduce it for aggregates

[[noreturn]] void usage(const std::string& message) { throw Error(Error::Kind::Usage, message); }

/// Shortest text that reads back to the same value: locale-independent, the same everywhere.
template <class Number>
std::string text(Number value) {
  char buffer[32];
  if constexpr (std::is_floating_point_v<Number>) {  // 0.0001 rather than 1e-04, where it fits
    const auto [end, failure] =
        std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed);
    if (failure == std::errc()) return {buffer, end};
  }
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

std::string join(std::span<const std::string_view> names) {
  std::string all;
  for (const std::string_view name : names) all += (all.empty() ? "" : " | ") + std::string(name);
  return all;
}

std::string range(const OptionEntry& entry) {
  return std::visit(
      Overloaded{[](OptionMember<bool>) -> std::string { return "true | false"; },
                 [](OptionMember<std::uint64_t>) { return "0 to " + text(~std::uint64_t{0}); },
                 [](const OptionChoice& choice) { return join(choice.names); },
                 [&](auto) { return text(entry.low) + " to " + text(entry.high); }},
      entry.member);
}

std::string with_unit(const OptionEntry& entry) {
  const bool measured = entry.unit == "m" || entry.unit == "deg" || entry.unit == "m^2";
  return range(entry) + (measured ? " " + std::string(entry.unit) : "");
}

const OptionEntry& find(std::string_view name) {
  const auto entries = option_entries();
  const auto found = std::ranges::find(entries, name, &OptionEntry::name);
  if (found != entries.end()) return *found;
  std::vector<std::string> names;
  for (const OptionEntry& entry : entries) names.emplace_back(entry.name);
  usage("there is no option `" + std::string(name) + "`; did you mean `" +
        nearest_name(name, names) + "`?");
}

[[noreturn]] void refuse(const OptionEntry& entry, std::string_view value) {
  usage(std::string(entry.name) + " is `" + std::string(value) + "`; it takes " + with_unit(entry));
}

template <class Number>
Number parse(const OptionEntry& entry, std::string_view value) {
  Number number{};
  const char* end = value.data() + value.size();
  const auto [stop, failure] = std::from_chars(value.data(), end, number);
  if (failure != std::errc() || stop != end) refuse(entry, value);
  return number;
}

template <class Number>
void check(const OptionEntry& entry, Number number) {
  const auto value = static_cast<double>(number);
  if (!(value >= entry.low && value <= entry.high)) refuse(entry, text(number));  // NaN too
}

bool parse_flag(const OptionEntry& entry, std::string_view value) {
  if (value == "true" || value == "1" || value == "on") return true;
  if (value == "false" || value == "0" || value == "off") return false;
  refuse(entry, value);
}

/// What no single range can say.
void check_together(const Options& o) {
  if (!(o.patches.patch_size > o.patches.voxel_size)) {
    usage("patches.patch_size is " + text(o.patches.patch_size) +
          " m; it must be more than patches.voxel_size, " + text(o.patches.voxel_size) +
          " m: raise the one or lower the other");
  }
  if (o.patches.weight_color + o.patches.weight_spatial + o.patches.weight_normal <= 0) {
    usage(
        "patches.weight_color, weight_spatial and weight_normal are all 0; "
        "patches cannot grow: give one of them a weight");
  }
  if (o.planes.solver == PlaneSolver::Exhaustive && o.planes.max_hypotheses > 24) {
    usage("planes.max_hypotheses is " + text(o.planes.max_hypotheses) +
          "; planes.solver exhaustive takes at most 24: lower it, or take lsa_tr+tabu");
  }
}

}  // namespace

Options Options::room() { return {}; }

Options Options::tabletop() {
  Options options;
  options.patches.voxel_size = 0.0075;
  options.patches.patch_size = 0.03;
  options.planes.sigma = 0.01;
  // A table top, not the face of a box on it.
  options.planes.min_area = 0.1;
  options.planes.face_area = 0.002;
  return options;
}

void Options::validate() const {
  Options copy = *this;  // the table's accessors are for writing too
  for (const OptionEntry& entry : option_entries()) {
    std::visit(Overloaded{[&](OptionMember<double> member) { check(entry, member(copy)); },
                          [&](OptionMember<std::uint32_t> member) { check(entry, member(copy)); },
                          [&](const OptionChoice& choice) {
                            const int index = choice.get(copy);
                            const bool known = index >= 0 && index < std::ssize(choice.names);
                            if (!known) refuse(entry, text(index));
                          },
                          [](auto) {}},
               entry.member);
  }
  check_together(*this);
}

std::vector<OptionInfo> option_table() {
  std::vector<OptionInfo> table;
  for (const OptionEntry& entry : option_entries()) {
    table.push_back({std::string(entry.name), std::string(entry.unit), range(entry),
                     std::string(entry.meaning)});
  }
  return table;
}

void set_option(Options& options, std::string_view name, std::string_view value) {
  const OptionEntry& entry = find(name);
  std::visit(
      Overloaded{[&](OptionMember<bool> member) { member(options) = parse_flag(entry, value); },
                 [&](OptionMember<std::uint64_t> member) {
                   member(options) = parse<std::uint64_t>(entry, value);
                 },
                 [&](const OptionChoice& choice) {
                   const auto found = std::ranges::find(choice.names, value);
                   if (found == choice.names.end()) refuse(entry, value);
                   choice.set(options, static_cast<int>(found - choice.names.begin()));
                 },
                 [&]<class Number>(OptionMember<Number> member) {
                   const auto number = parse<Number>(entry, value);
                   check(entry, number);
                   member(options) = number;
                 }},
      entry.member);
}

std::string get_option(const Options& options, std::string_view name) {
  Options copy = options;
  return std::visit(
      Overloaded{
          [&](OptionMember<bool> member) -> std::string { return member(copy) ? "true" : "false"; },
          [&](const OptionChoice& choice) {
            return std::string(choice.names[static_cast<std::size_t>(choice.get(copy))]);
          },
          [&](auto member) { return text(member(copy)); }},
      find(name).member);
}

}  // namespace planescope
