// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>

#include "batch/data_limit.hpp"
#include "batch/job.hpp"
#include "batch/run_batch.hpp"
#include "batch/scene_list.hpp"
#include "batch/statistics.hpp"
#include "batch/table.hpp"
#include "fixtures.hpp"
#include "planescope/error.hpp"

namespace planescope {
namespace {

using testing::read_bytes;
using testing::TemporaryFolder;
using testing::write_bytes;

TEST(Statistics, MeanMedianAndPercentilesByHand) {
  EXPECT_DOUBLE_EQ(statistic({1, 2, 6}, Statistic::Mean), 3);
  EXPECT_DOUBLE_EQ(statistic({6, 1, 2}, Statistic::Median), 2);
  EXPECT_DOUBLE_EQ(statistic({4, 1, 2, 8}, Statistic::Median), 3);
  EXPECT_DOUBLE_EQ(percentile({0, 10, 20, 30}, 50), 15);
  EXPECT_DOUBLE_EQ(percentile({0, 10, 20, 30}, 2.5), 0.75);
  EXPECT_DOUBLE_EQ(percentile({7}, 97.5), 7);
}

TEST(Statistics, BootstrapOfAMeanIsThatOfTheBinomial) {
  // Means of resamples of 50 zeros and 50 ones are binomial: sd 0.05, so 0.402 to 0.598.
  std::vector<double> values(100, 0);
  std::fill(values.begin() + 50, values.end(), 1.0);
  const Estimate found = bootstrap(values, Statistic::Mean);
  EXPECT_DOUBLE_EQ(found.value, 0.5);
  EXPECT_NEAR(found.low, 0.402, 0.011);
  EXPECT_NEAR(found.high, 0.598, 0.011);
  EXPECT_EQ(found.count, 100U);
  const Estimate again = bootstrap(values, Statistic::Mean);
  EXPECT_EQ(found.low, again.low);
  const Estimate one = bootstrap({3}, Statistic::Median);
  EXPECT_EQ(one.low, 3);
  EXPECT_EQ(one.high, 3);
}

TEST(SceneList, TakesCloudsGlobsAndLists) {
  const TemporaryFolder folder;
  for (const char* name : {"b.pcd", "a.pcd", "c d.ply", "truth.pcd"})
    write_bytes(folder / name, "");
  write_bytes(folder / "a.truth.json", "{}");
  write_bytes(folder / "list", "# scenes\n a.pcd \n\nc d.ply\ttruth.pcd # with another truth\n");
  const auto listed = read_scenes({(folder / "list").string()});
  ASSERT_EQ(listed.size(), 2U);
  EXPECT_EQ(listed[0].name, "a");
  EXPECT_EQ(listed[0].truth, folder / "a.pcd");
  EXPECT_EQ(listed[0].truth_planes, folder / "a.truth.json");
  EXPECT_EQ(listed[1].name, "c d");
  EXPECT_EQ(listed[1].truth, folder / "truth.pcd");
  EXPECT_TRUE(listed[1].truth_planes.empty());
  const auto matched = read_scenes({(folder / "?.pcd").string(), (folder / "a.pcd").string()});
  ASSERT_EQ(matched.size(), 2U) << "each once";
  EXPECT_EQ(matched[0].name, "a");
  EXPECT_EQ(read_scenes({(folder / "gone.pcd").string()}).size(), 1U) << "fails on its own, later";
}

TEST(SceneList, ScenesOfOneNameAreToldApart) {
  const auto scenes = read_scenes({"x/room.pcd", "y/room.pcd", "z/hall.pcd"});
  EXPECT_NE(scenes[0].name, scenes[1].name);
  EXPECT_TRUE(scenes[0].name.ends_with("x_room.pcd")) << scenes[0].name;
  EXPECT_EQ(scenes[2].name, "hall");
}

TEST(SceneList, RefusesWhatNamesNoScene) {
  const TemporaryFolder folder;
  write_bytes(folder / "empty", "# nothing\n");
  EXPECT_THROW(read_scenes({(folder / "empty").string()}), Error);
  EXPECT_THROW(read_scenes({(folder / "*.pcd").string()}), Error);
  EXPECT_THROW(read_scenes({(folder / "none.txt").string()}), Error);
  EXPECT_THROW(read_scenes({folder.path().string()}), Error);
}

TEST(Shards, EverySceneIsInOne) {
  for (std::size_t scene = 0; scene < 20; ++scene) {
    int owners = 0;
    for (const char* text : {"0/3", "1/3", "2/3"}) owners += parse_shard(text).has(scene) ? 1 : 0;
    EXPECT_EQ(owners, 1);
  }
  EXPECT_TRUE(parse_shard("1/3").has(4));
  for (const char* text : {"3/3", "1", "a/3", "1/0", "-1/3", "1/3x", ""})
    EXPECT_THROW(parse_shard(text), Error) << text;
}

TEST(Shards, ComeFromTheScheduler) {
  EXPECT_TRUE(shard_from_environment().whole());
  ::setenv("SLURM_ARRAY_TASK_ID", "7", 1);
  ::setenv("SLURM_ARRAY_TASK_MIN", "1", 1);
  ::setenv("SLURM_ARRAY_TASK_STEP", "2", 1);
  ::setenv("SLURM_ARRAY_TASK_COUNT", "4", 1);
  EXPECT_EQ(shard_from_environment().index, 3U);
  EXPECT_EQ(shard_from_environment().count, 4U);
  ::setenv("SLURM_ARRAY_TASK_ID", "many", 1);
  EXPECT_THROW(shard_from_environment(), Error);
  for (const char* part : {"ID", "MIN", "STEP", "COUNT"})
    ::unsetenv(("SLURM_ARRAY_TASK_" + std::string(part)).c_str());
  ::setenv("OMPI_COMM_WORLD_RANK", "1", 1);
  ::setenv("OMPI_COMM_WORLD_SIZE", "2", 1);
  EXPECT_EQ(shard_from_environment().index, 1U);
  ::unsetenv("OMPI_COMM_WORLD_RANK");
  ::unsetenv("OMPI_COMM_WORLD_SIZE");
}

ChildEnd run_to_end(const std::string& script, const TemporaryFolder& folder,
                    const ChildLimits& limits) {
  ChildProcess child({"sh", "-c", script}, folder / "out", folder / "err", limits);
  for (;;) {
    if (const auto end = child.poll()) return *end;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

TEST(ChildProcess, TellsHowItEnded) {
  const TemporaryFolder folder;
  EXPECT_TRUE(run_to_end("echo said; echo moaned >&2", folder, {}).good());
  EXPECT_EQ(read_bytes(folder / "out"), "said\n");
  EXPECT_EQ(read_bytes(folder / "err"), "moaned\n");
  EXPECT_EQ(run_to_end("exit 5", folder, {}).code, 5);
  const ChildEnd crashed = run_to_end("kill -SEGV $$", folder, {});
  EXPECT_EQ(crashed.how, ChildEnd::How::Signalled);
  EXPECT_EQ(crashed.code, SIGSEGV);
  const ChildEnd hung = run_to_end("sleep 60", folder, {.seconds = 0.2});
  EXPECT_EQ(hung.how, ChildEnd::How::TimedOut);
  // tail keeps what may be the last line: zeros without an end.
  const ChildEnd hungry =
      run_to_end("head -c 500M /dev/zero | tail -n 1 >/dev/null", folder, {.memory_mb = 100});
  EXPECT_EQ(hungry.good(), !kLimitsData);
  ChildProcess missing({"/no/such/program"}, folder / "out", folder / "err", {});
  std::optional<ChildEnd> end;
  while (!(end = missing.poll())) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(end->code, 127);
}

TEST(ChildProcess, TakesItsOwnChildrenAlong) {
  const TemporaryFolder folder;
  run_to_end("(sleep 1; touch '" + (folder / "alive").string() + "') & sleep 60", folder,
             {.seconds = 0.2});
  std::this_thread::sleep_for(std::chrono::milliseconds(1300));
  EXPECT_FALSE(std::filesystem::exists(folder / "alive"));
}

/// A stand-in for planescope: writes what a job reads, misbehaves on scenes of some names.
const char* const kFakeProgram = R"sh(#!/bin/sh
echo "$@" >>"$LOG"
case $2 in
  *crash*) kill -SEGV $$ ;;
  *hang*) sleep 60 ;;
  *memory*) head -c 500M /dev/zero | tail -n 1 >/dev/null || exit 4 ;;
  *refused*) echo "planescope: refused.pcd: is no cloud" >&2; exit 3 ;;
esac
if [ "$1" = segment ]; then
  dir=${3#--output=}
  echo '{"timings_ms":{"patches":1,"hypotheses":2,"selection":3,"assignment":4,"edges":5,"segments":6}}' >"$dir/run.json"
  echo '{}' >"$dir/result.json"
else
  n=$(basename "$(dirname "$2")" | tr -cd '0-9')
  echo "{\"labels\":{\"weighted_overlap\":0.$n,\"overlap\":0.5}}"
fi
)sh";

struct FakeBatch {
  TemporaryFolder folder;
  BatchPlan plan;
  BatchRun run;

  explicit FakeBatch(const std::vector<std::string>& scenes) {
    write_bytes(folder / "program", kFakeProgram);
    ::chmod((folder / "program").c_str(), 0755);
    ::setenv("LOG", (folder / "log").c_str(), 1);
    std::vector<std::string> files;
    for (const std::string& scene : scenes) {
      files.push_back((folder / (scene + ".pcd")).string());
      write_bytes(files.back(), scene);
    }
    plan.scenes = read_scenes(files);
    plan.methods = {"lccp", "ours"};
    run.folder = folder / "out";
    run.program = {(folder / "program").string()};
    run.limits = {.seconds = 2, .memory_mb = 100};
    run.jobs = 4;
  }
  std::size_t calls() const {
    const std::string log = read_bytes(folder / "log");
    return static_cast<std::size_t>(std::count(log.begin(), log.end(), '\n'));
  }
};

TEST(RunBatch, OneBadSceneCostsOneScene) {
  FakeBatch batch({"good3", "crash", "hang", "memory", "refused", "good6"});
  const BatchState state = run_batch(batch.plan, batch.run, {});
  EXPECT_EQ(state.done, 4U);
  EXPECT_EQ(state.failed, 8U);
  const BatchTable table = summarise(batch.run.folder);
  EXPECT_EQ(table.per_scene.size(), 4U);
  std::map<std::string, std::string> reasons;
  for (const TableFailure& failure : table.failures) reasons[failure.scene] = failure.reason;
  EXPECT_NE(reasons["crash"].find("signal 11"), std::string::npos) << reasons["crash"];
  EXPECT_NE(reasons["hang"].find("longer than 2 s"), std::string::npos) << reasons["hang"];
  if (kLimitsData) {
    EXPECT_NE(reasons["memory"].find("exit code 4"), std::string::npos) << reasons["memory"];
  }
  EXPECT_EQ(reasons["refused"], "exit code 3: refused.pcd: is no cloud");
  ASSERT_EQ(table.methods.size(), 2U);
  const Estimate& overlap = table.methods[1].cells.at("weighted_overlap");
  EXPECT_DOUBLE_EQ(overlap.value, (0.3 + 0.6) / 2);
  EXPECT_EQ(overlap.count, 2U);
  EXPECT_DOUBLE_EQ(table.methods[1].cells.at(kTimeMeasure).value, 21);
  ASSERT_EQ(table.differences.size(), 1U);
  EXPECT_EQ(table.differences[0].against, "lccp");
  EXPECT_DOUBLE_EQ(table.differences[0].cells.at("weighted_overlap").value, 0);
}

TEST(RunBatch, DoesOnlyWhatIsNotDoneOrHasChanged) {
  FakeBatch batch({"one1", "two2"});
  run_batch(batch.plan, batch.run, {});
  EXPECT_EQ(batch.calls(), 8U);
  EXPECT_EQ(run_batch(batch.plan, batch.run, {}).skipped, 4U);
  EXPECT_EQ(batch.calls(), 8U);
  write_bytes(batch.folder / "two2.pcd", "another");  // both methods of one scene again
  EXPECT_EQ(run_batch(batch.plan, batch.run, {}).skipped, 2U);
  EXPECT_EQ(batch.calls(), 12U);
  std::filesystem::remove(batch.run.folder / "one1" / "ours" /
                          "job.json");  // killed before its end
  EXPECT_EQ(run_batch(batch.plan, batch.run, {}).done, 1U);
  BatchPlan other = batch.plan;
  other.segment_arguments = {"--preset=room"};
  EXPECT_EQ(run_batch(other, batch.run, {}).done, 4U);
  EXPECT_EQ(summarise(batch.run.folder).failures.size(), 0U);
  batch.run.fresh = true;
  EXPECT_EQ(run_batch(other, batch.run, {}).done, 4U);
}

TEST(RunBatch, ShardsMakeTheTableOfTheWhole) {
  FakeBatch whole({"a1", "b2", "c3", "d4", "e5"});
  run_batch(whole.plan, whole.run, {});
  const std::string expected = to_json(summarise(whole.run.folder));
  BatchRun part = whole.run;
  part.folder = whole.folder / "shards";
  for (const char* shard : {"0/3", "1/3", "2/3"}) {
    part.shard = parse_shard(shard);
    run_batch(whole.plan, part, {});
    if (part.shard.index < 2) {
      EXPECT_FALSE(summarise(part.folder).failures.empty()) << "the others are missing";
    }
  }
  EXPECT_EQ(to_json(summarise(part.folder)), expected);
}

TEST(BatchTable, SaysTheSameInEveryFormat) {
  BatchTable table;
  table.scenes = 2;
  table.methods = {{"lccp", "", {{"weighted_overlap", {0.5, 0.25, 0.75, 2}}}}};
  table.differences = {{"ours", "lccp", {{"weighted_overlap", {0.125, -0.25, 0.5, 2}}}}};
  table.failures = {{"hall", "lccp", "exit code 3"}};
  const std::string markdown = to_markdown(table);
  EXPECT_NE(markdown.find("| method | scenes | WO % |\n|---|---|---|\n"
                          "| lccp | 2 of 2 | 50.00 [25.00, 75.00] |\n"
                          "| ours - lccp | 2 of 2 | +12.50 [-25.00, +50.00] |\n"),
            std::string::npos)
      << markdown;
  EXPECT_NE(markdown.find("hall, lccp: exit code 3"), std::string::npos);
  EXPECT_EQ(to_csv(table),
            "method,against,measure,value,low,high,scenes\n"
            "lccp,,weighted_overlap,0.5,0.25,0.75,2\n"
            "ours,lccp,weighted_overlap,0.125,-0.25,0.5,2\n");
  const std::string latex = to_latex(table);
  EXPECT_NE(latex.find("\\toprule\nMethod & WO [\\%] \\\\\n\\midrule\nlccp & $50.00$"),
            std::string::npos)
      << latex;
  EXPECT_NE(latex.find("\\bottomrule"), std::string::npos);
  const auto json = nlohmann::json::parse(to_json(table));
  EXPECT_EQ(json["methods"][0]["measures"]["weighted_overlap"]["low"], 0.25);
  EXPECT_EQ(json["failures"][0]["scene"], "hall");
}

TEST(BatchTable, RefusesAFolderWithoutABatch) {
  const TemporaryFolder folder;
  EXPECT_THROW(summarise(folder.path()), Error);
  write_bytes(folder / "batch.json", "{\"schema\": 1}");
  EXPECT_THROW(summarise(folder.path()), Error);
}

}  // namespace
}  // namespace planescope
