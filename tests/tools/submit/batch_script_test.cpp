#include "tools/submit/batch_script.h"

#include <csignal>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/tools/submit/stand_ins.h"
#include "tools/processes/printed.h"
#include "tools/processes/shell_words.h"

namespace {

using support::odd_work;
using support::StandIns;
using testing::HasSubstr;
using testing::Not;
using tools::BatchOptions;
using tools::Printed;

/// The script of shares 5 to 8, whose tasks have the indices 1 to 4.
std::string script_of(const tools::SharedWork& work, const BatchOptions& options = {}) {
  return tools::array_script(work, {.offset = 4, .indices = {1, 2, 3, 4}}, "render-2", options);
}

/// Runs bash with words as the second task of the array 7.
Printed run_task(const std::string& words, const std::string& restarts = "0") {
  return tools::run_and_read(
      {.words = {"sh", "-c",
                 "export SLURM_ARRAY_JOB_ID=7 SLURM_ARRAY_TASK_ID=2 SLURM_JOB_ID=9 "
                 "SLURMD_NODENAME=n1 SLURM_RESTART_COUNT=" +
                     restarts + "; " + words}},
      [] {});
}

/// The words of odd_work's command, as a stand-in records them.
std::string recorded_words(const std::string& last) {
  std::string text;
  for (const std::string& name : support::odd_names()) {
    text += name + "|";
  }
  return text + last + "\n";
}

TEST(BatchScript, IsBashForAnyNames) {
  const StandIns programs;
  const tools::SharedWork work = odd_work(programs.file("it's edvo"), "/it's a $folder");
  BatchOptions options;
  options.minutes = 30;
  options.throttle = 3;
  for (const std::string& script : {script_of(work, options), finish_script(work, options)}) {
    const std::string file = programs.write("script", script).string();
    EXPECT_EQ(run_task("bash -n " + tools::shell_quoted(file)).exit_code, 0) << script;
  }
}

TEST(BatchScript, AsksSlurmForWhatItIsTold) {
  BatchOptions options;
  options.minutes = 30;
  options.throttle = 3;
  options.cpus = 4;
  options.memory = 900;
  const std::string script = script_of(odd_work("edvo", "/"), options);
  const std::string asked = script.substr(0, script.find("share="));
  EXPECT_EQ(asked,
            "#!/bin/bash\n#SBATCH --job-name=edvo-it_s__SBATCH_--hold\n#SBATCH --array=1-4%3\n"
            "#SBATCH --output=log/render-2/%a.log\n#SBATCH --open-mode=append\n"
            "#SBATCH --requeue\n#SBATCH --signal=B:TERM@60\n#SBATCH --cpus-per-task=4\n"
            "#SBATCH --mem=900M\n#SBATCH --time=30\n");
  EXPECT_THAT(support::error_text([] { BatchOptions{.memory = 0}.validate(); }),
              HasSubstr("--memory is 0"));
}

TEST(BatchScript, RunsItsShareInTheFolderWithTheWordsAsTheyAre) {
  const StandIns programs;
  const auto program = programs.add("it's edvo", "pwd > \"$here/pwd\"; exit 3");
  const auto folder = programs.write("a $b/x", "").parent_path();
  const std::string file = programs.write("script", script_of(odd_work(program, folder))).string();
  const Printed task = run_task("bash " + tools::shell_quoted(file));
  EXPECT_EQ(task.exit_code, 3) << task.err;
  EXPECT_EQ(programs.calls("it's edvo"), recorded_words("--shard|6/12|"));
  EXPECT_EQ(vo::read_file(programs.file("pwd")), folder.string() + "\n");
  EXPECT_THAT(task.out, HasSubstr("share 6/12, job 9, node n1, restart 0\n"));
}

/// A task whose command ends with 75, a while after it was told to: what scontrol was told then.
std::string requeued(const std::string& state, const std::string& restarts) {
  const StandIns programs;
  const auto program = programs.add(
      "edvo", "trap 'sleep 0.2; exit 75' TERM\nkill -TERM $PPID\nsleep 5 & wait; exit 9");
  programs.add("squeue", "echo " + state);
  programs.add("scontrol", "");
  const std::string file = programs.write("script", script_of(odd_work(program, "/"))).string();
  const Printed task = run_task("exec bash " + tools::shell_quoted(file), restarts);
  EXPECT_EQ(task.exit_code, 75) << task.err;
  return programs.calls("scontrol");
}

TEST(BatchScript, HandsASignalOnAndQueuesItsTaskAgain) {
  EXPECT_EQ(requeued("RUNNING", "19"), "requeue|7_2|\n");
}

TEST(BatchScript, DoesNotQueueWhatSlurmEndsOrWhatNeverEnds) {
  EXPECT_EQ(requeued("COMPLETING", "0"), "");
  EXPECT_EQ(requeued("RUNNING", "20"), "");
}

}  // namespace
