#pragma once

#include <cstdint>
#include <string>

namespace tools {

/// A cluster, the file system that its nodes share, and what the frames of a data set cost on it.
/// A rate of 0 is no limit, and a time between failures of 0 is no failure.
struct ClusterOptions {
  int nodes = 10;
  int processors = 64;           ///< per node
  int task_processors = 1;       ///< per task, which renders so many frames at a time
  double mtbf_h = 5000;          ///< mean time between failures of a node, h
  double repair_s = 600;         ///< until a failed node takes tasks again, s
  double requeue_s = 120;        ///< until a task of a failed node is queued again, s
  double scheduler_per_s = 3;    ///< tasks that the queue starts in a second
  double start_s = 0.1;          ///< from a task's start until it reads its first scene, s
  double scene_s = 1;            ///< loading of a scene, once in a task, s
  double scene_mb = 50;          ///< size of what is read of a scene, MB
  double frame_s = 0.05;         ///< rendering, processor time per frame, s
  double write_s = 0.01;         ///< encoding, writing and checksums, processor time per frame, s
  double frame_mb = 0.5;         ///< size of a frame's files, MB
  double frame_files = 2;        ///< number of a frame's files
  int task_parts = 1;            ///< parts that a task makes, one after the other
  double bandwidth_mb_s = 1000;  ///< of the file system, all nodes together, MB/s
  double files_per_s = 5000;     ///< files that it makes in a second, all nodes together
  double merge_files_per_s = 0;  ///< files that the merge handles in a second
  std::uint64_t seed = 1;        ///< of the failures

  void validate() const;  ///< throws vo::Error on an invalid option

  int tasks_per_node() const { return processors / task_processors; }
};

template <typename Visitor>
void visit_fields(Visitor& visit, ClusterOptions& options) {
  visit("nodes", options.nodes, "of the cluster");
  visit("processors", options.processors, "per node");
  visit("task_processors", options.task_processors, "per task");
  visit("mtbf_h", options.mtbf_h, "mean time between failures of a node, h; 0 = none fails");
  visit("repair_s", options.repair_s, "until a failed node takes tasks again, s");
  visit("requeue_s", options.requeue_s, "until a failed node's task is queued again, s");
  visit("scheduler_per_s", options.scheduler_per_s, "tasks started in a second; 0 = any number");
  visit("start_s", options.start_s, "start of a task, s");
  visit("scene_s", options.scene_s, "loading of a scene, once in a task, s");
  visit("scene_mb", options.scene_mb, "read for it, MB");
  visit("frame_s", options.frame_s, "rendering, processor time per frame, s");
  visit("write_s", options.write_s, "encoding, writing, checksums, processor time per frame, s");
  visit("frame_mb", options.frame_mb, "written per frame, MB");
  visit("frame_files", options.frame_files, "written per frame");
  visit("task_parts", options.task_parts, "parts per task");
  visit("bandwidth_mb_s", options.bandwidth_mb_s, "of the shared file system, MB/s; 0 = any");
  visit("files_per_s", options.files_per_s, "made on the shared file system; 0 = any number");
  visit("merge_files_per_s", options.merge_files_per_s, "merged in a second; 0 = any number");
  visit("seed", options.seed, "of the failures");
}

/// Sets the options that a text names, `nodes=1000,mtbf_h=5000`. Throws vo::Error of kind usage
/// beginning with `--simulate`.
void set_cluster_options(const std::string& text, ClusterOptions& options);

}  // namespace tools
