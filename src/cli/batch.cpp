// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "batch/run_batch.hpp"
#include "batch/table.hpp"
#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/engine_arguments.hpp"
#include "cli/method_arguments.hpp"
#include "cli/truth_arguments.hpp"
#include "planescope/error.hpp"

namespace planescope::cli {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  Console console;
  EngineArguments engine;
  MethodArguments peers;
  TruthArguments truth;
  CLI::App* command = nullptr;
  std::vector<std::string> lists;
  fs::path folder, summary;
  std::string methods = "ransac,lccp,cpc,ours", shard, program;
  bool no_scores = false, pictures = false, fresh = false;
  BatchRun run;
};

/// What was given of some groups of options, for another run of this program.
std::vector<std::string> words_of(const CLI::App& command, const std::vector<std::string>& groups) {
  std::vector<std::string> words;
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0 || std::ranges::find(groups, option->get_group()) == groups.end())
      continue;
    words.push_back("--" + option->get_lnames().front() + "=" + option->results().front());
  }
  return words;
}

/// This program itself, wherever it lies.
std::string own_path() { return fs::read_symlink("/proc/self/exe").string(); }

/// 80 % of the machine's memory, shared by the jobs.
std::uint64_t default_memory_mb(std::uint32_t jobs) {
  const auto pages = static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES));
  const auto page = static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  return (pages * page >> 20) * 8 / 10 / jobs;
}

std::string left(const BatchState& state) {
  std::string text = std::to_string(state.ended()) + " of " + std::to_string(state.jobs);
  if (state.seconds_left() > 0) text += ", " + duration(1000 * state.seconds_left()) + " left";
  return text;
}

BatchProgress follow(const Console& console) {
  return [&console, bar = console.progress()](const BatchState& state, const std::string& failure) {
    if (!failure.empty()) console.say(failure);
    const double all = std::max<double>(1, static_cast<double>(state.jobs));
    if (bar) bar(left(state), static_cast<double>(state.ended()) / all);
  };
}

/// Prints the table; files only where all of the batch is told.
void report(const Arguments& a, const fs::path& folder) {
  const BatchTable table = summarise(folder);
  write_table(table, folder);
  std::fputs((a.console.json ? to_json(table) : to_markdown(table)).c_str(), stdout);
  if (table.failures.empty()) return;
  const TableFailure& first = table.failures.front();
  throw Error(Error::Kind::Mismatch,
              std::to_string(table.failures.size()) + " of " +
                  std::to_string(table.failures.size() + table.per_scene.size()) +
                  " jobs failed, first " + first.scene + ", " + first.method + ": " + first.reason +
                  "; run the batch again to try them again");
}

BatchPlan make_plan(Arguments& a) {
  a.engine.check();
  a.peers.check();
  a.truth.check();
  BatchPlan plan{read_scenes(a.lists), parse_methods("--methods", a.methods), {}, {}, !a.no_scores};
  plan.segment_arguments = words_of(*a.command, {EngineArguments::kPresetGroup,
                                                 EngineArguments::kGroup, MethodArguments::kGroup});
  plan.evaluate_arguments = words_of(*a.command, {TruthArguments::kGroup});
  return plan;
}

void run(Arguments& a) {
  if (!a.summary.empty()) return report(a, a.summary);
  if (a.lists.empty() || a.folder.empty())
    throw Error(Error::Kind::Usage,
                "name scenes and -o DIR, or --summary DIR; see planescope "
                "batch --help");
  const BatchPlan plan = make_plan(a);
  a.run.folder = a.folder;
  a.run.program = {a.program.empty() ? own_path() : a.program};
  a.run.pictures = a.pictures;
  a.run.fresh = a.fresh;
  a.run.shard = a.shard.empty() ? shard_from_environment() : parse_shard(a.shard);
  if (a.run.limits.memory_mb == 0) a.run.limits.memory_mb = default_memory_mb(a.run.jobs);
  const BatchState state = run_batch(plan, a.run, follow(a.console));
  a.console.say(std::to_string(state.done) + " jobs done, " + std::to_string(state.skipped) +
                " were done before, " + std::to_string(state.failed) + " failed; in " +
                duration(1000 * state.seconds));
  if (a.run.shard.whole()) return report(a, a.folder);
  a.console.say("shard " + std::to_string(a.run.shard.index) + " of " +
                std::to_string(a.run.shard.count) + "; after all of them: planescope batch " +
                "--summary " + a.folder.string());
  if (state.failed > 0)
    throw Error(Error::Kind::Mismatch, std::to_string(state.failed) +
                                           " jobs of this shard failed; " +
                                           "job.json in their folders says why");
}

void declare_limits(Arguments& a, CLI::App& command) {
  command.add_option("--jobs", a.run.jobs, "Scenes at a time; each has its share of the threads")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str()
      ->type_name("N");
  a.run.limits.seconds = 600;
  command.add_option("--time-limit", a.run.limits.seconds, "A scene that takes longer fails [s]")
      ->check(CLI::PositiveNumber)
      ->capture_default_str()
      ->type_name("S");
  command
      .add_option("--memory-limit", a.run.limits.memory_mb,
                  "A scene that asks for more fails [MB] (80 % of the memory over the jobs)")
      ->check(CLI::Range(16, 1 << 30))
      ->type_name("MB");
  command
      .add_option("--shard", a.shard,
                  "Only scenes k with k mod N = I; else by SLURM_ARRAY_TASK_ID or "
                  "OMPI_COMM_WORLD_RANK")
      ->type_name("I/N");
  command.add_flag("--fresh", a.fresh, "Do again what is done and unchanged");
  command
      .add_option("--program", a.program,
                  "Run scenes by this program instead: another build, or a wrapper that takes the "
                  "same arguments")
      ->type_name("FILE");
}

}  // namespace

Command add_batch(CLI::App& program) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* command =
      program.add_subcommand("batch", "Segment and score many scenes, and print the table");
  a->command = command;
  command
      ->add_option("LIST", a->lists,
                   "Clouds, globs, or a text file that lists them: SCENE or SCENE<tab>TRUTH a line")
      ->type_name("");
  command->add_option("-o,--output", a->folder, "Folder of all results, and of the table")
      ->type_name("DIR");
  command->add_option("--methods", a->methods, "Of ours, ransac, lccp, cpc")
      ->capture_default_str()
      ->type_name("NAMES");
  command->add_flag("--no-scores", a->no_scores,
                    "The scenes have no truth: results and times only");
  command->add_flag("--pictures", a->pictures, "Draw each scene too");
  command->add_option("--summary", a->summary, "Only print the table of a batch: merges its shards")
      ->type_name("DIR");
  declare_limits(*a, *command);
  a->truth.declare(*command);
  a->engine.declare(*command);
  a->peers.declare(*command);
  a->console.declare(*command);
  return {command, [a] { run(*a); }};
}

}  // namespace planescope::cli
