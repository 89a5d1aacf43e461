#include "tools/cli/task_share.h"

#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"

namespace tools {
namespace {

using support::error_kind;
using support::error_text;
using testing::HasSubstr;

using Variables = std::map<std::string, std::string>;

TaskShare share_of(const std::string& shard, std::size_t shards, const Variables& variables) {
  return chosen_share(shard, shards, [&](const char* name) {
    const auto found = variables.find(name);
    return found == variables.end() ? nullptr : found->second.c_str();
  });
}

void expect_share(const TaskShare& share, std::size_t task, std::size_t tasks) {
  EXPECT_EQ(share.task, task);
  EXPECT_EQ(share.tasks, tasks);
}

TEST(TaskShare, IsAllOfIt_WithoutOptionsAlsoInAnArray) {
  expect_share(share_of("", 0, {}), 1, 1);
  expect_share(share_of("", 0, {{"SLURM_ARRAY_TASK_ID", "3"}}), 1, 1);
}

TEST(TaskShare, TheOptionSaysMoreThanTheEnvironment) {
  expect_share(share_of("2/5", 0, {{"SLURM_ARRAY_TASK_ID", "3"}}), 2, 5);
}

TEST(TaskShare, AQueueNumbersTheTasksOfAnArray) {
  expect_share(share_of("", 7, {{"SLURM_ARRAY_TASK_ID", "3"}}), 3, 7);
  expect_share(share_of("", 7, {{"SGE_TASK_ID", "7"}}), 7, 7);
  expect_share(share_of("", 7, {{"PBS_ARRAY_INDEX", "1"}}), 1, 7);
  expect_share(share_of("", 7, {{"JOB_COMPLETION_INDEX", "0"}}), 1, 7);
  expect_share(share_of("", 7, {{"SGE_TASK_ID", "undefined"}, {"PBS_ARRAY_INDEX", "4"}}), 4, 7);
}

TEST(TaskShare, AnArrayOfMissingSharesHasTheSameNumbers) {
  expect_share(share_of("", 7, {{"SLURM_ARRAY_TASK_ID", "5"}, {"SLURM_ARRAY_TASK_MIN", "5"}}), 5,
               7);
}

TEST(TaskShare, RefusesAnArrayThatCountsFromZeroInEveryTask) {
  for (const char* task : {"0", "3"}) {
    EXPECT_THAT(error_text([&] {
                  share_of("", 7, {{"SLURM_ARRAY_TASK_ID", task}, {"SLURM_ARRAY_TASK_MIN", "0"}});
                }),
                HasSubstr("expected an array that counts from 1, --array=1-7"));
  }
}

TEST(TaskShare, RefusesWhatIsNoTask) {
  for (const char* task :
       {"0", "8", "-1", "x", "3/7", "-9223372036854775808", "99999999999999999999"}) {
    EXPECT_EQ(error_kind([&] {
                share_of("", 7, {{"SLURM_ARRAY_TASK_ID", task}});
              }),
              vo::ErrorKind::usage)
        << task;
  }
  EXPECT_THAT(error_text([] {
                share_of("", 7, {{"JOB_COMPLETION_INDEX", "7"}});
              }),
              HasSubstr("JOB_COMPLETION_INDEX is '7', expected 0 to 6"));
  EXPECT_THAT(error_text([] { share_of("", 7, {}); }), HasSubstr("or --shard K/7"));
  EXPECT_EQ(error_kind([] { share_of("1/7", 7, {}); }), vo::ErrorKind::usage);
  EXPECT_EQ(error_kind([] { share_of("8/7", 0, {}); }), vo::ErrorKind::usage);
}

TEST(TaskShare, NumbersAreWrittenAsArraysAreSubmitted) {
  EXPECT_EQ(array_text({}), "");
  EXPECT_EQ(array_text({4}), "4");
  EXPECT_EQ(array_text({1, 2}), "1-2");
  EXPECT_EQ(array_text({1, 3, 4, 5, 9}), "1,3-5,9");
}

}  // namespace
}  // namespace tools
