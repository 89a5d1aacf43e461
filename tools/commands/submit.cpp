#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tools/cli/exit_code.h"
#include "tools/cli/interrupt.h"
#include "tools/cli/options.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/standard_streams.h"
#include "tools/commands/commands.h"
#include "tools/commands/trial_arguments.h"
#include "tools/processes/shell_words.h"
#include "tools/submit/dataset_work.h"
#include "tools/submit/own_program.h"
#include "tools/submit/run_submission.h"
#include "tools/submit/shares.h"
#include "tools/submit/trials_work.h"
#include "tools/trials/test_run.h"
#include "vo/core/error.h"
#include "vo/files/output_lock.h"
#include "vo/output_folders/output_folder.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSubmitHelp =
    "Hands a data set (edvo dataset), or scenarios to test (--test, edvo test) or to sweep "
    "(--sweep,\n"
    "edvo sweep), to what makes it in shares. The engines:\n"
    "  slurm     arrays of jobs, and a job that puts together what they made, when all have "
    "ended,\n"
    "            however they did. A task that Slurm interrupts goes on when it is queued again;\n"
    "            waiting and repeating is the queue's work\n"
    "  parallel  GNU parallel, on this machine or, by PARALLEL='--sshlogin ...', on others\n"
    "  local     this machine, as one process\n"
    "Scripts, logs and the numbers of the jobs are in OUT.submit. All machines see the program, "
    "SPEC\n"
    "and OUT under the same paths. The bytes are the same from every engine and number of shares.";

constexpr const char* kSubmitFooter =
    "Examples:\n"
    "  edvo submit rooms.toml --out rooms --dry-run\n"
    "  edvo submit rooms.toml --out rooms --shards 200 --throttle 50 --time-min 60\n"
    "  edvo submit rooms.toml --out rooms --resume\n"
    "  edvo submit rooms.toml --out rooms --sbatch-option='--partition=cpu --account=vision'\n"
    "  edvo submit rooms.toml --out rooms --engine local\n"
    "  edvo submit --test scenarios --seeds 20 --out night\n"
    "  edvo submit --sweep scenarios/a.toml --set path.rate=10,15,30 --seeds 20 --out rates\n\n"
    "Exit codes: 0 submitted, or made (parallel, local); 3 unusable input, or an engine that is "
    "not\n"
    "here; 6 jobs of it are queued or running, or OUT is there; parallel and local end as edvo\n"
    "dataset merge, edvo test and edvo sweep do.";

struct SubmitArguments {
  std::string spec;
  std::vector<std::string> tested;       ///< scenarios
  std::vector<std::string> swept;        ///< scenarios
  std::vector<std::string> assignments;  ///< of the sweep, key=value,value
  std::string out;
  std::string engine = "slurm";
  std::size_t shards = 0;  ///< 0 = not given
  int jobs = 0;            ///< 0 = not given
  bool dry_run = false;
  bool resume = false;
  bool force = false;
  std::vector<std::string> sbatch_options;
  BatchOptions batch;
  int seeds = 1;
  bool slow = false;
  std::string tracker;
  std::string cache;

  SubmitEngine chosen_engine() const { return vo::parse_enum<SubmitEngine>(engine); }
  const std::vector<std::string>& scenarios() const { return swept.empty() ? tested : swept; }
};

/// The work of a submission, and those of its shares that are to be made.
struct OpenWork {
  SharedWork work;
  std::vector<std::size_t> shares;
};

/// Throws where an option is given that the engine has no use for.
void refuse_ignored(const CLI::App& command, SubmitEngine engine) {
  std::vector<const char*> ignored;
  if (engine != SubmitEngine::slurm) {
    ignored = {"--throttle", "--max-array", "--time-min", "--memory", "--sbatch-option"};
  }
  if (engine == SubmitEngine::local) {
    ignored.push_back("--shards");
  }
  for (const char* option : ignored) {
    if (command.count(option) > 0) {
      vo::fail_as(vo::ErrorKind::usage, option, ": the engine ", vo::to_string(engine),
                  " has no use for it; expected it with --engine ",
                  option == std::string("--shards") ? "slurm or parallel" : "slurm", " alone");
    }
  }
}

void complete_submit(SubmitArguments& arguments) {
  const std::size_t kinds = std::size_t{!arguments.spec.empty()} +
                            std::size_t{!arguments.tested.empty()} +
                            std::size_t{!arguments.swept.empty()};
  if (kinds != 1) {
    vo::fail_as(vo::ErrorKind::usage,
                "expected one of SPEC, --test SCENARIOS and --sweep SCENARIOS");
  }
  if (arguments.jobs > 0) {
    arguments.batch.cpus = arguments.jobs;
  }
  check_usage([&] {
    arguments.batch.validate();
    for (const std::string& text : arguments.sbatch_options) {
      for (std::string& word : split_words(text)) {
        arguments.batch.others.push_back(std::move(word));
      }
    }
  });
}

/// Returns how many shares there are: as the user says, as in the submit that is resumed, or as
/// `otherwise` has it.
template <typename Otherwise>
std::size_t number_of_shares(const SubmitArguments& arguments,
                             const std::optional<JobRecord>& earlier, Otherwise otherwise) {
  if (arguments.shards > 0) {
    return arguments.shards;
  }
  return arguments.resume && earlier ? earlier->shares : otherwise();
}

DatasetJob dataset_job(const SubmitArguments& arguments) {
  return {.program = own_program(),
          .spec = fs::absolute(arguments.spec),
          .out = vo::resolved_output(arguments.out),
          .task_threads = arguments.batch.cpus,
          .local_threads = arguments.jobs};
}

OpenWork open_dataset(const SubmitArguments& arguments, const std::optional<JobRecord>& earlier) {
  const DatasetJob job = dataset_job(arguments);
  if (arguments.chosen_engine() == SubmitEngine::local) {
    return {dataset_work(job, 1), all_shares(1)};
  }
  const DatasetSize size =
      plan_dataset(job, arguments.dry_run ? KeepPlan::no : KeepPlan::yes, throw_if_interrupted);
  const std::size_t shares =
      number_of_shares(arguments, earlier, [&] { return shares_for(size, job.task_threads); });
  return {dataset_work(job, shares), arguments.resume
                                         ? missing_shares(job, shares, throw_if_interrupted)
                                         : all_shares(shares)};
}

/// Returns into how many shares trials are divided: some each, which take a minute or more.
std::size_t shares_of_trials(const SubmitArguments& arguments) {
  constexpr std::size_t kTrialsOfShare = 8;
  const std::vector<fs::path> scenarios =
      find_scenarios({arguments.scenarios().begin(), arguments.scenarios().end()},
                     arguments.slow ? SlowScenarios::include : SlowScenarios::leave_out);
  std::size_t trials = scenarios.size() * static_cast<std::size_t>(arguments.seeds);
  for (const auto& [key, values] : swept_options(arguments.assignments)) {
    trials *= values.size();
  }
  return (trials + kTrialsOfShare - 1) / kTrialsOfShare;
}

/// Returns the options that every call of `edvo test` or `edvo sweep` has.
std::vector<std::string> trials_options(const SubmitArguments& arguments) {
  std::vector<std::string> options{"--seeds", std::to_string(arguments.seeds)};
  for (const std::string& assignment : arguments.assignments) {
    options.insert(options.end(), {"--set", assignment});
  }
  if (arguments.slow) {
    options.emplace_back("--slow");
  }
  if (!arguments.tracker.empty()) {
    options.insert(options.end(), {"--tracker", arguments.tracker});
  }
  if (!arguments.cache.empty()) {
    options.insert(options.end(), {"--cache", fs::absolute(arguments.cache).string()});
  }
  return options;
}

OpenWork open_trials(const SubmitArguments& arguments, const std::optional<JobRecord>& earlier) {
  const std::size_t by_trials = shares_of_trials(arguments);
  TrialsJob job{.program = own_program(),
                .command = arguments.swept.empty() ? TrialsCommand::test : TrialsCommand::sweep,
                .out = vo::resolved_output(arguments.out),
                .folder = fs::current_path(),
                .options = trials_options(arguments),
                .task_jobs = arguments.batch.cpus,
                .local_jobs = arguments.jobs,
                .force = arguments.force};
  for (const std::string& scenario : arguments.scenarios()) {
    job.scenarios.push_back(fs::absolute(scenario));
  }
  if (!arguments.dry_run) {
    fs::create_directories(job.out);
  }
  const std::size_t shares = number_of_shares(arguments, earlier, [&] { return by_trials; });
  return {trials_work(job, shares), arguments.resume
                                        ? missing_shares(job, shares, throw_if_interrupted)
                                        : all_shares(shares)};
}

/// Submits to Slurm, or prints what would be submitted.
void to_slurm(SubmitArguments& arguments, const OpenWork& open, const fs::path& folder,
              const std::optional<SlurmQueue>& queue) {
  if (arguments.batch.max_array == 0) {
    constexpr std::size_t kSlurmsOwn = 1001;  // where nobody has set MaxArraySize
    arguments.batch.max_array = queue ? queue->max_array_size() : kSlurmsOwn;
  }
  const Submission submission = slurm_submission(open.work, open.shares, folder, arguments.batch);
  if (arguments.dry_run) {
    std::cout << describe(submission);
    return;
  }
  JobRecord record{.work = open.work.name, .shares = open.work.shares, .jobs = {}};
  submit_to_slurm(submission, *queue, record);
  for (const SubmittedJob& job : record.jobs) {
    std::cout << "job " << job.id << ": " << job.name
              << (job.shares.empty() ? "" : ", shares " + job.shares) << "\n";
  }
  std::cout << "scripts and logs are in " << folder.string() << "\n";
}

/// Runs the work by another engine, or prints what would be run; returns the exit code.
int to_others(const SubmitArguments& arguments, const OpenWork& open, const fs::path& folder) {
  const Submission submission =
      arguments.chosen_engine() == SubmitEngine::local
          ? local_submission(open.work)
          : parallel_submission(open.work, open.shares, folder, arguments.jobs);
  if (arguments.dry_run) {
    std::cout << describe(submission);
    return exit_code::kOk;
  }
  return run_here(submission, throw_if_interrupted);
}

/// Returns a lock that keeps others from submitting to the same folder meanwhile.
vo::OutputLock sole_submission(const fs::path& folder) {
  std::optional<vo::OutputLock> lock = vo::OutputLock::try_lock(folder, vo::LockKind::exclusive);
  if (!lock) {
    vo::fail_as(vo::ErrorKind::output_exists, folder.string(),
                ": another process submits to it; expected one at a time");
  }
  return std::move(*lock);
}

/// Returns whether a data set is to be resumed that is there, so that there is nothing to do.
/// Throws where one that is there is to be made, or something else is in its place.
bool is_made(const SubmitArguments& arguments) {
  if (arguments.spec.empty() || !fs::exists(arguments.out)) {
    return false;
  }
  if (!arguments.resume) {
    vo::fail_as(vo::ErrorKind::output_exists, arguments.out,
                ": is there already; expected a data set to make (edvo dataset verify checks one)");
  }
  return missing_shares(dataset_job(arguments), 1, throw_if_interrupted).empty();
}

/// Returns Slurm's queue where it is asked for; a dry run does without. Throws vo::Error where the
/// engine is not here, before anything is written.
std::optional<SlurmQueue> queue_of(const SubmitArguments& arguments) {
  const SubmitEngine engine = arguments.chosen_engine();
  std::optional<SlurmQueue> queue;
  if (engine == SubmitEngine::slurm && (!arguments.dry_run || is_in_path("sbatch"))) {
    queue.emplace(throw_if_interrupted);
  } else if (!arguments.dry_run) {
    require_runnable(engine);
  }
  return queue;
}

int submit(SubmitArguments& arguments) {
  complete_submit(arguments);
  const fs::path folder = submission_folder(arguments.out);
  if (!arguments.dry_run) {
    vo::tidy_up_beside(folder);
    vo::tidy_up_beside(vo::resolved_output(arguments.out));
  }
  if (is_made(arguments)) {
    std::cout << arguments.out << ": is there, nothing is missing\n";
    return exit_code::kOk;
  }
  const std::optional<SlurmQueue> queue = queue_of(arguments);
  const std::optional<vo::OutputLock> lock =
      arguments.dry_run ? std::optional<vo::OutputLock>() : sole_submission(folder);
  const std::optional<JobRecord> earlier = read_job_record(folder);
  if (earlier && queue && !arguments.dry_run) {
    require_none_queued(*earlier, *queue);
  }
  const OpenWork open =
      arguments.spec.empty() ? open_trials(arguments, earlier) : open_dataset(arguments, earlier);
  if (arguments.chosen_engine() == SubmitEngine::slurm) {
    to_slurm(arguments, open, folder, queue);
    return exit_code::kOk;
  }
  return to_others(arguments, open, folder);
}

void add_batch_options(CLI::App& command, SubmitArguments& arguments) {
  BatchOptions& batch = arguments.batch;
  const char* group = "Slurm";
  command.add_option("--throttle", batch.throttle, "tasks at once [as many as there is room for]")
      ->group(group);
  command.add_option("--max-array", batch.max_array, "its MaxArraySize [as scontrol says]")
      ->group(group);
  command.add_option("--time-min", batch.minutes, "time limit of a task, min [the partition's]")
      ->group(group);
  command.add_option("--memory", batch.memory, "of a task, MB")
      ->group(group)
      ->capture_default_str();
  command
      .add_option("--sbatch-option", arguments.sbatch_options,
                  "options of sbatch, quoted as for a shell; repeatable")
      ->allow_extra_args(false)
      ->group(group);
}

void add_trials_options(CLI::App& command, SubmitArguments& arguments) {
  const char* group = "With --test or --sweep, as of edvo test and edvo sweep";
  command
      .add_option("--set", arguments.assignments,
                  "with --sweep: key=a,b,c of the scenario, repeatable")
      ->allow_extra_args(false)
      ->needs("--sweep");
  command.get_option("--sweep")->needs("--set");
  command.add_option("--seeds", arguments.seeds, "with so many random numbers each [1]")
      ->check(at_least_one());
  command.add_option("--cache", arguments.cache, "folder of the cache, which all machines see");
  command.add_flag("--slow", arguments.slow, "with --test: also those marked slow")
      ->needs("--test");
  command.add_option("--tracker", arguments.tracker, "with --test: test this program")
      ->needs("--test");
  command
      .add_flag("--force", arguments.force,
                "with --sweep: replace a table that is there and differs")
      ->needs("--sweep");
  for (const char* name : {"--set", "--seeds", "--cache", "--slow", "--tracker", "--force"}) {
    command.get_option(name)->group(group);
  }
  for (const char* name : {"--seeds", "--cache"}) {
    command.get_option(name)->excludes("SPEC");
  }
}

}  // namespace

void add_submit_command(CLI::App& program, Session& session) {
  CLI::App& command = *program.add_subcommand("submit", kSubmitHelp);
  const auto arguments = std::make_shared<SubmitArguments>();
  command.footer(kSubmitFooter);
  command.add_option("SPEC", arguments->spec, "file that describes a data set, .toml");
  command.add_option("--test", arguments->tested,
                     "scenario files or folders to test, in place of SPEC; results are in OUT");
  command.add_option("--sweep", arguments->swept,
                     "scenario files or folders to sweep, likewise; the table is in OUT");
  command.add_option("--out", arguments->out, "folder that is made")->required();
  command.add_option("--engine", arguments->engine, "slurm, parallel or local [slurm]")
      ->check(is_name_of<SubmitEngine>());
  command
      .add_option("--shards", arguments->shards,
                  "number of shares [so that each takes some minutes; with --resume as before]")
      ->check(at_least_one());
  command
      .add_option("--jobs,-j", arguments->jobs,
                  "slurm: CPUs of a task [1]; parallel: shares at a time, local: threads [cores]")
      ->check(at_least_one());
  command.add_flag("--dry-run", arguments->dry_run,
                   "print scripts and commands; write and submit nothing");
  command.add_flag("--resume", arguments->resume, "only the shares of which something is missing");
  add_batch_options(command, *arguments);
  add_trials_options(command, *arguments);
  take_streams(command, {.read = {"SPEC", "--test", "--sweep"}, .others = {"--out", "--cache"}});
  command.callback([arguments, &command, &session] {
    refuse_ignored(command, arguments->chosen_engine());
    session.status = submit(*arguments);
  });
}

}  // namespace tools
