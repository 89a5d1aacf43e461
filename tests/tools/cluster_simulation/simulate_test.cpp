#include "tools/cluster_simulation/simulate.h"

#include <cmath>
#include <functional>
#include <numeric>
#include <queue>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/error_text.h"
#include "vo/core/fields.h"

namespace tools {
namespace {

using support::error_kind;
using support::error_text;
using testing::HasSubstr;

constexpr double kHour = 3600;

/// A cluster whose tasks take the time of their frames, 1 s each, and nothing else.
ClusterOptions ideal(int nodes, int processors) {
  ClusterOptions options;
  options.nodes = nodes;
  options.processors = processors;
  options.frame_s = 1;
  for (double* cost :
       {&options.mtbf_h, &options.scheduler_per_s, &options.start_s, &options.scene_s,
        &options.scene_mb, &options.write_s, &options.bandwidth_mb_s, &options.files_per_s}) {
    *cost = 0;
  }
  return options;
}

std::vector<std::size_t> equal_parts(std::size_t parts, std::size_t frames) {
  return std::vector<std::size_t>(parts, frames);
}

/// Returns how long a list takes when each item goes to the worker that is free first.
double list_schedule(const std::vector<std::size_t>& items, std::size_t workers) {
  std::priority_queue<double, std::vector<double>, std::greater<>> free;
  for (std::size_t i = 0; i < workers; ++i) {
    free.push(0);
  }
  double end = 0;
  for (const std::size_t item : items) {
    const double done = free.top() + static_cast<double>(item);
    free.pop();
    free.push(done);
    end = std::max(end, done);
  }
  return end;
}

double sum(const std::vector<std::size_t>& parts) {
  return static_cast<double>(std::accumulate(parts.begin(), parts.end(), std::size_t{0}));
}

TEST(ClusterSimulation, WithoutLimitsAndFailuresIsListScheduling) {
  std::vector<std::size_t> parts;
  for (std::size_t i = 0; i < 200; ++i) {
    parts.push_back(10 + (i * 7919) % 491);
  }
  for (const int processors : {1, 3, 16}) {
    const ClusterRun run = simulate_cluster(ideal(2, processors), parts);
    EXPECT_NEAR(run.wall_s(), list_schedule(parts, 2U * static_cast<unsigned>(processors)), 1e-6);
    EXPECT_DOUBLE_EQ(run.efficiency(), 1);
  }
}

TEST(ClusterSimulation, ATaskOfManyProcessorsIsAsMuchFaster) {
  ClusterOptions options = ideal(1, 8);
  options.task_processors = 4;
  const ClusterRun run = simulate_cluster(options, equal_parts(4, 100));
  EXPECT_NEAR(run.wall_s(), 2 * 100 / 4.0, 1e-9);
  EXPECT_NEAR(run.time_of(TimeUse::rendering), 400, 1e-9);
}

TEST(ClusterSimulation, StartAndSceneAreOncePerTask) {
  ClusterOptions options = ideal(1, 1);
  options.start_s = 3;
  options.scene_s = 5;
  options.task_parts = 4;
  const ClusterRun run = simulate_cluster(options, equal_parts(10, 20));
  EXPECT_EQ(run.tasks, 3U);
  EXPECT_NEAR(run.wall_s(), 10 * 20 + 3 * (3 + 5), 1e-9);
  EXPECT_NEAR(run.efficiency(), 200.0 / 224, 1e-12);
  EXPECT_EQ(run.limit(), TimeUse::scenes);
}

TEST(ClusterSimulation, TheQueueStartsSoManyTasksInASecond) {
  ClusterOptions options = ideal(100, 10);
  options.scheduler_per_s = 3;
  const ClusterRun run = simulate_cluster(options, equal_parts(200, 10));
  EXPECT_NEAR(run.wall_s(), 199 / 3.0 + 10, 1e-9);
  options.nodes = 1;  // ten places, each of which takes a task every 10 s: one a second
  const ClusterRun full = simulate_cluster(options, equal_parts(200, 10));
  EXPECT_NEAR(full.wall_s(), 200.0 / 10 * 10 + 9 / 3.0, 1e-6);
  options = ideal(20, 10);
  options.scheduler_per_s = 3;
  EXPECT_EQ(simulate_cluster(options, equal_parts(20000, 10)).limit(), TimeUse::scheduler);
}

TEST(ClusterSimulation, ABusyFileSystemGivesWhatItHas) {
  ClusterOptions options = ideal(4, 25);
  options.frame_mb = 2;
  options.bandwidth_mb_s = 50;
  const auto parts = equal_parts(300, 10);
  const ClusterRun bytes = simulate_cluster(options, parts);
  EXPECT_NEAR(bytes.wall_s(), 3000 * 2 / 50.0, 1e-6);
  EXPECT_EQ(bytes.limit(), TimeUse::bandwidth);
  EXPECT_NEAR(bytes.efficiency(), 0.25, 1e-9);
  options.bandwidth_mb_s = 0;
  options.frame_files = 3;
  options.files_per_s = 60;
  const ClusterRun files = simulate_cluster(options, parts);
  EXPECT_NEAR(files.wall_s(), 3000 * 3 / 60.0, 1e-6);
  EXPECT_EQ(files.limit(), TimeUse::metadata);
  options.files_per_s = 300;
  EXPECT_NEAR(simulate_cluster(options, parts).wall_s(), 30, 1e-9);
}

TEST(ClusterSimulation, WhoIsLeftAloneWithTheFileSystemGoesFaster) {
  ClusterOptions options = ideal(1, 2);
  options.frame_mb = 1;
  options.bandwidth_mb_s = 1;
  EXPECT_NEAR(simulate_cluster(options, {10, 30}).wall_s(), 2 * 10 + 20, 1e-9);
}

TEST(ClusterSimulation, ScenesAreReadThroughTheSameFileSystem) {
  ClusterOptions options = ideal(5, 10);
  options.scene_s = 1;
  options.scene_mb = 100;
  options.bandwidth_mb_s = 500;
  options.frame_mb = 0;
  EXPECT_NEAR(simulate_cluster(options, equal_parts(50, 7)).wall_s(), 50 * 100 / 500.0 + 7, 1e-9);
}

TEST(ClusterSimulation, MergingIsAsLongAsItsFiles) {
  ClusterOptions options = ideal(1, 1);
  options.frame_files = 2;
  options.merge_files_per_s = 5;
  const ClusterRun run = simulate_cluster(options, {100});
  EXPECT_NEAR(run.merge_s, 40, 1e-12);
  EXPECT_NEAR(run.wall_s(), 140, 1e-9);
  EXPECT_EQ(run.limit(), TimeUse::merge);
}

/// A cluster of single processors that fail often, and parts for each of them.
ClusterOptions failing() {
  ClusterOptions options = ideal(50, 1);
  options.mtbf_h = 1;
  options.repair_s = 300;
  options.requeue_s = 120;
  return options;
}

constexpr std::size_t kParts = 4000;
constexpr std::size_t kFrames = 360;  // a tenth of the time between failures

TEST(ClusterSimulation, NodesFailAsOftenAsTheyAreSaidTo) {
  const ClusterOptions options = failing();
  const ClusterRun run = simulate_cluster(options, equal_parts(kParts, kFrames));
  const double expected =
      options.nodes * run.render_s / (options.mtbf_h * kHour + options.repair_s);
  EXPECT_NEAR(static_cast<double>(run.failures), expected, 3 * std::sqrt(expected));
}

TEST(ClusterSimulation, AFailureCostsHalfAPart) {
  const ClusterRun run = simulate_cluster(failing(), equal_parts(kParts, kFrames));
  const double lost = run.time_of(TimeUse::lost) / static_cast<double>(run.broken_off);
  // A node that fails within a part of length P has worked on it for P/2 (1 - P/6 / MTBF) on
  // average.
  const double expected = kFrames / 2.0 * (1 - kFrames / 6.0 / kHour);
  const double sigma = kFrames / std::sqrt(12.0 * static_cast<double>(run.broken_off));
  EXPECT_NEAR(lost, expected, 3 * sigma);
}

TEST(ClusterSimulation, TheEfficiencyIsThatOfRenewals) {
  ClusterOptions options = failing();
  options.start_s = 20;
  options.scene_s = 40;
  const ClusterRun run = simulate_cluster(options, equal_parts(kParts, kFrames));
  // A task of overhead R and length P that begins anew at every failure, of rate f, takes
  // (exp(f (R + P)) - 1) / f in the mean.
  const double rate = 1 / (options.mtbf_h * kHour);
  const double taken = std::expm1(rate * (20 + 40 + kFrames)) / rate;
  EXPECT_NEAR(run.efficiency(), kFrames / taken, 0.005);
}

TEST(ClusterSimulation, WhatIsDoneIsNotDoneAgain) {
  ClusterOptions options = failing();
  options.task_parts = 20;
  const ClusterRun run = simulate_cluster(options, equal_parts(20 * kParts, kFrames / 20));
  EXPECT_GT(run.restarts, 100U);
  EXPECT_GT(run.efficiency(), 0.99);  // a part at a time is lost, not a task
}

TEST(ClusterSimulation, EveryPartIsDoneOnceAndAllTimeIsAccountedFor) {
  ClusterOptions options = failing();
  options.processors = 7;
  options.task_processors = 3;
  options.task_parts = 4;
  options.start_s = 1;
  options.scene_s = 5;
  options.scene_mb = 10;
  options.bandwidth_mb_s = 40;
  options.files_per_s = 100;
  options.scheduler_per_s = 0.5;
  std::vector<std::size_t> parts;
  for (std::size_t i = 0; i < 1501; ++i) {
    parts.push_back(50 + i % 97);
  }
  const ClusterRun run = simulate_cluster(options, parts);
  EXPECT_EQ(static_cast<double>(run.frames), sum(parts));
  EXPECT_GT(run.broken_off, 10U);
  EXPECT_NEAR(run.time_of(TimeUse::rendering), sum(parts), 1e-6 * sum(parts));
  const double all = run.wall_s() * options.nodes * options.tasks_per_node() * 3;
  EXPECT_NEAR(run.all_processor_s(), all, 1e-9 * all);
  for (const double time : run.processor_s) {
    EXPECT_GE(time, 0);
  }
}

TEST(ClusterSimulation, TheSeedAloneDecidesWhatFails) {
  ClusterOptions options = failing();
  const auto parts = equal_parts(kParts, kFrames);
  const ClusterRun first = simulate_cluster(options, parts);
  EXPECT_EQ(simulate_cluster(options, parts).processor_s, first.processor_s);
  options.seed = 2;
  EXPECT_NE(simulate_cluster(options, parts).processor_s, first.processor_s);
}

TEST(ClusterSimulation, PartsThatNoNodeOutlivesAreAnError) {
  EXPECT_THAT(error_text([] { simulate_cluster(failing(), equal_parts(1, 100'000)); }),
              HasSubstr("nodes fail too often: after "));
}

TEST(ClusterSimulation, EndsWhereItsCallerWantsItTo) {
  ClusterOptions options = failing();
  options.mtbf_h = 1e-6;  // every node fails all the time, and hardly a task is begun
  const auto end_it = [] { vo::fail("ended"); };
  EXPECT_EQ(error_text([&] { simulate_cluster(options, equal_parts(100, 10), end_it); }), "ended");
}

TEST(ClusterSimulation, NothingToDoTakesNoTime) {
  EXPECT_EQ(simulate_cluster(failing(), {}).wall_s(), 0);
}

TEST(ClusterOptions, AreSetByText) {
  ClusterOptions options;
  set_cluster_options("nodes=1000,mtbf_h=50,processors=128", options);
  EXPECT_EQ(options.nodes, 1000);
  EXPECT_EQ(options.processors, 128);
  EXPECT_EQ(options.mtbf_h, 50);
  EXPECT_EQ(options.requeue_s, 120);
}

TEST(ClusterOptions, RefuseWhatIsNone) {
  ClusterOptions options;
  const auto text = [&](const std::string& words) {
    return error_text([&] { set_cluster_options(words, options); });
  };
  EXPECT_THAT(text("nodes"), HasSubstr("--simulate: expected key=value,key=value, got 'nodes'"));
  EXPECT_THAT(text("node=3"), HasSubstr("the nearest known key is nodes"));
  EXPECT_THAT(text("nodes=x"), HasSubstr("nodes"));
  options = {};
  EXPECT_THAT(text("nodes=0"), HasSubstr("nodes: expected 1 to "));
  options = {};
  EXPECT_THAT(text("task_processors=65"), HasSubstr("task_processors: expected 1 to 64, got 65"));
  options = {};
  EXPECT_THAT(text("frame_mb=-1"), HasSubstr("frame_mb: expected 0 to "));
  options = {};
  EXPECT_THAT(text("frame_mb=nan"), HasSubstr("frame_mb"));
  options = {};
  EXPECT_THAT(text("frame_s=0,write_s=0"), HasSubstr("frame_s: expected above 0"));
  EXPECT_EQ(error_kind([&] { set_cluster_options("nodes=0", options); }), vo::ErrorKind::usage);
}

TEST(ClusterRun, IsToldAsTextAndJson) {
  ClusterOptions options = ideal(2, 4);
  options.frame_mb = 0.5;
  const ClusterRun run = simulate_cluster(options, equal_parts(8, 4500));
  const std::string text = format_cluster_run(options, run);
  EXPECT_THAT(text, HasSubstr("2 nodes, 8 tasks at a time; 8 tasks, 8 parts, 36000 frames\n"));
  EXPECT_THAT(text, HasSubstr("wall time   1.25 h, of which merging 0.0 s\n"));
  EXPECT_THAT(text, HasSubstr("efficiency  100.0 % of 10.00 h of allocated processor time\n"));
  EXPECT_THAT(text, HasSubstr("written     18.0 GB in 72000 files\n"));
  EXPECT_THAT(text, HasSubstr("processors  rendering 100.0 %\n"));
  options.nodes = 4;
  EXPECT_THAT(format_cluster_run(options, simulate_cluster(options, equal_parts(8, 4500))),
              HasSubstr("limit       too few tasks for so many processors"));
  options.nodes = 2;
  const nlohmann::ordered_json json = cluster_run_json(options, run);
  EXPECT_EQ(json["wall_s"], 4500.0);
  EXPECT_EQ(json["cluster"]["nodes"], 2);
  EXPECT_EQ(json["processor_s"]["rendering"], 36000.0);
  EXPECT_EQ(json["bytes"], 18e9);
}

}  // namespace
}  // namespace tools
