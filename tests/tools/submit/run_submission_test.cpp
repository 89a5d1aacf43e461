#include "tools/submit/run_submission.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/tools/submit/stand_ins.h"
#include "tools/submit/shares.h"
#include "vo/core/error.h"

namespace {

namespace fs = std::filesystem;

using support::error_kind;
using support::error_text;
using support::StandIns;
using testing::HasSubstr;
using tools::JobRecord;
using tools::Submission;

class Submitting : public testing::Test {
 protected:
  fs::path folder() const { return files_.path() / "it's out.submit"; }

  Submission submission(const std::vector<std::size_t>& shares, std::size_t throttle = 0) const {
    tools::BatchOptions options;
    options.max_array = queue_.max_array_size();
    options.throttle = throttle;
    options.others = {"--account=a b"};
    return tools::slurm_submission(support::odd_work("edvo", "/"), shares, folder(), options);
  }

  JobRecord submit(const Submission& submission) const {
    JobRecord record{.work = "it's", .shares = 12, .jobs = {}};
    tools::submit_to_slurm(submission, queue_, record);
    return record;
  }

  support::SlurmStandIns programs_;  // before the queue, which looks for sbatch
  support::TempFolder files_;
  tools::SlurmQueue queue_{[] {}};
};

TEST_F(Submitting, GivesSbatchArraysAndAJobAfterThem) {
  const JobRecord record = submit(submission(tools::all_shares(6)));
  EXPECT_EQ(programs_.calls("sbatch"),
            "--parsable|--account=a b|render-1.sbatch|\n"
            "--parsable|--account=a b|render-2.sbatch|\n"
            "--parsable|--dependency=afterany:41:42|--kill-on-invalid-dep=yes|--account=a "
            "b|merge.sbatch|\n");
  ASSERT_EQ(record.jobs.size(), 3U);
  EXPECT_EQ(record.jobs[1].shares, "5-6");
  EXPECT_EQ(record.jobs[2].name, "merge");
  EXPECT_TRUE(fs::is_directory(folder() / "log" / "render-2")) << "Slurm makes no folder of logs";
  EXPECT_THAT(vo::read_file(folder() / "render-2.sbatch"), HasSubstr("--array=1-2\n"));
}

TEST_F(Submitting, HoldsTheThrottleOverAllArrays) {
  submit(submission(tools::all_shares(12), 3));
  EXPECT_THAT(programs_.calls("sbatch"), HasSubstr("--dependency=afterany:42|"));
  EXPECT_THAT(programs_.calls("sbatch"), HasSubstr("--dependency=afterany:41:42:43|"));
  EXPECT_THAT(vo::read_file(folder() / "render-3.sbatch"), HasSubstr("--array=1-4%3\n"));
}

TEST_F(Submitting, OfNothingMissingIsTheLastJobAlone) {
  submit(submission({}));
  EXPECT_EQ(programs_.calls("sbatch"), "--parsable|--account=a b|merge.sbatch|\n");
}

TEST_F(Submitting, KeepsARecordThatIsReadBack) {
  EXPECT_FALSE(tools::read_job_record(folder()).has_value());
  submit(submission({2, 3, 7}));
  const auto record = tools::read_job_record(folder());
  ASSERT_TRUE(record.has_value());
  EXPECT_EQ(record->shares, 12U);
  ASSERT_EQ(record->jobs.size(), 3U);
  EXPECT_EQ(record->jobs[0].id, "41");
  EXPECT_EQ(record->jobs[0].shares, "2-3");
  EXPECT_EQ(record->jobs[1].shares, "7");
  for (const char* text : {"", "{}", R"({"work": "a", "shares": 0, "jobs": []})"}) {
    files_.write("bad/jobs.json", text);
    EXPECT_THAT(error_text([&] { tools::read_job_record(files_.path() / "bad"); }),
                HasSubstr("jobs.json: "));
  }
}

TEST_F(Submitting, IsRefusedWhileAJobIsQueued) {
  const JobRecord record = submit(submission(tools::all_shares(6)));
  EXPECT_EQ(error_text([&] { tools::require_none_queued(record, queue_); }), "no error")
      << "the queue has forgotten all";
  programs_.write("queued", "42\n43\n");
  const auto refuse = [&] { tools::require_none_queued(record, queue_); };
  EXPECT_THAT(error_text(refuse), HasSubstr("queued or running: 42 (render-2), 43 (merge);"));
  EXPECT_EQ(error_kind(refuse), vo::ErrorKind::output_exists);
  programs_.write("queued", "");
  EXPECT_EQ(error_text(refuse), "no error");
}

TEST_F(Submitting, IsRefusedWhereTheQueueDoesNotAnswer) {
  const JobRecord record = submit(submission({1}));
  programs_.add("squeue",
                "echo 'slurm_load_jobs error: Unable to contact slurm controller' >&2; exit 1");
  const auto ask = [&] { tools::require_none_queued(record, queue_); };
  EXPECT_THAT(error_text(ask), HasSubstr("squeue: slurm_load_jobs error: Unable to contact"));
  EXPECT_EQ(error_kind(ask), vo::ErrorKind::temporary);
}

TEST_F(Submitting, ThatFailsInTheMiddleRecordsWhatIsQueued) {
  programs_.add(
      "sbatch",
      "case $* in *merge*) echo 'sbatch: error: QOSMaxSubmitJobPerUserLimit' >&2; exit 1;; "
      "esac; echo '41;cluster'");
  EXPECT_THAT(error_text([&] { submit(submission({1})); }),
              HasSubstr("sbatch merge.sbatch: sbatch: error: QOSMaxSubmitJobPerUserLimit"));
  const auto record = tools::read_job_record(folder());
  ASSERT_TRUE(record.has_value());
  ASSERT_EQ(record->jobs.size(), 1U);
  EXPECT_EQ(record->jobs[0].id, "41");
}

TEST(ParallelSubmission, RunsItsSharesWithTheWordsAsTheyAre) {
  const StandIns programs;
  const support::TempFolder files;
  const fs::path program = programs.add("it's edvo", "");
  programs.add("parallel",
               "while read -r share; do sh share.sh \"$share\"; done < shares.txt; exit 1");
  const tools::SharedWork work = support::odd_work(program, files.path());
  const Submission submission = tools::parallel_submission(work, {2, 12}, files.path() / "it's", 3);
  EXPECT_EQ(tools::run_here(submission, [] {}), 0) << "of the last step";
  std::string words;
  for (const std::string& name : support::odd_names()) {
    words += name + "|";
  }
  EXPECT_EQ(programs.calls("it's edvo"),
            words + "--shard|2/12|\n" + words + "--shard|12/12|\n" + words + "\n");
  EXPECT_THAT(programs.calls("parallel"), HasSubstr("--quote|--jobs|3|"));
}

TEST(LocalSubmission, EndsWithTheStepThatFails) {
  const StandIns programs;
  const fs::path program = programs.add("edvo", "exit 75");
  tools::SharedWork work = support::odd_work(program, "/");
  work.local = {{program.string(), "render"}, {program.string(), "merge"}};
  EXPECT_EQ(tools::run_here(tools::local_submission(work), [] {}), 75);
  EXPECT_EQ(programs.calls("edvo"), "render|\n");
}

}  // namespace
