// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "batch/scene_list.hpp"

#include <glob.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>

#include "planescope/error.hpp"

namespace planescope {
namespace {

namespace fs = std::filesystem;

bool is_cloud(const fs::path& file) {
  return file.extension() == ".pcd" || file.extension() == ".ply";
}

std::vector<fs::path> expand(const std::string& pattern) {
  glob_t found{};
  std::vector<fs::path> files;
  if (::glob(pattern.c_str(), 0, nullptr, &found) == 0)
    files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  ::globfree(&found);
  if (files.empty())
    throw Error(Error::Kind::Input,
                pattern + ": no such file; name clouds, a glob that matches some, or a list");
  return files;
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

std::vector<BatchScene> read_list(const fs::path& file) {
  std::ifstream in(file);
  std::error_code ignored;
  if (!in || fs::is_directory(file, ignored))
    throw Error(Error::Kind::Input, file.string() + ": cannot be read as a list of scenes");
  std::vector<BatchScene> scenes;
  for (std::string line; std::getline(in, line);) {
    if (line.find('\0') != std::string::npos)
      throw Error(Error::Kind::Input, file.string() + ": is no text; clouds end in .pcd or .ply");
    line = trimmed(line.substr(0, line.find('#')));
    if (line.empty()) continue;
    const auto tab = line.find('\t');
    const fs::path scene = file.parent_path() / trimmed(line.substr(0, tab));
    const fs::path truth =
        tab == std::string::npos ? scene : file.parent_path() / trimmed(line.substr(tab));
    scenes.push_back({"", scene, truth, {}});
  }
  return scenes;
}

/// A name of a folder: never hidden, and never "." or "..".
std::string visible(const std::string& name) { return name.starts_with('.') ? "_" + name : name; }

/// The name without its ending where that is unique, else the whole path as one word.
void name_scenes(std::vector<BatchScene>& scenes) {
  std::map<std::string, int> uses;
  for (const BatchScene& scene : scenes) ++uses[visible(scene.file.stem().string())];
  std::set<std::string> taken;
  for (BatchScene& scene : scenes) {
    scene.name = visible(scene.file.stem().string());
    if (uses[scene.name] > 1) {
      scene.name = fs::absolute(scene.file).lexically_normal().relative_path().string();
      std::ranges::replace(scene.name, '/', '_');
      scene.name = visible(scene.name);
    }
    while (!taken.insert(scene.name).second) scene.name += "_";  // a/b_c.ply and a_b/c.ply
  }
}

std::optional<std::uint32_t> whole_number(const std::string& text) {
  std::uint32_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, value);
  if (failure != std::errc() || stop != end) return std::nullopt;
  return value;
}

/// A whole number from the environment; `fallback` where the variable is not set.
std::optional<std::uint32_t> environment(const char* name, std::optional<std::uint32_t> fallback) {
  const char* text = std::getenv(name);
  if (text == nullptr || *text == '\0') return fallback;
  const auto value = whole_number(text);
  if (!value)
    throw Error(Error::Kind::Usage, std::string(name) + " is `" + text +
                                        "`; expected a whole number; name the shard by --shard");
  return value;
}

Shard checked(std::uint32_t index, std::uint32_t count, const std::string& where) {
  if (count == 0 || index >= count)
    throw Error(Error::Kind::Usage, where + ": shard " + std::to_string(index) + " of " +
                                        std::to_string(count) +
                                        "; it takes I/N with 0 <= I < N, such as 0/3");
  return {index, count};
}

}  // namespace

std::vector<BatchScene> read_scenes(const std::vector<std::string>& arguments) {
  std::vector<BatchScene> all;
  std::error_code ignored;  // names may be too long to be looked for
  const auto add = [&](BatchScene scene) {
    const auto same = [&](const BatchScene& other) { return other.file == scene.file; };
    if (std::ranges::none_of(all, same)) all.push_back(std::move(scene));
  };
  for (const std::string& argument : arguments) {
    const bool pattern = argument.find_first_of("*?[") != std::string::npos;
    if (pattern && !fs::exists(argument, ignored)) {
      for (const fs::path& file : expand(argument)) add({"", file, file, {}});
    } else if (is_cloud(argument)) {
      add({"", argument, argument, {}});
    } else {
      for (const BatchScene& scene : read_list(argument)) add(scene);
    }
  }
  if (all.empty())
    throw Error(Error::Kind::Input, arguments.front() + ": names no scene; expected a line each");
  for (BatchScene& scene : all) {
    const fs::path planes = fs::path(scene.file).replace_extension(".truth.json");
    if (fs::exists(planes, ignored)) scene.truth_planes = planes;
  }
  name_scenes(all);
  return all;
}

Shard parse_shard(const std::string& text) {
  const auto slash = text.find('/');
  const auto index = whole_number(text.substr(0, slash));
  const auto count =
      slash == std::string::npos ? std::nullopt : whole_number(text.substr(slash + 1));
  if (!index || !count)
    throw Error(Error::Kind::Usage, "--shard is `" + text + "`; it takes I/N, such as 0/3");
  return checked(*index, *count, "--shard");
}

Shard shard_from_environment() {
  if (const auto task = environment("SLURM_ARRAY_TASK_ID", std::nullopt)) {
    const std::uint32_t first = *environment("SLURM_ARRAY_TASK_MIN", 0);
    const std::uint32_t step = std::max(1U, *environment("SLURM_ARRAY_TASK_STEP", 1));
    return checked((*task - first) / step, *environment("SLURM_ARRAY_TASK_COUNT", 1),
                   "SLURM_ARRAY_TASK_ID");
  }
  if (const auto rank = environment("OMPI_COMM_WORLD_RANK", std::nullopt))
    return checked(*rank, *environment("OMPI_COMM_WORLD_SIZE", 1), "OMPI_COMM_WORLD_RANK");
  return {};
}

}  // namespace planescope
