#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/cli/exit_code.h"
#include "tools/cli/interrupt.h"
#include "tools/cli/options.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/standard_streams.h"
#include "tools/cli/task_share.h"
#include "tools/cluster_simulation/simulate.h"
#include "tools/commands/commands.h"
#include "tools/datasets/estimate.h"
#include "tools/datasets/layout.h"
#include "tools/datasets/merging/merge.h"
#include "tools/datasets/merging/verify.h"
#include "tools/datasets/parts/part_maker.h"
#include "tools/datasets/plan.h"
#include "tools/datasets/spec.h"
#include "tools/json/document.h"
#include "tools/plot/table.h"
#include "vo/core/error.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDatasetHelp =
    "Makes data sets of many sequences, which one file describes: every scene with every path,\n"
    "sensor and seed. The work is cut into parts, some hundred frames of one sequence each, which\n"
    "any number of processes and machines make: each takes a share, all write below OUT.part, by\n"
    "renames alone, and `merge` makes OUT of them. The bytes are the same however it was shared.";

constexpr const char* kDatasetExamples =
    "Examples:\n"
    "  edvo dataset plan rooms.toml\n"
    "  edvo dataset render rooms.toml --out rooms\n"
    "  for k in 1 2 3 4; do edvo dataset render rooms.toml --out rooms --shard $k/4 & done; wait\n"
    "  edvo dataset status rooms.toml --out rooms\n"
    "  edvo dataset merge rooms.toml --out rooms\n"
    "  edvo dataset verify rooms";

struct DatasetArguments {
  CommonOptions common;
  std::string spec;
  std::string out;
  std::string shard;
  std::size_t shards = 0;  ///< 0 = not given
  std::size_t cores = 0;   ///< 0 = those of this machine
  std::string simulate;    ///< options of a cluster; empty = none is simulated
};

constexpr double kSecondsPerHour = 3600;

void print_json(const char* schema, const nlohmann::ordered_json& members) {
  std::cout << json_text(json_document({schema}, members));
}

/// Returns the plan that OUT.part keeps, which it begins where there is none.
DatasetPlan begun(const DatasetArguments& arguments, const DatasetSpec& spec,
                  const DatasetLayout& layout, ProgressBar& bar) {
  bar.announce("planning");
  return begin_dataset(spec, layout.plan(), arguments.common.output_policy().durability,
                       bar.callback("planning"));
}

/// Returns the plan that OUT.part keeps, or makes it and keeps it nowhere.
DatasetPlan known_plan(const DatasetSpec& spec, const DatasetLayout& layout, ProgressBar& bar) {
  return fs::exists(layout.plan())
             ? begin_dataset(spec, layout.plan(), vo::Durability::unsynced, {})
             : make_plan(spec, bar.callback("planning"));
}

nlohmann::ordered_json plan_json(const DatasetSpec& spec, const DatasetPlan& plan,
                                 const DatasetEstimate& estimate, std::size_t cores) {
  nlohmann::ordered_json rejected = nlohmann::ordered_json::array();
  for (const RejectedSequence& sequence : plan.rejected) {
    rejected.push_back({{"name", sequence.name}, {"reason", sequence.reason}});
  }
  return {{"name", spec.options.name},
          {"sequences", plan.sequence_count()},
          {"frames", plan.frame_count()},
          {"parts", plan.parts.size()},
          {"files", estimate.files},
          {"bytes", std::round(estimate.bytes)},
          {"cpu_s", estimate.processor_s},
          {"measured_frames", estimate.measured},
          {"cores", cores},
          {"wall_s", estimate.processor_s / static_cast<double>(cores)},
          {"rejected", rejected}};
}

void print_plan(const DatasetSpec& spec, const DatasetPlan& plan, const DatasetEstimate& estimate,
                std::size_t cores, const Colours& colours) {
  for (const RejectedSequence& sequence : plan.rejected) {
    std::cout << colours.paint(Tone::caution, "left out") << ": " << sequence.name << ": "
              << sequence.reason << "\n";
  }
  const double hours = estimate.processor_s / kSecondsPerHour;
  std::cout << "sequences  " << plan.sequence_count() << " of " << spec.sequences.size() << "\n"
            << "frames     " << plan.frame_count()
            << (spec.rig ? vo::concat(" of ", plan.cameras, " cameras\n") : "\n") << "parts      "
            << plan.parts.size() << "\n"
            << "files      " << estimate.files << "\n"
            << "size       " << format_decimals(estimate.bytes / kBytesPerMegabyte, 1) << " MB\n"
            << "CPU time   " << format_decimals(hours, 3) << " h, as " << estimate.measured
            << " of the frames take\n"
            << "wall time  " << format_decimals(hours / static_cast<double>(cores), 3) << " h on "
            << cores << (cores == 1 ? " core\n" : " cores\n");
}

/// An array job of a data set on a cluster.
struct SimulatedJob {
  ClusterOptions cluster;
  ClusterRun run;
};

/// Returns how the cluster that --simulate describes makes the parts. What frames cost is as
/// measured, unless the text says otherwise.
std::optional<SimulatedJob> simulated(const DatasetArguments& arguments, const DatasetPlan& plan,
                                      const DatasetEstimate& estimate) {
  const auto frames = static_cast<double>(plan.frame_count());
  if (arguments.simulate.empty() || frames == 0) {
    return {};
  }
  SimulatedJob job;
  job.cluster.frame_s = estimate.processor_s / frames;
  job.cluster.write_s = 0;  // in what was measured
  job.cluster.frame_mb = estimate.bytes / kBytesPerMegabyte / frames;
  job.cluster.frame_files = static_cast<double>(estimate.files) / frames;
  set_cluster_options(arguments.simulate, job.cluster);
  std::vector<std::size_t> parts;
  for (const DatasetPart& part : plan.parts) {
    parts.push_back(plan.cameras * part.frame_count());
  }
  job.run = simulate_cluster(job.cluster, parts, throw_if_interrupted);
  return job;
}

void plan(const DatasetArguments& arguments, Session& session) {
  ClusterOptions checked;
  set_cluster_options(arguments.simulate, checked);
  const auto limit = arguments.common.limit_threads();
  ProgressBar bar("planning", arguments.common.verbosity());
  bar.announce("reading " + arguments.spec);
  const DatasetSpec spec = load_dataset_spec(arguments.spec);
  const DatasetPlan made = arguments.out.empty()
                               ? make_plan(spec, bar.callback())
                               : begun(arguments, spec, DatasetLayout(arguments.out), bar);
  const DatasetEstimate estimate = estimate_dataset(spec, made, bar.callback("measuring"));
  bar.erase();
  const std::size_t cores = arguments.cores == 0 ? arguments.common.max_threads() : arguments.cores;
  const std::optional<SimulatedJob> job = simulated(arguments, made, estimate);
  if (arguments.common.json) {
    nlohmann::ordered_json members = plan_json(spec, made, estimate, cores);
    if (job) {
      members["simulation"] = cluster_run_json(job->cluster, job->run);
    }
    print_json("dataset_estimate", members);
    return;
  }
  print_plan(spec, made, estimate, cores, session.out);
  if (job) {
    std::cout << "\n" << format_cluster_run(job->cluster, job->run);
  }
}

/// Makes the parts of a share that are not there; returns how many it made.
std::size_t make_share(const DatasetPlan& plan, const std::vector<std::size_t>& share,
                       PartMaker& maker, ProgressBar& bar) {
  std::size_t frames = 0;
  for (const std::size_t part : share) {
    frames += plan.cameras * plan.parts[part].frame_count();
  }
  std::size_t before = 0;
  std::size_t made = 0;
  const vo::Progress progress = bar.callback("rendering");
  for (const std::size_t part : share) {
    throw_if_interrupted();
    if (!maker.is_there(part)) {
      maker.make(part,
                 [&](std::size_t done, std::size_t /*total*/) { progress(before + done, frames); });
      ++made;
    }
    before += plan.cameras * plan.parts[part].frame_count();
  }
  return made;
}

void render(const DatasetArguments& arguments, Session& session) {
  const auto limit = arguments.common.limit_threads();
  const TaskShare task = chosen_share(arguments.shard, arguments.shards);
  ProgressBar bar("rendering", arguments.common.verbosity());
  bar.announce("reading " + arguments.spec);
  const DatasetSpec spec = load_dataset_spec(arguments.spec);
  const DatasetLayout layout(arguments.out);
  const bool is_there = fs::exists(layout.out) && !fs::exists(layout.plan());
  const DatasetPlan plan =
      is_there ? make_plan(spec, bar.callback("planning")) : begun(arguments, spec, layout, bar);
  const std::vector<std::size_t> share = share_of_parts(plan, task.task, task.tasks);
  std::size_t made = 0;
  if (!is_merged(spec, plan, layout)) {
    PartMaker maker(spec, plan, layout, arguments.common.output_policy().durability);
    made = make_share(plan, share, maker, bar);
  }
  bar.erase();
  if (!plan.rejected.empty() && !arguments.common.quiet) {
    std::cerr << session.err.paint(Tone::caution, "note") << ": " << plan.rejected.size() << " of "
              << spec.sequences.size() << " sequences are left out, `edvo dataset plan` says why\n";
  }
  const std::size_t missing = is_there ? 0 : missing_parts(spec, plan, layout).size();
  if (arguments.common.json) {
    print_json("dataset_render", {{"dataset", arguments.out},
                                  {"shard", task.task},
                                  {"shards", task.tasks},
                                  {"parts", share.size()},
                                  {"made", made},
                                  {"missing", missing}});
    return;
  }
  std::cout << arguments.out << ": share " << task.task << " of " << task.tasks << ": "
            << share.size() << " parts, of which " << share.size() - made << " were there; "
            << (missing == 0 ? "all are there, merge makes the data set\n"
                             : vo::concat(missing, " of ", plan.parts.size(), " are missing\n"));
}

void status(const DatasetArguments& arguments, Session& session) {
  const DatasetSpec spec = load_dataset_spec(arguments.spec);
  const DatasetLayout layout(arguments.out);
  ProgressBar bar("planning", arguments.common.verbosity());
  const DatasetPlan plan = known_plan(spec, layout, bar);
  bar.erase();
  const std::vector<std::size_t> missing = is_merged(spec, plan, layout)
                                               ? std::vector<std::size_t>()
                                               : missing_parts(spec, plan, layout);
  const std::size_t shards = std::max<std::size_t>(arguments.shards, 1);
  const std::string shares = array_text(shares_with(plan, missing, shards));
  if (arguments.common.json) {
    nlohmann::ordered_json names = nlohmann::ordered_json::array();
    for (const std::size_t part : missing) {
      names.push_back(part_name(spec, plan.parts[part]));
    }
    print_json("dataset_status", {{"dataset", arguments.out},
                                  {"parts", plan.parts.size()},
                                  {"there", plan.parts.size() - missing.size()},
                                  {"missing", names},
                                  {"shards", shards},
                                  {"missing_shards", shares}});
  } else {
    std::cout << arguments.out << ": " << plan.parts.size() - missing.size() << " of "
              << plan.parts.size() << " parts are there"
              << (missing.empty() ? "" : "; shares that lack one: " + shares) << "\n";
  }
  session.status = missing.empty() ? exit_code::kOk : exit_code::kMissing;
}

/// Says which parts were removed and what stays where the data set was made.
void print_notes(const DatasetLayout& layout, const MergeOutcome& outcome, const Colours& colours) {
  for (const std::string& damage : outcome.damaged) {
    std::cerr << colours.paint(Tone::caution, "removed") << ": " << damage << "\n";
  }
  for (const std::string& name : outcome.left) {
    std::cerr << colours.paint(Tone::caution, "note") << ": " << (layout.staging / name).string()
              << " is not edvo's and stays there\n";
  }
}

void merge(const DatasetArguments& arguments, Session& session) {
  const auto limit = arguments.common.limit_threads();
  ProgressBar bar("merging", arguments.common.verbosity());
  bar.announce("reading " + arguments.spec);
  const DatasetSpec spec = load_dataset_spec(arguments.spec);
  const DatasetLayout layout(arguments.out);
  const std::optional<vo::OutputLock> alone = lock_merge(layout, throw_if_interrupted);
  const DatasetPlan plan = known_plan(spec, layout, bar);
  const MergeOutcome outcome = merge_dataset(
      spec, plan, layout, arguments.common.output_policy().durability, bar.callback("verifying"));
  bar.erase();
  print_notes(layout, outcome, session.err);
  if (arguments.common.json) {
    print_json("dataset_merge", {{"dataset", arguments.out},
                                 {"was_there", outcome.was_there},
                                 {"missing", outcome.missing.size()},
                                 {"damaged", outcome.damaged},
                                 {"left", outcome.left},
                                 {"files", outcome.files},
                                 {"bytes", outcome.bytes}});
  } else if (!outcome.missing.empty()) {
    std::cout << arguments.out << ": " << outcome.missing.size() << " of " << plan.parts.size()
              << " parts are missing, `edvo dataset render` makes them\n";
  } else {
    std::cout << arguments.out << ": " << plan.sequence_count() << " sequences, "
              << plan.frame_count() << " frames"
              << (outcome.was_there
                      ? ", there already\n"
                      : vo::concat(", ", outcome.files, " files, ",
                                   format_decimals(
                                       static_cast<double>(outcome.bytes) / kBytesPerMegabyte, 1),
                                   " MB\n"));
  }
  session.status = outcome.missing.empty() ? exit_code::kOk : exit_code::kMissing;
}

void verify(const DatasetArguments& arguments, Session& session) {
  const auto limit = arguments.common.limit_threads();
  ProgressBar bar("verifying", arguments.common.verbosity());
  bar.announce();
  const Verification verification = verify_dataset(arguments.out, bar.callback());
  bar.erase();
  if (arguments.common.json) {
    print_json("dataset_verify", {{"dataset", arguments.out},
                                  {"files", verification.files},
                                  {"bytes", verification.bytes},
                                  {"problems", verification.problems}});
  } else {
    const std::size_t count = verification.problems.size();
    for (const std::string& problem : verification.problems) {
      std::cout << session.out.paint(Tone::bad, "differs") << ": " << problem << "\n";
    }
    std::cout << arguments.out << ": " << verification.files << " files, "
              << format_decimals(static_cast<double>(verification.bytes) / kBytesPerMegabyte, 1)
              << " MB, "
              << (count == 0 ? "all as they were made\n"
                             : vo::concat(count, count == 1 ? " problem\n" : " problems\n"));
  }
  session.status = verification.problems.empty() ? exit_code::kOk : exit_code::kBoundViolated;
}

/// Adds an action with the arguments that all but `verify` have.
CLI::App& add_action(CLI::App& command, const std::shared_ptr<DatasetArguments>& arguments,
                     const std::pair<const char*, const char*>& name_and_help,
                     void (*action)(const DatasetArguments&, Session&), Session& session) {
  CLI::App& sub = *command.add_subcommand(name_and_help.first, name_and_help.second);
  sub.add_option("SPEC", arguments->spec, "file that describes the data set, .toml")->required();
  sub.add_option("--out", arguments->out, "folder of the data set")->required(action != plan);
  add_common_options(sub, arguments->common);
  sub.callback([arguments, action, &session] { action(*arguments, session); });
  return sub;
}

void add_shards_option(CLI::App& sub, const std::shared_ptr<DatasetArguments>& arguments) {
  sub.add_option("--shards", arguments->shards, "number of shares that the work is cut into")
      ->check(at_least_one());
}

}  // namespace

void add_dataset_command(CLI::App& program, Session& session) {
  CLI::App& command = *program.add_subcommand("dataset", kDatasetHelp);
  const auto arguments = std::make_shared<DatasetArguments>();
  command.footer(kDatasetExamples);
  command.require_subcommand(1);
  CLI::App& planning = add_action(
      command, arguments,
      {"plan", "what will be made: sequences, frames, size, time; what is left out and why"}, plan,
      session);
  planning.add_option("--cores", arguments->cores, "to tell the wall time for [this machine's]");
  ClusterOptions cluster;
  planning.add_option("--simulate", arguments->simulate,
                      "an array job on a cluster, nodes=1000,mtbf_h=5000,...; keys and defaults "
                      "are below");
  planning.footer("Options of --simulate; those of a frame's cost are as measured unless given:\n" +
                  describe_fields(vo::fields_of(cluster)));
  CLI::App& rendering =
      add_action(command, arguments,
                 {"render", "makes a share of the parts below OUT.part; all without --shard"},
                 render, session);
  rendering.add_option("--shard", arguments->shard,
                       "K/N, only the K-th of N shares, K from 1; with --shards N alone K is the\n"
                       "number of this task in an array of a queue: SLURM_ARRAY_TASK_ID,\n"
                       "SGE_TASK_ID, PBS_ARRAY_INDEX");
  add_shards_option(rendering, arguments);
  add_shards_option(add_action(command, arguments,
                               {"status", "which parts are there; exit code 5 where some are not"},
                               status, session),
                    arguments);
  add_action(command, arguments,
             {"merge",
              "makes OUT of the parts, with index, card and checksums; exit code 5 where\n"
              "parts are missing"},
             merge, session);
  CLI::App& verifying = *command.add_subcommand(
      "verify", "reads every file of a data set; exit code 4 where one is not as it was made");
  verifying.add_option("DATASET", arguments->out, "folder of a data set")->required();
  add_common_options(verifying, arguments->common);
  verifying.callback([arguments, &session] { verify(*arguments, session); });
}

}  // namespace tools
