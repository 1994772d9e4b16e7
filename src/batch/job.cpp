// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "batch/job.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/whole_file.hpp"
#include "json_file.hpp"
#include "planescope/error.hpp"
#include "planescope/result.hpp"

namespace planescope {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
constexpr int kPlanSchema = 1;
constexpr std::size_t kMaxMethods = 64;
constexpr const char* kHint = "name the folder of a batch, or run it again";

std::string dump(const Json& json) {
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";  // names need no UTF-8
}

/// 64-bit FNV-1a, as hexadecimal digits.
std::string hash_text(const std::string& text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

/// The contents of --config FILE count, not its name alone.
std::string hash_configuration(const std::vector<std::string>& arguments) {
  constexpr std::string_view kFlag = "--config=";
  for (const std::string& argument : arguments)
    if (argument.starts_with(kFlag)) return hash_file(argument.substr(kFlag.size()));
  return "";
}

std::string hash_regular(const fs::path& file) {
  std::error_code failure;
  if (file.empty() || !fs::is_regular_file(file, failure)) return "none";
  return hash_file(file);
}

}  // namespace

std::string BatchPlan::settings_key(const std::string& method) const {
  std::string text = std::string(PLANESCOPE_VERSION) + "\n" + method + "\n";
  for (const auto& words : {segment_arguments, evaluate_arguments}) {
    for (const std::string& word : words) text += word + "\n";
    text += "\n";
  }
  return hash_text(text + hash_configuration(segment_arguments) + (scored ? "scored" : ""));
}

void write_plan(const BatchPlan& plan, const fs::path& folder) {
  Json scenes = Json::array(), methods = Json::array();
  for (const BatchScene& scene : plan.scenes) {
    scenes.push_back({{"name", scene.name},
                      {"file", scene.file.string()},
                      {"truth", plan.scored ? Json(scene.truth.string()) : Json()}});
  }
  for (const std::string& method : plan.methods) {
    methods.push_back({{"name", method}, {"settings_key", plan.settings_key(method)}});
  }
  const Json all = {{"schema", kPlanSchema},
                    {"planescope", PLANESCOPE_VERSION},
                    {"segment_arguments", plan.segment_arguments},
                    {"evaluate_arguments", plan.evaluate_arguments},
                    {"methods", methods},
                    {"scenes", scenes}};
  write_whole(folder / "batch.json", dump(all));
}

StoredPlan read_plan(const fs::path& folder) try {
  const nlohmann::json all = read_json(folder / "batch.json", kHint);
  if (all.at("schema") != kPlanSchema) throw std::out_of_range("schema");
  StoredPlan plan;
  for (const auto& method : all.at("methods")) plan.methods.push_back(method.at("name"));
  if (plan.methods.size() > kMaxMethods) throw std::out_of_range("methods");
  for (const auto& scene : all.at("scenes")) {
    plan.scenes.push_back(scene.at("name"));
    for (const auto& method : all.at("methods")) {
      plan.jobs.push_back({plan.scenes.back(), method.at("name"), method.at("settings_key")});
    }
  }
  if (!std::ranges::all_of(plan.scenes, is_folder_name) ||
      !std::ranges::all_of(plan.methods, is_folder_name))
    throw std::out_of_range("names");
  return plan;
} catch (const Error&) {
  throw;
} catch (const std::exception&) {
  throw Error(Error::Kind::Input,
              (folder / "batch.json").string() + ": malformed; " + std::string(kHint));
}

bool is_folder_name(const std::string& name) {
  return !name.empty() && !name.starts_with('.') && name.find('/') == std::string::npos &&
         name.find('\0') == std::string::npos;
}

fs::path job_folder(const fs::path& folder, const std::string& scene, const std::string& method) {
  return folder / scene / method;
}

void write_record(const JobRecord& record, const fs::path& job_folder) {
  const Json all = {{"settings_key", record.settings_key},
                    {"input_key", record.input_key},
                    {"done", record.done},
                    {"reason", record.reason},
                    {"peak_memory_mb", record.peak_memory_mb},
                    {"measures", record.values}};
  write_whole(job_folder / "job.json", dump(all));
}

std::optional<JobRecord> read_record(const fs::path& job_folder) try {
  std::error_code ignored;
  if (!fs::exists(job_folder / "job.json", ignored)) return std::nullopt;
  const nlohmann::json all = read_json(job_folder / "job.json", kHint);
  return JobRecord{all.at("settings_key"), all.at("input_key"),      all.at("done"),
                   all.at("reason"),       all.at("peak_memory_mb"), all.at("measures")};
} catch (const std::exception&) {  // a record that cannot be read is none: the job is done again
  return std::nullopt;
}

std::string input_key(const BatchScene& scene) {
  std::string key = hash_regular(scene.file);
  key += '-';
  key += scene.truth == scene.file ? "same" : hash_regular(scene.truth);
  key += '-';
  return key + hash_regular(scene.truth_planes);
}

}  // namespace planescope
