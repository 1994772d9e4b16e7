// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include "planescope/explain.hpp"
#include "planescope/explain_planes.hpp"

/// \file Explanations as JSON: all that the words say, and more.
namespace planescope {

nlohmann::ordered_json to_json(const EdgeExplanation& explanation);
nlohmann::ordered_json to_json(const Chain& chain);
nlohmann::ordered_json to_json(const ErrorSummary& summary);
nlohmann::ordered_json to_json(const PlaneExplanation& explanation);
nlohmann::ordered_json to_json(const MissingExplanation& explanation);

}  // namespace planescope
