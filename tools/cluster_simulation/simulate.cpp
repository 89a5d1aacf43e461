#include "tools/cluster_simulation/simulate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <set>

#include "tools/cluster_simulation/event_queue.h"
#include "tools/cluster_simulation/shared_file_system.h"
#include "vo/core/error.h"
#include "vo/core/hash.h"

namespace tools {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

enum class Phase { waiting, starting, loading, rendering };

struct Task {
  std::size_t next = 0;  ///< first part that is not done
  std::size_t end = 0;   ///< one past the last part
  Phase phase = Phase::waiting;
  std::size_t node = 0;
  double begun = 0;       ///< of the phase, by the clock that it goes by, s
  std::size_t epoch = 0;  ///< number of phases begun or broken off; tells its event from older ones
};

struct Node {
  std::size_t room = 0;  ///< number of tasks that it can take
  bool is_down = false;
  std::size_t failures = 0;
  std::set<std::size_t> tasks;
};

/// What happens to a task or a node.
struct ClusterEvent {
  enum class Kind { phase_over, task_eligible, node_fails, node_is_back } kind;
  std::size_t index = 0;  ///< of the task or the node
  std::size_t epoch = 0;  ///< of the task
};

/// The state of the cluster while time goes on.
class Simulation {
 public:
  Simulation(const ClusterOptions& options, const std::vector<std::size_t>& frames_of_parts);

  ClusterRun run(const vo::WaitObserver& waiting);

 private:
  using Kind = ClusterEvent::Kind;

  double duration_of(const Task& task) const;
  bool is_slowed(Phase phase) const;
  double clock_of(Phase phase) const { return is_slowed(phase) ? slowed_now_ : now_; }
  bool can_dispatch() const { return !queue_.empty() && !nodes_with_room_.empty(); }

  void advance(double time);
  void step();
  void handle(const ClusterEvent& event);
  void dispatch();
  void begin(std::size_t index, Phase phase);
  void leave(const Task& task);
  void end_phase(std::size_t index);
  void finish(std::size_t index);
  void fail(std::size_t index);
  void break_off(std::size_t index);
  void plan_failure(std::size_t index);
  void free_room(std::size_t node, std::size_t room);
  std::size_t& count(Phase phase) { return counts_[static_cast<std::size_t>(phase)]; }
  double& time_of(TimeUse use) { return run_.processor_s[static_cast<std::size_t>(use)]; }

  const ClusterOptions& options_;
  const std::vector<std::size_t>& frames_of_parts_;
  SharedFileSystem files_;
  std::vector<Task> tasks_;
  std::vector<Node> nodes_;
  std::deque<std::size_t> queue_;          ///< tasks that could start
  std::set<std::size_t> nodes_with_room_;  ///< those that are up
  EventQueue<ClusterEvent> events_;
  EventQueue<ClusterEvent> slowed_events_;  ///< by the clock that the file system slows
  std::array<std::size_t, 4> counts_{};     ///< of tasks by phase
  std::size_t free_ = 0;                    ///< tasks for which there is room now
  std::size_t down_ = 0;  ///< tasks for which there is room on nodes that are down
  double now_ = 0;
  double slowed_now_ = 0;
  double next_dispatch_ = 0;
  ClusterRun run_;
  std::size_t done_ = 0;
};

Simulation::Simulation(const ClusterOptions& options,
                       const std::vector<std::size_t>& frames_of_parts)
    : options_(options), frames_of_parts_(frames_of_parts), files_(options) {
  const std::size_t parts = frames_of_parts.size();
  const auto at_a_time = static_cast<std::size_t>(options.task_parts);
  for (std::size_t first = 0; first < parts; first += at_a_time) {
    queue_.push_back(tasks_.size());
    tasks_.push_back({.next = first, .end = std::min(first + at_a_time, parts)});
  }
  nodes_.resize(static_cast<std::size_t>(options.nodes));
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    free_room(i, static_cast<std::size_t>(options.tasks_per_node()));
    plan_failure(i);
  }
  run_.parts = parts;
  run_.tasks = tasks_.size();
}

/// Returns how long a task's phase takes at full speed, s.
double Simulation::duration_of(const Task& task) const {
  switch (task.phase) {
    case Phase::starting:
      return options_.start_s;
    case Phase::loading:
      return options_.scene_s;
    case Phase::rendering:
      return static_cast<double>(frames_of_parts_[task.next]) *
             (options_.frame_s + options_.write_s) / options_.task_processors;
    default:
      return kNever;
  }
}

bool Simulation::is_slowed(Phase phase) const {
  return (phase == Phase::loading && files_.slows_loading()) ||
         (phase == Phase::rendering && files_.slows_rendering());
}

/// Lets time go on to the next event, and accounts for it.
void Simulation::advance(double time) {
  const double dt = time - now_;
  const double waiting = dt * (1 - files_.speed());
  const TimeUse reason =
      files_.limit() == FileLimit::bandwidth ? TimeUse::bandwidth : TimeUse::metadata;
  const auto use = [&](Phase phase, TimeUse at_work) {
    const auto tasks = static_cast<double>(count(phase));
    const double held_up = is_slowed(phase) ? waiting : 0;
    time_of(at_work) += tasks * (dt - held_up);
    time_of(reason) += tasks * held_up;
  };
  use(Phase::starting, TimeUse::start);
  use(Phase::loading, TimeUse::scenes);
  use(Phase::rendering, TimeUse::rendering);
  const std::size_t wanted = std::min(free_, queue_.size());
  time_of(TimeUse::scheduler) += static_cast<double>(wanted) * dt;
  time_of(TimeUse::idle) += static_cast<double>(free_ - wanted) * dt;
  time_of(TimeUse::down) += static_cast<double>(down_) * dt;
  slowed_now_ += dt * files_.speed();
  now_ = time;
}

void Simulation::step() {
  const auto is_old = [&](const EventQueue<ClusterEvent>& events) {
    return !events.is_empty() && events.first().kind == Kind::phase_over &&
           events.first().epoch != tasks_[events.first().index].epoch;
  };
  for (EventQueue<ClusterEvent>* events : {&events_, &slowed_events_}) {
    while (is_old(*events)) {
      events->pop();
    }
  }
  const double slowed =
      slowed_events_.is_empty()
          ? kNever
          : now_ + std::max(slowed_events_.time() - slowed_now_, 0.0) / files_.speed();
  const double dispatching = can_dispatch() ? std::max(now_, next_dispatch_) : kNever;
  const double time = std::min({events_.time(), slowed, dispatching});
  advance(time);
  if (time == dispatching) {
    dispatch();
    return;
  }
  EventQueue<ClusterEvent>& events = time == events_.time() ? events_ : slowed_events_;
  const ClusterEvent event = events.first();
  events.pop();
  handle(event);
}

void Simulation::handle(const ClusterEvent& event) {
  switch (event.kind) {
    case Kind::phase_over:
      end_phase(event.index);
      break;
    case Kind::task_eligible:
      queue_.push_back(event.index);
      break;
    case Kind::node_fails:
      fail(event.index);
      break;
    case Kind::node_is_back:
      nodes_[event.index].is_down = false;
      down_ -= nodes_[event.index].room;
      free_room(event.index, 0);
      plan_failure(event.index);
      break;
  }
}

/// Starts the task that has waited longest on the first node with room.
void Simulation::dispatch() {
  const std::size_t index = queue_.front();
  queue_.pop_front();
  const std::size_t place = *nodes_with_room_.begin();
  Node& node = nodes_[place];
  node.tasks.insert(index);
  --node.room;
  --free_;
  if (node.room == 0) {
    nodes_with_room_.erase(place);
  }
  tasks_[index].node = place;
  next_dispatch_ = now_ + (options_.scheduler_per_s > 0 ? 1 / options_.scheduler_per_s : 0);
  begin(index, Phase::starting);
}

void Simulation::begin(std::size_t index, Phase phase) {
  Task& task = tasks_[index];
  task.phase = phase;
  task.begun = clock_of(phase);
  ++task.epoch;
  ++count(phase);
  files_.use(count(Phase::loading), count(Phase::rendering));
  EventQueue<ClusterEvent>& events = is_slowed(phase) ? slowed_events_ : events_;
  events.add(task.begun + duration_of(task), {Kind::phase_over, index, task.epoch});
}

/// Counts a task out of its phase.
void Simulation::leave(const Task& task) {
  --count(task.phase);
  files_.use(count(Phase::loading), count(Phase::rendering));
}

void Simulation::end_phase(std::size_t index) {
  Task& task = tasks_[index];
  leave(task);
  if (task.phase == Phase::starting) {
    begin(index, Phase::loading);
    return;
  }
  if (task.phase == Phase::rendering) {
    ++done_;
    run_.frames += frames_of_parts_[task.next];
    ++task.next;
  }
  if (task.next == task.end) {
    finish(index);
  } else {
    begin(index, Phase::rendering);
  }
}

void Simulation::finish(std::size_t index) {
  Task& task = tasks_[index];
  task.phase = Phase::waiting;
  ++task.epoch;
  nodes_[task.node].tasks.erase(index);
  free_room(task.node, 1);
}

/// Makes more room on a node that is up.
void Simulation::free_room(std::size_t node, std::size_t room) {
  const std::size_t before = nodes_with_room_.contains(node) ? nodes_[node].room : 0;
  nodes_[node].room += room;
  free_ += nodes_[node].room - before;
  if (nodes_[node].room > 0) {
    nodes_with_room_.insert(node);
  }
}

/// Takes a node down, with all tasks on it.
void Simulation::fail(std::size_t index) {
  Node& node = nodes_[index];
  ++node.failures;
  ++run_.failures;
  if (nodes_with_room_.erase(index) > 0) {
    free_ -= node.room;
  }
  for (const std::size_t task : node.tasks) {
    break_off(task);
  }
  node.room += node.tasks.size();
  node.tasks.clear();
  node.is_down = true;
  down_ += node.room;
  events_.add(now_ + options_.repair_s, {Kind::node_is_back, index});
}

void Simulation::break_off(std::size_t index) {
  Task& task = tasks_[index];
  leave(task);
  if (task.phase == Phase::rendering) {
    const double lost = clock_of(task.phase) - task.begun;
    time_of(TimeUse::lost) += lost;
    time_of(TimeUse::rendering) -= lost;
    ++run_.broken_off;
  }
  task.phase = Phase::waiting;
  ++task.epoch;
  ++run_.restarts;
  events_.add(now_ + options_.requeue_s, {Kind::task_eligible, index});
}

/// Draws when a node that is up fails next.
void Simulation::plan_failure(std::size_t index) {
  constexpr double kSecondsPerHour = 3600;
  if (options_.mtbf_h > 0) {
    const double uniform = vo::random_uniform({options_.seed, index, nodes_[index].failures});
    const double life = -std::log1p(-uniform) * options_.mtbf_h * kSecondsPerHour;
    events_.add(now_ + life, {Kind::node_fails, index});
  }
}

ClusterRun Simulation::run(const vo::WaitObserver& waiting) {
  constexpr std::size_t kRestartsPerPart = 1000;
  const std::size_t most = kRestartsPerPart * (tasks_.size() + frames_of_parts_.size());
  while (done_ < run_.parts) {
    vo::require(run_.restarts <= most, "nodes fail too often: after ", run_.restarts,
                " tasks begun again ", done_, " of ", run_.parts, " parts are done");
    step();
    if (waiting) {
      waiting();
    }
  }
  run_.render_s = now_;
  const auto frames = static_cast<double>(run_.frames);
  run_.mb = frames * options_.frame_mb;
  run_.files = frames * options_.frame_files;
  run_.merge_s = options_.merge_files_per_s > 0 ? run_.files / options_.merge_files_per_s : 0;
  time_of(TimeUse::merge) = run_.merge_s * static_cast<double>(options_.nodes) *
                            static_cast<double>(options_.tasks_per_node());
  for (double& time : run_.processor_s) {
    time *= options_.task_processors;
  }
  return run_;
}

}  // namespace

ClusterRun simulate_cluster(const ClusterOptions& options,
                            const std::vector<std::size_t>& frames_of_parts,
                            const vo::WaitObserver& waiting) {
  return Simulation(options, frames_of_parts).run(waiting);
}

}  // namespace tools
