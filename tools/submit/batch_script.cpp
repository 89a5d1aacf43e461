#include "tools/submit/batch_script.h"

#include "tools/cli/task_share.h"
#include "vo/core/error.h"

namespace tools {
namespace {

/// What a script does after it has started its command behind it: Slurm's signal reaches the shell
/// alone, which hands it on and waits again, as often as a signal has interrupted it; and a command
/// that ends with 75, which can go on later, or by the signal, which it did not listen to yet, is
/// queued again. Slurm gives a task that is cancelled or preempted another state than running; such
/// a one is not for the task itself to queue.
constexpr const char* kHandOver = R"(child=$!
((told)) && kill -TERM "$child"
while
  told=0
  wait "$child"
  code=$?
  ((told))
do :; done
echo "$(date -u +%FT%TZ) exit code $code"
if ((code == 75 || code == 143)) && ((${SLURM_RESTART_COUNT:-0} < 20)) && [[ $(squeue -h -j "$job" -o %T) == RUNNING ]]; then
  scontrol requeue "$job"
fi
exit "$code"
)";

constexpr const char* kTrap =
    "child=\n"
    "told=0\n"
    "trap 'told=1; [[ -z $child ]] || kill -TERM \"$child\" 2>/dev/null' TERM\n";

/// Returns the lines that begin a script, `special` among the options.
std::string batch_header(const SharedWork& work, const std::string& special,
                         const BatchOptions& options) {
  std::string text =
      vo::concat("#!/bin/bash\n#SBATCH --job-name=", job_name(work.name), "\n", special,
                 "#SBATCH --open-mode=append\n#SBATCH --requeue\n",
                 "#SBATCH --signal=B:TERM@60\n#SBATCH --cpus-per-task=", options.cpus,
                 "\n#SBATCH --mem=", options.memory, "M\n");
  if (options.minutes > 0) {
    text += vo::concat("#SBATCH --time=", options.minutes, "\n");
  }
  return text;
}

std::string body(const SharedWork& work, const std::string& what, const std::string& command) {
  return vo::concat(kTrap, "echo \"$(date -u +%FT%TZ) ", what,
                    ", job $SLURM_JOB_ID, node $SLURMD_NODENAME, restart "
                    "${SLURM_RESTART_COUNT:-0}\"\ncd -- ",
                    shell_line({work.folder.string()}), " || exit 3\n", command, " &\n", kHandOver);
}

}  // namespace

void BatchOptions::validate() const {
  vo::require(cpus > 0, "--jobs is ", cpus, ", expected at least 1");
  vo::require(memory > 0, "--memory is ", memory, ", expected MB");
  vo::require(minutes >= 0, "--time-min is ", minutes, ", expected minutes");
  vo::require(max_array == 0 || max_array > 1, "--max-array is ", max_array,
              ", expected MaxArraySize, at least 2");
}

std::string array_script(const SharedWork& work, const ArrayChunk& chunk, const std::string& name,
                         const BatchOptions& options) {
  std::string special = "#SBATCH --array=" + array_text(chunk.indices);
  if (options.throttle > 0) {
    special += vo::concat("%", options.throttle);
  }
  special += "\n#SBATCH --output=log/" + name + "/%a.log\n";
  const std::string share = chunk.offset == 0
                                ? "$SLURM_ARRAY_TASK_ID"
                                : vo::concat("$((SLURM_ARRAY_TASK_ID + ", chunk.offset, "))");
  return batch_header(work, special, options) + "share=" + share +
         "\njob=${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID\n" +
         body(work, vo::concat("share $share/", work.shares),
              vo::concat(shell_line(work.share), " --shard \"$share/", work.shares, "\""));
}

std::string finish_script(const SharedWork& work, const BatchOptions& options) {
  return batch_header(work, "#SBATCH --output=log/" + work.finish_name + ".log\n", options) +
         "job=$SLURM_JOB_ID\n" + body(work, work.finish_name, shell_line(work.finish));
}

}  // namespace tools
